// SPDX-License-Identifier: Apache-2.0
// Pictures of maps are written with their position on the ground, users' pictures are read as backgrounds.
#include <gdal.h>
#include <gtest/gtest.h>
#include <ogr_srs_api.h>

#include <array>
#include <cmath>
#include <cstdio>

#include "gis/access/gdal_session.h"
#include "gis/crs/crs.h"
#include "gis/crs/crs_transform.h"
#include "gis/raster/picture_file.h"
#include "gis/raster/raster_out.h"
#include "gis/raster/raster_source.h"
#include "support/files.h"
#include "support/problems.h"

namespace frana::gis {
namespace {

const std::string k_utm = "EPSG:32632";

/// Red increases to the east, green to the south; blue is 40.
std::vector<std::uint8_t> gradient(int width, int height) {
    std::vector<std::uint8_t> rgb;
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column)
            for (const int v : {column % 256, row % 256, 40}) rgb.push_back(static_cast<std::uint8_t>(v));
    return rgb;
}

GdalDataset open(const std::string& path) {
    GDALAllRegister();
    return GdalDataset(GDALOpen(path.c_str(), GA_ReadOnly));
}

/// A GeoTIFF of three bytes per pixel.
void write_photo(const std::string& path, int width, int height, std::vector<std::uint8_t> rgb, const Bounds& box,
                 const std::string& crs_wkt) {
    GDALAllRegister();
    const GdalDataset file(GDALCreate(GDALGetDriverByName("GTiff"), path.c_str(), width, height, 3, GDT_Byte, nullptr));
    std::array<double, 6> geo{box.west, box.width() / width, 0, box.north, 0, -box.height() / height};
    GDALSetGeoTransform(file.get(), geo.data());
    GDALSetProjection(file.get(), crs_wkt.c_str());
    ASSERT_EQ(GDALDatasetRasterIO(file.get(), GF_Write, 0, 0, width, height, rgb.data(), width, height, GDT_Byte, 3,
                                  nullptr, 3, 3 * width, 1),
              CE_None);
}

/// A page of A4 in landscape, 842 x 595 points, with a green rectangle.
std::string small_pdf() {
    const std::string drawing = "0 0.5 0 rg 100 100 300 200 re f";
    std::string pdf = "%PDF-1.4\n";
    std::vector<std::size_t> places;
    for (const std::string& object :
         {std::string("<< /Type /Catalog /Pages 2 0 R >>"), std::string("<< /Type /Pages /Kids [3 0 R] /Count 1 >>"),
          std::string("<< /Type /Page /Parent 2 0 R /MediaBox [0 0 842 595] /Contents 4 0 R /Resources << >> >>"),
          "<< /Length " + std::to_string(drawing.size()) + " >>\nstream\n" + drawing + "\nendstream"}) {
        places.push_back(pdf.size());
        pdf += std::to_string(places.size()) + " 0 obj\n" + object + "\nendobj\n";
    }
    const std::size_t table = pdf.size();
    pdf += "xref\n0 5\n0000000000 65535 f \n";
    for (const std::size_t place : places) {
        std::array<char, 24> row{};
        std::snprintf(row.data(), row.size(), "%010zu 00000 n \n", place);
        pdf += row.data();
    }
    return pdf + "trailer\n<< /Size 5 /Root 1 0 R >>\nstartxref\n" + std::to_string(table) + "\n%%EOF\n";
}

TEST(PictureOut, APdfKeepsItsPageAndGetsItsPlace) {
    const test::Folder folder;
    const std::string path = folder.file("map.pdf");
    const PicturePlace place{
        {526000, 5093000, 529508, 5095480}, {526200, 5093200, 528800, 5095300}, crs_from_user(k_utm, "")};
    write_pdf(path, small_pdf(), place);
    EXPECT_EQ(folder.names(), std::vector<std::string>{"map.pdf"});
    const std::string bytes = test::text_in(path);
    EXPECT_EQ(bytes.rfind(small_pdf(), 0), 0U) << "the place is appended";
    EXPECT_GT(bytes.size(), small_pdf().size());
    const GdalDataset file = open(path);
    ASSERT_TRUE(file);
    EXPECT_STREQ(OSRGetAuthorityCode(GDALGetSpatialRef(file.get()), nullptr), "32632");
    std::array<double, 6> geo{};
    ASSERT_EQ(GDALGetGeoTransform(file.get(), geo.data()), CE_None);
    EXPECT_NEAR(geo[0], 526000, 1);  // the format keeps corners in degrees with few digits
    EXPECT_NEAR(geo[3], 5095480, 1);
    EXPECT_NEAR(geo[1] * GDALGetRasterXSize(file.get()), 3508, 2);
    const char* line = GDALGetMetadataItem(file.get(), "NEATLINE", nullptr);
    ASSERT_NE(line, nullptr);
    double west = 0, north = 0;
    ASSERT_EQ(std::sscanf(line, "POLYGON ((%lf %lf", &west, &north), 2) << line;
    EXPECT_NEAR(west, 526200, 1);
    EXPECT_NEAR(north, 5095300, 1);
    write_pdf(folder.file("again.pdf"), small_pdf(), place);
    EXPECT_EQ(bytes, test::text_in(folder.file("again.pdf")));
}

TEST(PictureOut, APdfWithoutPlaceIsWrittenAsItIs) {
    const test::Folder folder;
    write_pdf(folder.file("chart.pdf"), small_pdf(), std::nullopt);
    EXPECT_EQ(test::text_in(folder.file("chart.pdf")), small_pdf());
}

TEST(PictureOut, AFullOrMissingFolderIsReported) {
    const PicturePlace place{
        {526000, 5093000, 529508, 5095480}, {526200, 5093200, 528800, 5095300}, crs_from_user(k_utm, "")};
    for (const auto& where : {std::optional<PicturePlace>(place), std::optional<PicturePlace>()}) {
        const Error error = test::error_of([&] { write_pdf("/nowhere/at/all/map.pdf", small_pdf(), where); });
        EXPECT_EQ(error.kind(), ErrorKind::environment);
    }
}

TEST(PictureIn, APictureInAnotherCrsIsPlacedCorrectly) {
    const test::Folder folder;
    const std::string path = folder.file("ortho.tif");
    // In degrees, 0.00002 per pixel (1.5 m by 2.2 m); red counts columns, green rows.
    const std::string degrees = crs_from_user("EPSG:4326", "");
    const Bounds box{9.348, 45.998, 9.352, 46.002};
    const std::vector<std::uint8_t> rgb = gradient(200, 200);
    write_photo(path, 200, 200, rgb, box, degrees);
    const std::string utm = crs_from_user(k_utm, "");
    const CrsTransform to_degrees(utm, degrees);
    const Point middle = to_degrees.inverse({9.35, 46.0});
    const Bounds window{middle.x - 100, middle.y - 100, middle.x + 100, middle.y + 100};
    const std::vector<std::uint8_t> warped = warp_picture(path, utm, window, 100, 100);
    for (const auto& [column, row] : {std::pair{20, 30}, {50, 50}, {77, 81}}) {
        const Point there = to_degrees({window.west + 2 * (column + 0.5), window.north - 2 * (row + 0.5)});
        const std::uint8_t* p = warped.data() + 4 * (row * 100 + column);
        EXPECT_NEAR(p[0], (there.x - box.west) / 0.00002 - 0.5, 1.5);  // bilinear, GDAL's transformer to 1/8 pixel
        EXPECT_NEAR(p[1], (box.north - there.y) / 0.00002 - 0.5, 1.5);
        EXPECT_NEAR(p[2], 40, 1);
        EXPECT_EQ(p[3], 255);
    }
    // Nothing beyond its edge.
    const std::vector<std::uint8_t> beyond =
        warp_picture(path, utm, {middle.x + 1000, middle.y, middle.x + 1100, middle.y + 100}, 10, 10);
    for (const std::uint8_t value : beyond) EXPECT_EQ(value, 0);
}

TEST(PictureIn, GreyAndPalettesBecomeColours) {
    const test::Folder folder;
    test::TestRaster grey{10, 10, 527000, 5094100, 10, 10, k_utm, std::vector<double>(100, 77), {}, ""};
    grey.bytes = true;
    test::make_raster(folder.file("grey.tif"), grey);
    const Bounds box{527020, 5094020, 527080, 5094080};
    const std::string utm = crs_from_user(k_utm, "");
    EXPECT_EQ(warp_picture(folder.file("grey.tif"), utm, box, 1, 1), (std::vector<std::uint8_t>{77, 77, 77, 255}));
    const Raster classes(GridSpec{527000, 5094100, 10, 10, 10, utm}, 2);
    write_class_geotiff(folder.file("classes.tif"), classes, {{2, "two", {10, 200, 30}}}, {"c", "c", "", {}});
    EXPECT_EQ(warp_picture(folder.file("classes.tif"), utm, box, 1, 1), (std::vector<std::uint8_t>{10, 200, 30, 255}));
}

TEST(PictureIn, UnusableBackgroundsAreRefusedWithTheReason) {
    const test::Folder folder;
    const std::string utm = crs_from_user(k_utm, "");
    const auto reason = [&](const std::string& file) {
        return test::error_of([&] { check_picture(file, utm, "output.map-background"); }).problems();
    };
    const auto where = [&](const char* name) { return "output.map-background: " + folder.file(name); };
    EXPECT_TRUE(has_problem(reason(folder.file("none.tif")), where("none.tif")));
    test::make_raster(folder.file("float.tif"), {10, 10, 0, 0, 1, 1, k_utm, std::vector<double>(100, 7), {}, ""});
    EXPECT_TRUE(has_problem(reason(folder.file("float.tif")), where("float.tif"), "Float64", "Byte"));
    test::TestRaster nowhere{10, 10, 527000, 5094100, 10, 10, "", std::vector<double>(100, 7), {}, ""};
    nowhere.bytes = true;
    test::make_raster(folder.file("nowhere.tif"), nowhere);
    EXPECT_TRUE(has_problem(reason(folder.file("nowhere.tif")), where("nowhere.tif")));
    EXPECT_NE(reason(folder.file("nowhere.tif")).front().remedy.find("-a_srs"), std::string::npos);
}

TEST(RasterText, ClassesAndTextsAreReadBack) {
    const test::Folder folder;
    const Raster classes(GridSpec{527000, 5094100, 10, 10, 10, crs_from_user(k_utm, "")}, 3);
    write_class_geotiff(folder.file("c.tif"), classes, {{1, "weak", {1, 2, 3}}, {3, "strong", {200, 2, 3}}},
                        {"hazard", "Intensity", "", {{"TIME_S", "12.5"}}});
    const RasterText text = read_raster_text(folder.file("c.tif"));
    ASSERT_EQ(text.classes.size(), 2U);
    EXPECT_EQ(text.classes[0].label, "weak");
    EXPECT_EQ(text.classes[1].value, 3);
    EXPECT_EQ(text.classes[1].colour, (Rgb{200, 2, 3}));
    EXPECT_EQ(text.metadata.at("TIME_S"), "12.5");
    EXPECT_NE(text.description.find("Intensity"), std::string::npos);
}

}  // namespace
}  // namespace frana::gis
