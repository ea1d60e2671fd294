// SPDX-License-Identifier: Apache-2.0
// Every kind of broken input ends in one message that names key and file, and nothing is written.
#include <gdal_priv.h>
#include <gdal_utils.h>
#include <ogrsf_frmts.h>

#include <cstring>
#include <filesystem>
#include <limits>

#include "gis/access/gdal_session.h"
#include "support/checked_scene.h"

namespace frana::test {
namespace {

namespace fs = std::filesystem;

/// Changes to the files of a valid scene. Paths are relative to its folder.
class Workshop {
  public:
    explicit Workshop(fs::path folder) : folder_(std::move(folder)) {}

    void write(const std::string& name, const std::string& bytes) const {
        FILE* file = std::fopen((folder_ / name).c_str(), "wb");
        std::fwrite(bytes.data(), 1, bytes.size(), file);
        std::fclose(file);
    }
    [[nodiscard]] std::string bytes(const std::string& name) const { return read_text((folder_ / name).string()); }
    /// The valid DTM in another format.
    void raster(const std::string& driver, const std::string& name, const char* option = nullptr) const {
        const gis::GdalSession session;
        const GDALDatasetUniquePtr from(GDALDataset::Open((folder_ / "dtm.asc").c_str(), GDAL_OF_RASTER));
        const char* options[] = {option, nullptr};
        const GDALDatasetUniquePtr to(
            GetGDALDriverManager()
                ->GetDriverByName(driver.c_str())
                ->CreateCopy((folder_ / name).c_str(), from.get(), 0, const_cast<char**>(options), nullptr, nullptr));
        ASSERT_TRUE(to);
    }
    /// The valid perimeter in another format.
    void vector(const std::string& driver, const std::string& name) const {
        const gis::GdalSession session;
        const GDALDatasetUniquePtr from(GDALDataset::Open((folder_ / "perimeter.geojson").c_str(), GDAL_OF_VECTOR));
        const char* words[] = {"-f", driver.c_str(), nullptr};
        GDALVectorTranslateOptions* options = GDALVectorTranslateOptionsNew(const_cast<char**>(words), nullptr);
        GDALDatasetH source = from.get();
        const GDALDatasetUniquePtr to(GDALDataset::FromHandle(
            GDALVectorTranslate((folder_ / name).c_str(), nullptr, 1, &source, options, nullptr)));
        GDALVectorTranslateOptionsFree(options);
        ASSERT_TRUE(to);
    }
    void remove(const std::string& name) const { fs::remove(folder_ / name); }
    void folder(const std::string& name) const { fs::create_directory(folder_ / name); }
    void cut(const std::string& name, double fraction) const {
        const std::string all = bytes(name);
        write(name, all.substr(0, static_cast<std::size_t>(fraction * static_cast<double>(all.size()))));
    }
    /// Overwrites bytes from an offset (counted from the end if negative).
    void patch(const std::string& name, std::int64_t at, const std::string& with) const {
        std::string all = bytes(name);
        all.replace(static_cast<std::size_t>(at < 0 ? static_cast<std::int64_t>(all.size()) + at : at), with.size(),
                    with);
        write(name, all);
    }
    /// A virtual raster with this geotransform and size over the valid DTM.
    void vrt(const std::string& name, const std::string& geotransform, const std::string& columns = "60",
             const std::string& band =
                 "<VRTRasterBand dataType=\"Float64\" band=\"1\"><SimpleSource>"
                 "<SourceFilename relativeToVRT=\"1\">dtm.asc</SourceFilename><SourceBand>1"
                 "</SourceBand></SimpleSource></VRTRasterBand>") const {
        write(name, "<VRTDataset rasterXSize=\"" + columns + "\" rasterYSize=\"30\"><SRS>EPSG:32632</SRS>" +
                        "<GeoTransform>" + geotransform + "</GeoTransform>" + band + "</VRTDataset>");
    }
    /// A GeoJSON in the scene's CRS with these geometries.
    void geojson(const std::string& name, const std::string& geometry) const {
        write(name,
              R"({"type": "FeatureCollection", "crs": {"type": "name", "properties": {"name": )"
              R"("urn:ogc:def:crs:EPSG::32632"}}, "features": [{"type": "Feature", "properties": {}, "geometry": )" +
                  geometry + "}]}");
    }

  private:
    fs::path folder_;
};

struct BrokenFile {
    std::string name, key, file;
    std::function<void(const Workshop&)> make;
    std::string messages = "";  ///< beside key and file
    std::string before = "";    ///< text before the file's name in the scene
};

class Broken : public CheckedScene {
  protected:
    /// Each in a folder of its own, so that nothing of it is beside the next.
    void expect(const std::vector<BrokenFile>& files_of_one_key) const {
        for (const BrokenFile& broken : files_of_one_key) {
            SCOPED_TRACE(broken.name);
            const std::string folder = broken.name + "/";
            for (const char* file : {"dtm.asc", "dtm.prj", "perimeter.geojson", "scene.ini"}) {
                fs::create_directories(path(folder));
                fs::copy(path(file), path(folder + file));
            }
            broken.make(Workshop(folder_ / broken.name));
            const std::vector<std::string> before = files();
            const std::string value =
                (broken.key == "release.thickness" ? "raster:" : "") + broken.before + broken.file;
            const Checked checked = check({broken.key + "=" + value}, folder + "scene.ini");
            EXPECT_EQ(checked.problems.size(), 1U) << checked.told();
            if (checked.is_refused())
                expect_words(describe(checked.problems.front()), {broken.key, broken.file, broken.messages});
            EXPECT_EQ(files(), before);
            fs::remove_all(path(folder));
        }
    }
};

const std::string k_good = "527000, 5, 0, 5094150, 0, -5";

std::vector<BrokenFile> broken_rasters(const std::string& key) {
    using W = const Workshop&;
    return {
        {"empty", key, "a.tif", [](W w) { w.write("a.tif", ""); }},
        {"text_renamed", key, "a.tif", [](W w) { w.write("a.tif", "Elevations of the slope\n1 2 3\n"); }},
        {"wrong_magic", key, "a.tif",
         [](W w) {
             w.raster("GTiff", "a.tif");
             w.patch("a.tif", 0, "XX*");
         }},
        {"header_alone", key, "a.tif",
         [](W w) {
             w.raster("GTiff", "a.tif");
             w.write("a.tif", w.bytes("a.tif").substr(0, 8));
         }},
        {"truncated", key, "a.tif",
         [](W w) {
             w.raster("GTiff", "a.tif");
             w.cut("a.tif", 0.5);
         }},
        {"truncated_by_a_row", key, "a.tif",
         [](W w) {
             w.raster("GTiff", "a.tif");
             w.write("a.tif", w.bytes("a.tif").substr(0, w.bytes("a.tif").size() - 240));
         }},
        {"corrupt_compression", key, "a.tif",
         [](W w) {
             w.raster("GTiff", "a.tif", "COMPRESS=DEFLATE");
             w.patch("a.tif", -60, std::string(50, '\x5a'));
         }},
        {"no_band", key, "a.vrt", [](W w) { w.vrt("a.vrt", k_good, "60", ""); }},
        {"zero_size", key, "a.vrt", [](W w) { w.vrt("a.vrt", k_good, "0"); }},
        {"negative_size", key, "a.vrt", [](W w) { w.vrt("a.vrt", k_good, "-60"); }},
        {"nan_geotransform", key, "a.vrt", [](W w) { w.vrt("a.vrt", "nan, 5, 0, 5094150, 0, -5"); }},
        {"infinite_geotransform", key, "a.vrt", [](W w) { w.vrt("a.vrt", "527000, 5, 0, inf, 0, -5"); }},
        {"cells_of_nothing", key, "a.vrt", [](W w) { w.vrt("a.vrt", "527000, 0, 0, 5094150, 0, 0"); }},
        {"source_missing", key, "a.vrt",
         [](W w) {
             w.vrt("a.vrt", k_good, "60",
                   "<VRTRasterBand dataType=\"Float64\" band=\"1\"><SimpleSource><SourceFilename>gone.tif"
                   "</SourceFilename></SimpleSource></VRTRasterBand>");
         }},
        {"its_own_source", key, "a.vrt",
         [](W w) {
             w.vrt("a.vrt", k_good, "60",
                   "<VRTRasterBand dataType=\"Float64\" band=\"1\"><SimpleSource><SourceFilename relativeToVRT="
                   "\"1\">a.vrt</SourceFilename></SimpleSource></VRTRasterBand>");
         }},
        {"xml_cut", key, "a.vrt",
         [](W w) {
             w.vrt("a.vrt", k_good);
             w.cut("a.vrt", 0.7);
         }},
        {"complex_numbers", key, "a.vrt",
         [](W w) { w.vrt("a.vrt", k_good, "60", "<VRTRasterBand dataType=\"CFloat32\" band=\"1\"></VRTRasterBand>"); }},
        {"picture", key, "a.vrt",
         [](W w) {
             w.vrt("a.vrt", k_good, "60",
                   "<VRTRasterBand dataType=\"Byte\" "
                   "band=\"1\"><ColorInterp>Red</ColorInterp></VRTRasterBand>");
         }},
        {"huge_header", key, "a.tif",
         [](W w) {
             w.raster("GTiff", "a.tif");
             // The IFD's first entries are ImageWidth (256) and ImageLength (257), as 2 byte values.
             const std::string all = w.bytes("a.tif");
             for (const char tag : {'\x00', '\x01'}) {
                 const std::string entry{tag, '\x01', '\x03', '\x00', '\x01', '\x00', '\x00', '\x00'};
                 const std::size_t at = all.find(entry);
                 ASSERT_NE(at, std::string::npos);
                 w.patch("a.tif", static_cast<std::int64_t>(at),
                         std::string{tag, '\x01', '\x04', '\x00', '\x01', '\x00', '\x00', '\x00', '\xff', '\xff',
                                     '\xff', '\x7f'});
             }
         }},
        {"grid_of_words", key, "a.asc",
         [](W w) {
             std::string text = w.bytes("dtm.asc");
             text.replace(text.find('\n', text.find("NODATA")) + 1, 5, "steep");
             w.write("a.asc", text);
             w.write("a.prj", w.bytes("dtm.prj"));
         }},
        {"grid_cut", key, "a.asc",
         [](W w) {
             w.write("a.asc", w.bytes("dtm.asc"));
             w.cut("a.asc", 0.5);
             w.write("a.prj", w.bytes("dtm.prj"));
         }},
        {"grid_of_negative_size", key, "a.asc",
         [](W w) { w.write("a.asc", "ncols -60\nnrows 30\nxllcorner 0\nyllcorner 0\ncellsize 5\n1 2 3\n"); }},
        {"grid_without_cell_size", key, "a.asc",
         [](W w) { w.write("a.asc", "ncols 3\nnrows 1\nxllcorner 0\nyllcorner 0\n1 2 3\n"); }},
        {"netcdf_garbage", key, "a.nc",
         [](W w) { w.write("a.nc", std::string("CDF\x01", 4) + std::string(300, '\x7e')); }},
        {"hgt_of_no_size", key, "N46E009.hgt", [](W w) { w.write("N46E009.hgt", std::string(1234, '\x01')); }},
        {"zip_garbage", key, "a.zip/a.tif", [](W w) { w.write("a.zip", "PK\x03\x04 and then nothing"); }, "",
         "/vsizip/"},
        {"gzip_garbage", key, "a.tif.gz", [](W w) { w.write("a.tif.gz", "\x1f\x8b\x08 and then nothing"); }, "",
         "/vsigzip/"},
        {"folder", key, "photos", [](W w) { w.folder("photos"); }},
    };
}

TEST_F(Broken, RastersEndInOneClearMessage) {
    for (const std::string key : {"terrain.dtm", "release.thickness"}) expect(broken_rasters(key));
}

/// A little-endian double, as in a shapefile.
std::string double_bytes(double value) {
    std::string bytes(8, '\0');
    std::memcpy(bytes.data(), &value, 8);
    return bytes;
}

std::vector<BrokenFile> broken_vectors(const std::string& key) {
    using W = const Workshop&;
    const auto shape_with = [](const std::function<void(W)>& damage) {
        return [damage](W w) {
            w.vector("ESRI Shapefile", "a.shp");
            damage(w);
        };
    };
    const auto json = [key](const std::string& name, const std::string& geometry, const std::string& messages) {
        return BrokenFile{name, key, "a.geojson", [geometry](W w) { w.geojson("a.geojson", geometry); }, messages};
    };
    return {
        {"empty_shapefile", key, "a.shp", [](W w) { w.write("a.shp", ""); }},
        {"shapefile_garbage", key, "a.shp", [](W w) { w.write("a.shp", std::string(500, '\x33')); }},
        {"shapefile_header_alone", key, "a.shp",
         shape_with([](W w) { w.write("a.shp", w.bytes("a.shp").substr(0, 100)); })},
        {"shapefile_cut", key, "a.shp", shape_with([](W w) { w.cut("a.shp", 0.7); })},
        {"shx_missing", key, "a.shp", shape_with([](W w) { w.remove("a.shx"); })},
        {"shx_garbage", key, "a.shp", shape_with([](W w) { w.write("a.shx", std::string(108, '\x33')); })},
        {"shx_points_nowhere", key, "a.shp", shape_with([](W w) { w.patch("a.shx", 100, "\x7f\xff\xff\x00"); })},
        {"dbf_garbage", key, "a.shp", shape_with([](W w) { w.write("a.dbf", std::string(90, '\x33')); })},
        {"prj_garbage", key, "a.shp", shape_with([](W w) { w.write("a.prj", "somewhere in the Alps"); }),
         "coordinate reference system"},
        {"prj_missing", key, "a.shp", shape_with([](W w) { w.remove("a.prj"); }), "coordinate reference system"},
        {"shape_nan", key, "a.shp",
         shape_with([](W w) { w.patch("a.shp", 156, double_bytes(std::numeric_limits<double>::quiet_NaN())); }),
         "non-finite"},
        {"shape_infinite", key, "a.shp",
         shape_with([](W w) { w.patch("a.shp", 156, double_bytes(std::numeric_limits<double>::infinity())); }),
         "non-finite"},
        {"shape_of_many_points", key, "a.shp",
         shape_with([](W w) { w.patch("a.shp", 148, std::string("\xff\xff\xff\x7f", 4)); })},
        {"geopackage_garbage", key, "a.gpkg",
         [](W w) { w.write("a.gpkg", "SQLite format 3" + std::string(1, '\0') + std::string(2000, '\x33')); }},
        {"geopackage_cut", key, "a.gpkg",
         [](W w) {
             w.vector("GPKG", "a.gpkg");
             w.cut("a.gpkg", 0.4);
         }},
        {"geopackage_without_pages", key, "a.gpkg",
         [](W w) {
             w.vector("GPKG", "a.gpkg");
             w.write("a.gpkg", w.bytes("a.gpkg").substr(0, 4096));
         }},
        {"flatgeobuf_cut", key, "a.fgb",
         [](W w) {
             w.vector("FlatGeobuf", "a.fgb");
             w.cut("a.fgb", 0.6);
         }},
        json("geojson_farther_than_a_map",
             R"({"type": "Polygon", "coordinates": [[[0, 0], [1e200, 0], [1e200, 1e200], [0, 1e200], [0, 0]]]})",
             "non-finite or too large"),
        json("geojson_line_farther_than_a_map",
             R"({"type": "LineString", "coordinates": [[0, 0], [1e200, 0], [1e200, 1e200], [0, 1e200], [0, 0]]})",
             "non-finite or too large"),
        {"geojson_cut", key, "a.geojson",
         [](W w) {
             w.write("a.geojson", w.bytes("perimeter.geojson"));
             w.cut("a.geojson", 0.8);
         }},
        {"geojson_of_words", key, "a.geojson",
         [](W w) { w.write("a.geojson", "{\"type\": \"Feature\", this is not"); }},
        {"kml_cut", key, "a.kml",
         [](W w) {
             w.vector("LIBKML", "a.kml");
             w.cut("a.kml", 0.6);
         }},
        {"csv_bad_wkt", key, "a.csv", [](W w) { w.write("a.csv", "WKT,id\n\"POLYGON((0 0,1 1\",1\n"); }},
        {"csv_without_geometry", key, "a.csv", [](W w) { w.write("a.csv", "name,depth\nslope,2\n"); }},
        {"picture", key, "a.png", [](W w) { w.raster("PNG", "a.png"); }},
        {"raster_in_its_place", key, "dtm.asc", [](W) {}},
        {"zip_garbage", key, "a.zip/a.shp", [](W w) { w.write("a.zip", "PK\x03\x04 and then nothing"); }, "",
         "/vsizip/"},
        {"folder", key, "photos", [](W w) { w.folder("photos"); }},
        json("null_geometry", "null", "no polygon"),
        json("empty_polygon", R"({"type": "Polygon", "coordinates": []})", "no polygon"),
        json("points", R"({"type": "Point", "coordinates": [527040, 5094070]})", ""),
        json("open_line",
             R"({"type": "LineString", "coordinates": [[527020, 5094055], [527070, 5094055], [527070, 5094095]]})",
             "does not close"),
        json("ring_left_open",
             R"({"type": "Polygon", "coordinates": [[[527020, 5094055], [527070, 5094055], [527070, 5094095]]]})",
             "does not close"),
        json("ring_of_two_points", R"({"type": "Polygon", "coordinates": [[[527020, 5094055], [527070, 5094055]]]})",
             ""),
        json("ring_without_area",
             R"({"type": "Polygon", "coordinates": [[[527020, 5094055], [527070, 5094055], [527020, 5094055]]]})", ""),
        json("coordinates_of_words",
             R"({"type": "Polygon", "coordinates": [[["a", "b"], ["c", "d"], ["e", "f"], ["a", "b"]]]})", ""),
        json("coordinate_beyond_doubles",
             R"({"type": "Polygon", "coordinates": [[[1e999, 5094055], [527070, 5094055], [527070, 5094095], )"
             R"([1e999, 5094055]]]})",
             ""),
        json("unknown_geometry", R"({"type": "Blob", "coordinates": [1, 2]})", ""),
    };
}

TEST_F(Broken, VectorsEndInOneClearMessage) {
    expect(broken_vectors("release.perimeter"));
}

}  // namespace
}  // namespace frana::test
