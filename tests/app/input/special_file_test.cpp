// SPDX-License-Identifier: Apache-2.0
// Inputs that are special files, never end, or would do more than contain data; and folders that remain unchanged.
#include <ogrsf_frmts.h>
#include <sys/stat.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>

#include "support/files.h"
#include "support/tiny_scene.h"

namespace frana::test {
namespace {

namespace fs = std::filesystem;

class SpecialFile : public TinyScene {
  protected:
    void SetUp() override { ASSERT_EQ(::mkfifo(path("fifo").c_str(), 0600), 0); }

    /// Refused within seconds, with these words.
    void expect_refused(const std::vector<std::string>& arguments, const std::string& words) const {
        const auto start = std::chrono::steady_clock::now();
        std::vector<std::string> bounded{"check"};
        bounded.insert(bounded.end(), arguments.begin(), arguments.end());
        const Outcome outcome = frana(bounded);
        EXPECT_EQ(outcome.exit_code, 2) << arguments.back() << outcome.err;
        EXPECT_NE(outcome.err.find(words), std::string::npos) << arguments.back() << outcome.err;
        EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(30)) << arguments.back();
    }
};

TEST_F(SpecialFile, IsNoInput) {
    for (const std::string key : {"terrain.dtm", "release.perimeter", "scar.perimeter", "scar.front", "output.gauges",
                                  "output.map-background", "output.map-logo", "terrain.walls"}) {
        expect_refused({"scene.ini", "--set", key + "=" + path("fifo")}, "is not a regular file");
        expect_refused({"scene.ini", "--set", key + "=/dev/zero"}, "is not a regular file");
    }
    expect_refused({"scene.ini", "--set", "release.thickness=raster:" + path("fifo")}, "is not a regular file");
    expect_refused({"scene.ini", "--set", "release.perimeter=/vsistdin/"}, "is not a regular file");
    expect_refused({path("fifo")}, "is not a regular file");
    expect_refused({"/dev/zero"}, "is not a regular file");
    // Named by a file, not by the scene.
    write("in.vrt", "<OGRVRTDataSource><OGRVRTLayer name=\"perimeter\"><SrcDataSource>" + path("fifo") +
                        "</SrcDataSource></OGRVRTLayer></OGRVRTDataSource>");
    expect_refused({"scene.ini", "--set", "release.perimeter=in.vrt"}, "is not a regular file");
}

TEST_F(SpecialFile, IsNoHydrograph) {
    gis::test::make_vector(path("line.gpkg"), "GPKG", "EPSG:32632", {"LINESTRING(527100 5094020,527100 5094100)"});
    for (const std::string& file : {path("fifo"), std::string("/dev/zero")})
        expect_refused({"scene.ini", "--set", "inflow.line=line.gpkg", "--set", "inflow.hydrograph=" + file},
                       "is not a regular file");
}

// A special file with the name of one of frana's lists is detected before it is read.
TEST_F(SpecialFile, IsNoListOfFiles) {
    for (const char* name : {"manifest.json", "summary.json", "being_built.json", "being_replaced.json"}) {
        fs::create_directories(path("other"));
        write("other/scene.ini", "");
        ASSERT_EQ(::mkfifo(path(std::string("other/") + name).c_str(), 0600), 0);
        expect_refused({"scene.ini", "--set", "output.directory=other"}, "is a folder with other files");
        fs::create_directories(path("free.partial"));
        ASSERT_EQ(::mkfifo(path(std::string("free.partial/") + name).c_str(), 0600), 0);
        expect_refused({"scene.ini", "--set", "output.directory=free"}, "was not made by frana");
        for (const char* folder : {"other", "free.partial"}) fs::remove_all(path(folder));
    }
}

TEST_F(SpecialFile, InputsLeaveTheirFolderUnchanged) {
    const std::vector<std::string> square{
        "POLYGON((527020 5094055,527070 5094055,527070 5094095,527020 5094095,527020 5094055))"};
    fs::create_directory(folder_ / "in");
    fs::remove(folder_ / "fifo");
    gis::test::make_vector(path("in/a.gml"), "GML", "EPSG:32632", square);
    fs::remove(folder_ / "in/a.xsd");
    gis::test::make_vector(path("in/a.gpkg"), "GPKG", "EPSG:32632", square);
    gis::test::make_vector(path("in/a.shp"), "ESRI Shapefile", "EPSG:32632", square);
    write_dtm({}, true, "in/dtm.asc");
    const std::vector<std::string> before = files();
    const std::vector<std::string> keys{
        "terrain.dtm=in/dtm.asc", "release.perimeter=in/a.gml", "scar.perimeter=in/a.gpkg", "scar.deposit=in/a.shp",
        "output.maps=off",        "output.animation=off",       "output.frames=off"};
    for (const std::string command : {"check", "run"}) {
        std::vector<std::string> arguments{command, "scene.ini"};
        for (const std::string& key : keys) arguments.insert(arguments.end(), {"--set", key});
        if (command == "run") arguments.insert(arguments.end(), {"--out", path("result")});
        const Outcome outcome = frana(arguments);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        fs::remove_all(folder_ / "result");
        EXPECT_EQ(files(), before) << command;
    }
}

// Reporting each pair would be 44 850 lines.
TEST_F(SpecialFile, EqualPolygonsAreReportedOnceAndCounted) {
    const std::string square = "POLYGON((527020 5094055,527070 5094055,527070 5094095,527020 5094095,527020 5094055))";
    gis::test::make_vector(path("equal.gpkg"), "GPKG", "EPSG:32632", std::vector<std::string>(300, square));
    const Outcome outcome = frana({"check", "scene.ini", "--set", "release.perimeter=equal.gpkg"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_NE(outcome.err.find("and 44 847 more of this kind"), std::string::npos) << outcome.err;
    EXPECT_LT(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 8);
}

TEST_F(SpecialFile, AThousandProblemsAreCountedToo) {
    std::vector<std::string> squares;
    for (int i = 0; i < 1000; ++i) {
        const std::string west = std::to_string(527020 + i % 40), east = west + ".5",
                          south = std::to_string(5094055 + i / 40), north = south + ".5";
        squares.push_back("POLYGON((" + west + " " + south + "," + east + " " + south + "," + east + " " + north + "," +
                          west + " " + north + "," + west + " " + south + "))");
    }
    gis::test::make_vector(path("many.gpkg"), "GPKG", "EPSG:32632", squares);
    const Outcome outcome = frana(
        {"check", "scene.ini", "--set", "release.perimeter=many.gpkg", "--set", "release.thickness=attribute:none"});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_LT(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 60) << outcome.err;
}

TEST_F(SpecialFile, ADamagedBackgroundIsFoundByCheck) {
    gis::test::TestRaster picture;
    picture.columns = 60;
    picture.rows = 30;
    picture.west = k_west;
    picture.north = k_south + 150;
    picture.cell_x = picture.cell_y = 5;
    picture.crs = "EPSG:32632";
    picture.bytes = true;
    for (int i = 0; i < 60 * 30; ++i) picture.values.push_back(i * i % 251);
    gis::test::make_raster(path("photo.tif"), picture);
    EXPECT_EQ(frana({"check", "scene.ini", "--set", "output.map-background=photo.tif"}).exit_code, 0);
    const std::string bytes = read_text(path("photo.tif"));
    write("photo.tif", bytes.substr(0, bytes.size() - 700));
    expect_refused({"scene.ini", "--set", "output.map-background=photo.tif"}, "the picture is damaged");
}

TEST_F(SpecialFile, AFilterWithAQueryIsRefused) {
    gis::test::make_vector(path("a.gpkg"), "GPKG", "EPSG:32632",
                           {"POLYGON((527020 5094055,527070 5094055,527070 5094095,527020 5094095,527020 5094055))"});
    const std::string endless =
        "1 IN (WITH RECURSIVE c(x) AS (SELECT 1 UNION ALL SELECT x+1 FROM c) SELECT x FROM c WHERE x < 0)";
    expect_refused({"scene.ini", "--set", "release.perimeter=a.gpkg", "--set", "release.perimeter-filter=" + endless},
                   "contains a query");
    EXPECT_EQ(frana({"check", "scene.ini", "--set", "release.perimeter=a.gpkg", "--set",
                     "release.perimeter-filter=name <> 'select' AND thick = 10"})
                  .exit_code,
              0);
}

// A user who allows VRTs to run programs in their own work has not allowed those of others.
TEST_F(SpecialFile, AVrtRunsNoProgram) {
    write("own.vrt", "<VRTDataset rasterXSize=\"60\" rasterYSize=\"30\"><SRS>EPSG:32632</SRS><GeoTransform>" +
                         std::to_string(k_west) + ",5,0," + std::to_string(k_south + 150) +
                         ",0,-5</GeoTransform><VRTRasterBand dataType=\"Float32\" band=\"1\" "
                         "subClass=\"VRTDerivedRasterBand\">"
                         "<PixelFunctionType>f</PixelFunctionType><PixelFunctionLanguage>Python</PixelFunctionLanguage>"
                         "<PixelFunctionCode><![CDATA[\ndef f(in_ar, out_ar, *args, **kwargs):\n    open('" +
                         path("ran") +
                         "', 'w')\n    out_ar[:] = 300\n]]></PixelFunctionCode></VRTRasterBand></VRTDataset>");
    ::setenv("GDAL_VRT_ENABLE_PYTHON", "YES", 1);
    EXPECT_EQ(frana({"check", "scene.ini", "--set", "terrain.dtm=own.vrt"}).exit_code, 2);
    ::unsetenv("GDAL_VRT_ENABLE_PYTHON");
    EXPECT_FALSE(fs::exists(folder_ / "ran"));
}

// A library cannot be interrupted; the program can.
TEST_F(SpecialFile, AViewThatNeverEndsIsAborted) {
    const std::string file = path("view.gpkg");
    gis::test::make_vector(file, "GPKG", "EPSG:32632",
                           {"POLYGON((527020 5094055,527070 5094055,527070 5094095,527020 5094095,527020 5094055))"});
    {
        const GDALDatasetUniquePtr dataset(GDALDataset::Open(file.c_str(), GDAL_OF_VECTOR | GDAL_OF_UPDATE));
        ASSERT_TRUE(dataset);
        for (const char* statement :
             {"CREATE VIEW endless AS SELECT x AS fid, (SELECT geom FROM shapes) AS geom FROM (WITH "
              "RECURSIVE c(x) AS "
              "(SELECT 1 UNION ALL SELECT x+1 FROM c) SELECT x FROM c WHERE x < 0)",
              "INSERT INTO gpkg_contents (table_name, data_type, identifier, srs_id) VALUES "
              "('endless', 'features', 'endless', 32632)",
              "INSERT INTO gpkg_geometry_columns VALUES ('endless', 'geom', 'POLYGON', 32632, 0, 0)"})
            dataset->ExecuteSQL(statement, nullptr, nullptr);
    }
    ::setenv("FRANA_READ_SECONDS", "1", 1);
    expect_refused({"scene.ini", "--set", "release.perimeter=view.gpkg|layer=endless"}, "takes too long");
    ::setenv("FRANA_READ_SECONDS", "soon", 1);
    expect_refused({"scene.ini"}, "FRANA_READ_SECONDS");
    ::unsetenv("FRANA_READ_SECONDS");
}

}  // namespace
}  // namespace frana::test
