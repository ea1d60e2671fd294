// SPDX-License-Identifier: Apache-2.0
// Zones that a person edits, and their files as other programs read them.
#include "gis/vector/generalise.h"

#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <memory>
#include <set>

#include "core/raster.h"
#include "gis/raster/footprint.h"
#include "gis/vector/outline_check.h"
#include "gis/vector/vector_out.h"

namespace frana::gis {
namespace {

namespace fs = std::filesystem;

constexpr double k_cell = 2;
const GridSpec k_grid{526000, 5094000, k_cell, 60, 50, ""};

/// Classes 1 to 3 in a tongue with ragged edges, a spur and a gap of one cell, an island and a hole of one cell.
Raster classes() {
    Raster all(k_grid, k_no_data);
    for (std::int64_t row = 0; row < k_grid.rows; ++row)
        for (std::int64_t column = 0; column < k_grid.columns; ++column) {
            const auto away = std::abs(row - 25) + (row * 7 + column * 3) % 3, to_end = 45 - column;
            if (column >= 5 && to_end > 0 && away < 15) all.at(row, column) = away < 4 ? 3 : away < 9 ? 2 : 1;
        }
    for (std::int64_t column = 45; column < 57; ++column) all.at(25, column) = 3;  // a spur
    for (std::int64_t row = 5; row < 45; ++row)
        if (!std::isnan(all.at(row, 20))) all.at(row, 20) = 1;  // a gap in the higher ones
    all.at(2, 2) = 2;
    all.at(25, 30) = k_no_data;
    return all;
}

std::vector<MultiPolygon> at_least(const Raster& all) {
    std::vector<MultiPolygon> outlines;
    for (int least = 1; least <= 3; ++least) {
        Raster mask(all.grid);
        for (std::size_t cell = 0; cell < all.values.size(); ++cell) mask.values[cell] = all.values[cell] >= least;
        outlines.push_back(polygonise(mask));
    }
    return outlines;
}

std::unique_ptr<OGRGeometry> buffered(const Polygon& part, double distance) {
    return std::unique_ptr<OGRGeometry>(to_ogr(part)->Buffer(distance));
}

double common_area(const MultiPolygon& a, const MultiPolygon& b) {
    const std::unique_ptr<OGRGeometry> both(to_ogr(a)->Intersection(to_ogr(b).get()));
    return OGR_G_Area(OGRGeometry::ToHandle(both.get()));
}

TEST(Generalise, ZonesAreWideLargeValidAndBesideEachOther) {
    const std::vector<MultiPolygon> cells = at_least(classes());
    const LeastZone least{200, 6, k_cell / 1.5};
    const std::vector<MultiPolygon> zones = generalised(cells, least);
    ASSERT_EQ(zones.size(), 3U);
    double sum = 0;
    for (std::size_t i = 0; i < zones.size(); ++i) {
        ASSERT_FALSE(zones[i].empty()) << i;
        sum += area(zones[i]);
        for (const Polygon& part : zones[i]) {
            EXPECT_TRUE(to_ogr(part)->IsValid());
            EXPECT_GE(area(part), least.area);
            EXPECT_FALSE(buffered(part, -least.width / 2 + least.tolerance)->IsEmpty()) << i;
            for (const Ring& hole : part.holes) EXPECT_GE(area(hole), least.area);
        }
        for (std::size_t j = 0; j < i; ++j) {
            EXPECT_LT(common_area(zones[i], zones[j]), 1e-6) << "rounding of common corners";
        }
    }
    // One area without gaps: its outline has no holes, and it is nearly that of the cells.
    std::unique_ptr<OGRGeometry> all(new OGRMultiPolygon);
    for (const MultiPolygon& zone : zones) all.reset(all->Union(to_ogr(zone).get()));
    ASSERT_EQ(polygon_parts(*all).polygons.size(), 1U);
    for (int i = 0; i < polygon_parts(*all).polygons[0]->getNumInteriorRings(); ++i)
        EXPECT_LT(polygon_parts(*all).polygons[0]->getInteriorRing(i)->get_Area(), 1e-6)
            << "rounding of common corners";
    EXPECT_NEAR(polygon_parts(*all).polygons[0]->get_Area(), sum, 1e-6);
    EXPECT_NEAR(sum / area(cells[0]), 1, 0.05);
    // The spur and the island went, the gap closed, the hole is filled.
    EXPECT_FALSE(contains(zones[2], {526000 + 53 * k_cell, 5094000 - 25.5 * k_cell}));
    EXPECT_FALSE(contains(zones[1], {526000 + 2.5 * k_cell, 5094000 - 2.5 * k_cell}));
    EXPECT_TRUE(contains(zones[2], {526000 + 20.5 * k_cell, 5094000 - 25.5 * k_cell}));
    EXPECT_TRUE(contains(zones[2], {526000 + 30.5 * k_cell, 5094000 - 25.5 * k_cell}));
}

// Patches of three classes, one of them without a cell of its own in every third raster: no zone is smaller than the
// least, none lies where its class is not, none over another.
TEST(Generalise, NoZoneIsSmallOrOfAClassThatIsNotThere) {
    const LeastZone least{200, 6, k_cell / 1.5};
    std::uint32_t state = 1;
    for (int trial = 0; trial < 12; ++trial) {
        Raster all(k_grid, k_no_data);
        for (int patch = 0; patch < 12; ++patch) {
            const auto next = [&](std::uint32_t n) { return (state = state * 1664525U + 1013904223U) / 65536U % n; };
            const std::int64_t row = next(50), column = next(60), high = 2 + next(14), wide = 2 + next(14);
            const int kind = trial % 3 == 0 ? 2 + static_cast<int>(next(2)) : 1 + static_cast<int>(next(3));
            for (std::int64_t r = row; r < std::min<std::int64_t>(50, row + high); ++r)
                for (std::int64_t c = column; c < std::min<std::int64_t>(60, column + wide); ++c) all.at(r, c) = kind;
        }
        const std::vector<MultiPolygon> zones = generalised(at_least(all), least);
        ASSERT_EQ(zones.size(), 3U);
        for (std::size_t i = 0; i < 3; ++i) {
            for (const Polygon& part : zones[i]) {
                EXPECT_GE(area(part), least.area) << trial << ' ' << i;
                EXPECT_TRUE(to_ogr(part)->IsValid());
            }
            for (std::size_t j = 0; j < i; ++j) EXPECT_LT(common_area(zones[i], zones[j]), 1e-5) << trial;
        }
        if (trial % 3 == 0) {
            EXPECT_TRUE(zones[0].empty()) << trial << ": no cell is of this class";
        }
    }
}

TEST(Generalise, WithoutLimitsTheZonesAreTheCells) {
    const Raster all = classes();
    const std::vector<MultiPolygon> zones = generalised(at_least(all), {0, 0, 0});
    ASSERT_EQ(zones.size(), 3U);
    for (int kind = 1; kind <= 3; ++kind) {
        double cells = 0;
        for (std::size_t cell = 0; cell < all.values.size(); ++cell) cells += all.values[cell] == kind;
        EXPECT_NEAR(area(zones[static_cast<std::size_t>(kind - 1)]), cells * k_cell * k_cell, 1e-6) << kind;
    }
}

TEST(Generalise, NothingIsNoZone) {
    const std::vector<MultiPolygon> zones = generalised({{}, {}}, {200, 5, 1});
    ASSERT_EQ(zones.size(), 2U);
    EXPECT_TRUE(zones[0].empty() && zones[1].empty());
}

class Exchange : public testing::Test {
  protected:
    Exchange() { fs::create_directories(folder_); }
    ~Exchange() override { fs::remove_all(folder_); }
    [[nodiscard]] std::string path(const std::string& name) const { return (folder_ / name).string(); }

    /// A square of 100 m with a hole of 20 m, and another square; with umlauts.
    static std::vector<Zone> zones() {
        const auto square = [](double west, double south, double side) {
            return corners({west, south, west + side, south + side});
        };
        Zone one, two;
        one.name = "Mittlere Intensität";
        one.colour = {65, 158, 90};
        one.feature.shape.areas = {{square(526000, 5094000, 100), {square(526040, 5094040, 20)}}};
        one.feature.numbers = {{"class", 2}, {"cells_m2", 9500}};
        one.feature.texts = {{"name", one.name}, {"thresholds", "Tiefe ≤ 1 m"}};
        two = one;
        two.name = "Strenge Gefährdung";
        two.feature.shape.areas = {{square(526200, 5094000, 50), {}}};
        two.feature.numbers["class"] = 3;
        two.feature.texts["name"] = two.name;
        return {one, two};
    }

    fs::path folder_ = fs::temp_directory_path() / ("frana_exchange_" + std::to_string(::getpid()));
};

std::string wkt() {
    OGRSpatialReference crs;
    crs.importFromEPSG(32632);
    char* text = nullptr;
    crs.exportToWkt(&text);
    const std::string copy = text;
    CPLFree(text);
    return copy;
}

GDALDatasetUniquePtr opened(const std::string& path) {
    GDALAllRegister();
    return GDALDatasetUniquePtr(GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR));
}

TEST_F(Exchange, ShapefileHasPolygonsAndTexts) {
    write_zones(path("zones.shp"), wkt(), zones());
    for (const char* ending : k_shapefile_endings)
        EXPECT_TRUE(fs::exists(path(std::string("zones") + ending))) << ending;
    const auto file = opened(path("zones.shp"));
    ASSERT_TRUE(file);
    OGRLayer& layer = *file->GetLayer(0);
    ASSERT_EQ(layer.GetFeatureCount(), 2);
    ASSERT_NE(layer.GetSpatialRef(), nullptr);
    EXPECT_STREQ(layer.GetSpatialRef()->GetAuthorityCode(nullptr), "32632");
    const std::unique_ptr<OGRFeature> first(layer.GetNextFeature());
    EXPECT_EQ(first->GetFieldAsDouble("class"), 2);
    EXPECT_EQ(first->GetFieldAsDouble("cells_m2"), 9500);
    EXPECT_STREQ(first->GetFieldAsString("name"), "Mittlere Intensität");
    EXPECT_STREQ(first->GetFieldAsString("thresholds"), "Tiefe ≤ 1 m");
    EXPECT_NEAR(OGR_G_Area(OGRGeometry::ToHandle(first->GetGeometryRef())), 100 * 100 - 20 * 20, 1e-6);
}

TEST_F(Exchange, KmzIsInDegreesOfTheEarth) {
    write_zones(path("zones.kmz"), wkt(), zones());
    const auto file = opened(path("zones.kmz"));
    ASSERT_TRUE(file);
    OGRLayer& layer = *file->GetLayer(0);
    ASSERT_EQ(layer.GetFeatureCount(), 2);
    const std::unique_ptr<OGRFeature> first(layer.GetNextFeature());
    EXPECT_STREQ(first->GetFieldAsString("Name"), "Mittlere Intensität");
    EXPECT_STREQ(first->GetFieldAsString("thresholds"), "Tiefe ≤ 1 m");
    std::unique_ptr<OGRGeometry> shape(first->GetGeometryRef()->clone());
    OGREnvelope box;
    shape->getEnvelope(&box);
    // 526 000, 5 094 000 of UTM 32 north is 9.337 degrees east, 45.998 north (PROJ's cs2cs).
    EXPECT_NEAR(box.MinX, 9.337, 0.002);
    EXPECT_NEAR(box.MinY, 45.998, 0.002);
    OGRSpatialReference degrees, metres;
    degrees.importFromEPSG(4326);
    metres.importFromEPSG(32632);
    for (OGRSpatialReference* crs : {&degrees, &metres}) crs->SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    const std::unique_ptr<OGRCoordinateTransformation> back(OGRCreateCoordinateTransformation(&degrees, &metres));
    ASSERT_EQ(shape->transform(back.get()), OGRERR_NONE);
    EXPECT_NEAR(OGR_G_Area(OGRGeometry::ToHandle(shape.get())), 9600, 1) << "places have 15 digits, areas bend";
}

TEST_F(Exchange, DxfHasClosedLinesOnALayerOfEachClass) {
    write_zones(path("zones.dxf"), wkt(), zones());
    const auto file = opened(path("zones.dxf"));
    ASSERT_TRUE(file);
    double sum = 0;
    std::set<std::string> layers;
    int lines = 0;
    for (const auto& feature : *file->GetLayer(0)) {
        const OGRLineString& line = *feature->GetGeometryRef()->toLineString();
        EXPECT_TRUE(line.get_IsClosed());
        layers.insert(feature->GetFieldAsString("Layer"));
        ++lines;
        OGREnvelope box;
        line.getEnvelope(&box);
        sum += (box.MaxX - box.MinX) * (box.MaxY - box.MinY);
    }
    EXPECT_EQ(lines, 3) << "one with its hole, and the other";
    EXPECT_NEAR(sum, 10000 + 400 + 2500, 1e-6);
    EXPECT_EQ(layers, (std::set<std::string>{"Mittlere Intensität", "Strenge Gefährdung"}));
}

}  // namespace
}  // namespace frana::gis
