// SPDX-License-Identifier: Apache-2.0
// What a scene is refused for: the one problem of each, with its place, value, limit and remedy. The program prints
// them (InTheProgram); here they are compared without starting it.
#include <ogrsf_frmts.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "app/store/result_directory.h"
#include "support/checked_scene.h"
#include "support/files.h"
#include "support/problems.h"

namespace frana::test {
namespace {

namespace fs = std::filesystem;

/// A change to a valid scene that makes one problem: a line of refusals.tsv. FRANA_WRITE_REFUSALS=1 writes the problems
/// that are found; read the difference then.
struct Refusal {
    std::string name, scene, lines, sets, where, what, value, limit, remedy;

    [[nodiscard]] auto members() {
        return std::array{&name, &scene, &lines, &sets, &where, &what, &value, &limit, &remedy};
    }
};
const std::string k_table = FRANA_SOURCE_DIR "/tests/app/input/refusals.tsv";

/// Text of the table with its line ends, and back.
std::string exchanged(std::string text, const std::string& from, const std::string& to) {
    for (std::size_t at = 0; (at = text.find(from, at)) != text.npos; at += to.size())
        text.replace(at, from.size(), to);
    return text;
}

std::vector<Refusal> read_table() {
    std::vector<Refusal> rows;
    std::istringstream lines(read_text(k_table));
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("#")) continue;
        Refusal& row = rows.emplace_back();
        std::istringstream cells(line);
        for (std::string* member : row.members()) {
            std::getline(cells, *member, '\t');
            *member = exchanged(*member, "\\n", "\n");
        }
    }
    return rows;
}

class Refused : public CheckedScene {
  protected:
    Refused() {
        write("empty.geojson", R"({"type": "FeatureCollection", "features": []})");
        write_places();
        write_rasters();
        write_hydrographs();
        write("structured.ini",
              "[terrain]\ndtm = dtm.asc\n[release]\nperimeter = perimeter.geojson\nthickness = 2\n[material]\n"
              "model = structured\n[structured]\nphases = solids-and-fluid\ncohesion = 1e6\n"
              "internal-friction-angle = 28\nbed-friction-angle = 12\nyoung-modulus = 1e6\nbulk-modulus = 1e6\n"
              "[numerics]\nparticles-per-cell = 9\n[time]\nend = 0.2\n" +
                  k_numbers_only);
        write("fluid.ini",
              "[terrain]\ndtm = dtm.asc\n[release]\nperimeter = perimeter.geojson\nthickness = 2\n[material]\n"
              "model = structured\n[structured]\nphases = fluid\nmanning = 0.05\n[time]\nend = 20\n");
        write("wrong.ini", own_scheme("depth > ", "1 m", "2 m") + "foreground = red\n");
        fs::create_directory(path("a #b"));
        write_dtm({}, true, "a #b/dtm.asc");
        EXPECT_EQ(::mkfifo(path("fifo").c_str(), 0600), 0);
    }
    /// The whole height of the map between two eastings.
    static TestFeature strip(double west, double east, const std::string& properties) {
        return {"Polygon", box(west, 5, east, 145), properties};
    }
    void write_places() const {
        write_features("line", {{"LineString", {{30, 60}, {30, 90}}}});
        write_features("far_line", {{"LineString", {{30, 60}, {30, 990}}}});
        write_features("exposed", {{"Point", {{92, 73}}, R"("what": "house", "people": 7)"}});
        write_polygon("zone", {{100, 10}, {200, 10}, {200, 140}, {100, 140}});
        write_polygon("half", {{100, 10}, {400, 10}, {400, 140}, {100, 140}});
        write_polygon("house", {{30, 60}, {50, 60}, {50, 80}, {30, 80}});
        write_polygon("far", {{1020, 55}, {1070, 55}, {1070, 95}});
        write_polygon("crossing", {{20, 55}, {70, 95}, {70, 55}, {20, 95}});
        write_features("halves", {strip(0, 45, R"("c": 0, "alpha": 0.4)"), strip(45, 90, R"("c": 1e6, "alpha": 0.6)")});
        write_features("west", {strip(0, 45, R"("c": 1e4)")});
        write_features("partly",
                       {strip(0, 30, R"("c": 1e4)"), strip(30, 60, R"("c": null)"), strip(60, 90, R"("d": 1)")});
        write_features("mu", {strip(0, 300, R"("mu": 1.2)")});
        const std::string square =
            "\"POLYGON((527100 5094010,527200 5094010,527200 5094140,527100 5094140,527100 5094010))\"";
        write("phi.csv", "WKT,phi\n" + square + ",0.32\n");
        write("comma.csv", "WKT,phi\n" + square + ",12,5\n");
        write("phi.vrt",
              "<OGRVRTDataSource><OGRVRTLayer name=\"phi\"><SrcDataSource>" + path("phi.csv") +
                  "</SrcDataSource><LayerSRS>EPSG:32632</LayerSRS><Field name=\"phi\" src=\"phi\" type=\"Real\"/>"
                  "</OGRVRTLayer></OGRVRTDataSource>");
        write("pipe.vrt", "<OGRVRTDataSource><OGRVRTLayer name=\"perimeter\"><SrcDataSource>" + path("fifo") +
                              "</SrcDataSource></OGRVRTLayer></OGRVRTDataSource>");
    }
    void write_rasters() const {
        const auto slope = [](int column) { return 300 - 0.5 * std::min((column + 0.5) * k_cell, 200.0); };
        write_dtm({}, false, "plain.asc");
        write_dtm([=](int row, int column) { return row == 20 && column == 40 ? 1e38 : slope(column); }, true,
                  "beyond.asc");
        write_dtm([=](int, int column) { return slope(column) - 900; }, true, "below.asc");
        // Row 14 spans y = 75 to 80 m, column 8 spans x = 40 to 45 m: inside the release.
        write_dtm([](int row, int column) { return row == 14 && column == 8 ? -9999.0 : 300 - 2.5 * column; }, true,
                  "gap.asc");
        write_dtm({}, true, "before.asc");
        write_dtm([=](int, int column) { return slope(column) - (column < 20 ? 2 : 0); }, true, "after.asc");
        for (const auto& [name, value] :
             {std::pair{"one", 1.0}, {"hole", -0.5}, {"minus", -1.0}, {"high", 9999.0}, {"phi", 0.32}})
            write_dtm([value = value](int, int) { return value; }, true, std::string(name) + ".asc");
    }
    void write_hydrographs() const {
        write("good.csv", "time,discharge,velocity\n0,10,2\n5,10,2\n");
        write("back.csv", "time,discharge,velocity\n0,10,2\n5,10,2\n4,10,2\n");
        write("words.csv", "time,discharge,velocity\n0,10,2\n5,ten,2\n");
        write("still.csv", "time,discharge,velocity\n0,10,0\n5,10,0\n");
        write("shrink.csv", "time,volume\n0,10\n5,8\n");
        write("comma_flow.csv", "time,discharge\n0,1\n12,5,500\n");
        write("semicolons.csv", "time;discharge\n0;1\n12;5;500\n");
        write("thousands.csv", "time,volume_1000m3\n0,0\n3,7\n");
        write("days.csv", "time_d,discharge\n0,1\n3,7\n");
        write("hours.csv", "time,discharge_m3/h\n0,1\n3,7\n");
        write("knots.csv", "time,discharge,velocity_kn\n0,1,1\n3,7,1\n");
        write("late.csv", "time,discharge\n5,1\n9,2\n");
        write("rain_ends.csv", "time,raster\n0,one.asc\n");
        write("rain_lost.csv", "time,raster\n0,none.asc\n9,\n");
        write("rain_stays.csv", "time,raster\n5,one.asc\n5,\n");
        write("rain_timeless.csv", "raster\none.asc\n");
        write("drizzle.csv", "time_h,rain\n0,1e-5\n3,2e-5\n");
        write("drought.csv", "time_h,rain_mm/h\n0,0\n3,0\n");
        write("melts.csv", "time,depth\n0,10\n5,8\n");
        write("dry.csv", "time,discharge\n0,0\n7,0\n9,2\n");
    }
    /// The parts of a problem without the test's folder.
    [[nodiscard]] Refusal with(Refusal row, const Problem& found) const {
        const auto plain = [&](const std::string& text) { return exchanged(text, folder_.string(), "..."); };
        row.where = plain(found.where.text);
        row.what = plain(found.what);
        row.value = plain(found.value);
        row.limit = plain(found.limit);
        row.remedy = plain(found.remedy);
        return row;
    }
};

TEST_F(Refused, ForOneProblemEachWithNothingWritten) {
    const std::vector<std::string> before = files();
    std::string table = read_text(k_table).substr(0, read_text(k_table).find('\n') + 1);
    for (Refusal& row : read_table()) {
        SCOPED_TRACE(row.name);
        write_scene(row.lines);
        Sets sets;
        for (std::size_t at = 0, end = 0; at < row.sets.size(); at = end + 3) {
            end = std::min(row.sets.find(" ; ", at), row.sets.size());
            sets.push_back(row.sets.substr(at, end - at));
        }
        const Checked checked = check(sets, row.scene);
        if (checked.problems.size() != 1) {
            ADD_FAILURE() << checked.problems.size() << " problems:\n" << checked.told();
            continue;
        }
        Refusal found = with(row, checked.problems.front());
        EXPECT_EQ(found.where, row.where);
        EXPECT_EQ(found.what, row.what);
        EXPECT_EQ(found.value, row.value);
        EXPECT_EQ(found.limit, row.limit);
        EXPECT_EQ(found.remedy, row.remedy);
        for (const std::string* member : found.members())
            table += exchanged(*member, "\n", "\\n") + (member == &found.remedy ? '\n' : '\t');
    }
    EXPECT_EQ(files(), before);
    if (std::getenv("FRANA_WRITE_REFUSALS") != nullptr) std::ofstream(k_table) << table;
}

// A special file with the name of one of frana's lists is detected before it is read.
TEST_F(Refused, APipeInTheResultsPlace) {
    for (const char* name : {"manifest.json", "summary.json", "being_built.json", "being_replaced.json"}) {
        write("other/scene.ini", "");
        ASSERT_EQ(::mkfifo(path(std::string("other/") + name).c_str(), 0600), 0);
        fs::create_directories(path("free.partial"));
        ASSERT_EQ(::mkfifo(path(std::string("free.partial/") + name).c_str(), 0600), 0);
        for (const auto& [folder, place] : {std::pair{"other", "other"}, {"free", "free.partial"}}) {
            Problems problems;
            EXPECT_FALSE(app::check_result_directory(path(folder), app::Older::unknown, {}, "--out", problems));
            ASSERT_EQ(problems.list().size(), 1U) << name;
            EXPECT_TRUE(has_problem(problems.list(), folder == std::string("other") ? "--out" : place)) << name;
        }
        for (const char* folder : {"other", "free.partial"}) fs::remove_all(path(folder));
    }
}

TEST_F(Refused, EveryProblemInOnePass) {
    write_scene("[numerics]\nclf = 0.4\n[output]\ntrace-threshold = deep\n");
    const std::vector<Problem> problems = check({"terrain.dtm=none.tif", "scar.perimeter=nowhere.shp"}).problems;
    EXPECT_EQ(problems.size(), 4U);
    EXPECT_TRUE(has_problem(problems, "scene.ini: numerics.clf"));
    EXPECT_TRUE(has_problem(problems, "output.trace-threshold", "deep"));
    EXPECT_TRUE(has_problem(problems, "--set terrain.dtm", path("none.tif")));
    EXPECT_TRUE(has_problem(problems, "nowhere.shp"));
}

TEST_F(Refused, SolidsWithoutStrengthAndKeysOfTheOtherModel) {
    const std::vector<Problem> weak = check({"structured.phases=solids-and-fluid"}, "fluid.ini").problems;
    for (const char* key : {"structured.cohesion", "structured.internal-friction-angle", "numerics.particles-per-cell"})
        EXPECT_TRUE(has_problem(weak, key)) << key;
    const std::vector<Problem> other =
        check({"material.friction-angle=20", "numerics.scheme=paper", "entrainment.erosion=growth"}, "fluid.ini")
            .problems;
    EXPECT_EQ(other.size(), 3U);
    for (const char* key : {"material.friction-angle", "numerics.scheme", "entrainment.erosion"})
        EXPECT_TRUE(has_problem(other, key)) << key;
    write_scene();
    EXPECT_TRUE(has_problem(check({"material.model=structured"}).problems, "structured.phases"));
}

TEST_F(Refused, MapsThatNoRasterIsMadeFor) {
    write_scene("[output]\nmaps = max_depth, solid_depth, max_depth_3d, hazard\n");
    const std::vector<Problem> problems = check().problems;
    EXPECT_EQ(problems.size(), 2U);
    EXPECT_TRUE(has_problem(problems, "output.maps", "solid_depth"));
    EXPECT_TRUE(has_problem(problems, "output.maps", "hazard"));
}

/// Both columns are missing: both are reported.
TEST_F(Refused, AHydrographWithoutItsColumns) {
    write("heads.csv", "t,q\n0,10\n5,10\n");
    write_scene("[inflow]\nline = line.geojson\nhydrograph = heads.csv\n");
    expect_words(check().told(), {"no column time", "neither a column discharge nor volume"});
}

// Three polygons, of which one has a number in another column and none in that of the key.
TEST_F(Refused, AColumnThatNoPolygonHasANumberIn) {
    write_features("many",
                   {strip(20, 30, R"("dicke": null, "title": "A")"), strip(40, 50, R"("dicke": 2, "title": "B")"),
                    strip(60, 70, R"("dicke": null, "title": "C")")});
    const auto of = [&](const std::string& column) {
        const std::vector<Problem> problems =
            check({"release.perimeter=many.geojson", "release.thickness=attribute:" + column}).problems;
        EXPECT_EQ(problems.size(), 1U) << column;
        return describe(problems.front());
    };
    for (const std::string column : {"Dicke_m", "title"})
        expect_words(of(column), {"no number in the attribute " + column + " of any feature of many",
                                  "attributes with numbers: dicke)"});
    expect_words(of("title"), {"finds text"});
    expect_words(of("dicke"), {"is empty (NULL) in the attribute dicke of 2 of 3 features"});
}

// Reporting each pair would be 44 850 lines.
TEST_F(Refused, EqualPolygonsAreReportedOnce) {
    const std::string square = "POLYGON((527020 5094055,527070 5094055,527070 5094095,527020 5094095,527020 5094055))";
    gis::test::make_vector(path("equal.gpkg"), "GPKG", "EPSG:32632", std::vector<std::string>(300, square));
    const Checked checked = check({"release.perimeter=equal.gpkg"});
    EXPECT_FALSE(checked.is_refused());
    EXPECT_LT(checked.warnings.size(), 4U);
    expect_words(checked.told(), {"polygons of the perimeter overlap", "cells: 80 ("});
}

TEST_F(Refused, WithTheValueThatIsMeantItCanRun) {
    for (const Sets& sets :
         std::vector<Sets>{{"terrain.dtm=plain.asc", "terrain.dtm-crs=EPSG:32632"},
                           {"terrain.dtm=plain.asc", "terrain.crs=local"},
                           {"terrain.dtm=gap.asc", "terrain.nodata-policy=fill"},
                           {"terrain.dtm=beyond.asc", "terrain.nodata-value=1e38"},
                           {"terrain.dtm=beyond.asc", "terrain.bounds=527000 5094000 527150 5094150"},
                           {"material.friction-angle=0"},
                           {"material.friction-angle=1"},
                           {"release.perimeter-filter=depth = 2 AND 'select' <> 'x'"}}) {
        const Checked checked = check(sets);
        EXPECT_FALSE(checked.is_refused()) << sets.front() << ' ' << sets.back() << '\n' << checked.told();
    }
}

TEST_F(Refused, ADamagedBackground) {
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
    EXPECT_FALSE(check({"output.map-background=photo.tif"}).is_refused());
    const std::string bytes = read_text(path("photo.tif"));
    write("photo.tif", bytes.substr(0, bytes.size() - 700));
    expect_words(check({"output.map-background=photo.tif"}).told(),
                 {"output.map-background", "the picture is damaged"});
}

// A user who allows VRTs to run programs in their own work has not allowed those of others.
TEST_F(Refused, AVrtRunsNoProgram) {
    write("own.vrt", "<VRTDataset rasterXSize=\"60\" rasterYSize=\"30\"><SRS>EPSG:32632</SRS><GeoTransform>" +
                         std::to_string(k_west) + ",5,0," + std::to_string(k_south + 150) +
                         ",0,-5</GeoTransform><VRTRasterBand dataType=\"Float32\" band=\"1\" "
                         "subClass=\"VRTDerivedRasterBand\">"
                         "<PixelFunctionType>f</PixelFunctionType><PixelFunctionLanguage>Python</PixelFunctionLanguage>"
                         "<PixelFunctionCode><![CDATA[\ndef f(in_ar, out_ar, *args, **kwargs):\n    open('" +
                         path("ran") +
                         "', 'w')\n    out_ar[:] = 300\n]]></PixelFunctionCode></VRTRasterBand></VRTDataset>");
    ::setenv("GDAL_VRT_ENABLE_PYTHON", "YES", 1);
    refusal_of(frana({"check", "scene.ini", "--set", "terrain.dtm=own.vrt"}));
    ::unsetenv("GDAL_VRT_ENABLE_PYTHON");
    EXPECT_FALSE(fs::exists(folder_ / "ran"));
}

// A library cannot be interrupted; the program can.
TEST_F(Refused, AViewThatNeverEndsIsAborted) {
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
    const Outcome aborted = frana({"check", "scene.ini", "--set", "release.perimeter=view.gpkg|layer=endless"});
    ::setenv("FRANA_READ_SECONDS", "soon", 1);
    const Outcome wrong = frana({"check", "scene.ini"});
    ::unsetenv("FRANA_READ_SECONDS");
    EXPECT_EQ(aborted.exit_code, 2);
    expect_words(aborted.err, {"takes too long"});
    EXPECT_EQ(wrong.exit_code, 2);
    expect_words(wrong.err, {"FRANA_READ_SECONDS"});
}

/// The program prints what is refused, in one message, and writes nothing.
TEST_F(Refused, InTheProgram) {
    const std::vector<std::string> before = files();
    const auto refused = [&](const std::vector<std::string>& arguments, const std::vector<std::string>& words) {
        const Outcome outcome = refusal_of(frana(arguments));
        EXPECT_EQ(outcome.out, "");
        EXPECT_EQ(outcome.err.rfind("frana: ", 0), 0U) << outcome.err;
        expect_words(outcome.err, words);
    };
    for (const std::string command : {"run", "check"})
        refused({command, "scene.ini", "--set", "numerics.clf=0.4"}, {"--set numerics.clf", "numerics.cfl?"});
    refused({"run", "scene.ini", "--set", "terrain.dtm=none.tif", "--set", "time.end=0"}, {"frana: 2 problems:\n"});
    // Nobody can create a folder below a file, not even root.
    refused({"run", "scene.ini", "--out", "scene.ini/result"}, {"--out: cannot be written"});
    refused({"run", "scene.ini", "--out", "scene.ini"}, {"is a file, not a folder"});
    fs::create_directory(folder_ / "two\nlines");
    for (const std::string name : {"dtm.asc", "dtm.prj", "perimeter.geojson", "scene.ini"})
        fs::copy(folder_ / name, folder_ / "two\nlines" / name);
    refused({"run", "two\nlines/scene.ini", "--out", "result"}, {"two?lines/scene.ini", "line break"});
    fs::remove_all(folder_ / "two\nlines");
    EXPECT_EQ(files(), before);
    // A thousand problems are counted.
    std::vector<std::string> squares;
    for (int i = 0; i < 1000; ++i) {
        const std::string west = std::to_string(527020 + i % 40), east = west + ".5",
                          south = std::to_string(5094055 + i / 40), north = south + ".5";
        squares.push_back("POLYGON((" + west + " " + south + "," + east + " " + south + "," + east + " " + north + "," +
                          west + " " + north + "," + west + " " + south + "))");
    }
    gis::test::make_vector(path("many.gpkg"), "GPKG", "EPSG:32632", squares);
    const Outcome many = refusal_of(frana(
        {"check", "scene.ini", "--set", "release.perimeter=many.gpkg", "--set", "release.thickness=attribute:none"}));
    EXPECT_LT(std::count(many.err.begin(), many.err.end(), '\n'), 60) << many.err;
}

}  // namespace
}  // namespace frana::test
