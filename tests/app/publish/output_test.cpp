// SPDX-License-Identifier: Apache-2.0
// The outputs of a run, file by file.
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>
#include <stdexcept>

#include "analysis/trace.h"
#include "app/text/number_text.h"
#include "app/text/text_file.h"
#include "gis/access/gdal_session.h"
#include "gis/raster/raster_in.h"
#include "support/cog_check.h"
#include "support/tiny_scene.h"

namespace frana::test {
namespace {

namespace fs = std::filesystem;

class Output : public TinyScene {
  protected:
    /// Runs the scene with these lines appended and these keys set, into result/.
    void run(const std::string& more, const std::vector<std::string>& keys = {}) {
        write_scene(more);
        const Outcome outcome =
            frana(with_sets({"run", "scene.ini", "--out", "result", "--overwrite", "--quiet"}, keys));
        if (outcome.exit_code != 0) throw std::runtime_error(outcome.err);
    }
    [[nodiscard]] Raster raster(const std::string& name) const {
        return gis::read_result_raster(path("result/" + name));
    }
    [[nodiscard]] std::string text(const std::string& name) const { return read_text(path("result/" + name)); }
};

std::vector<std::string> rows_of(const std::string& csv) {
    std::vector<std::string> rows;
    std::size_t begin = 0;
    for (std::size_t end = csv.find('\n'); end != std::string::npos; begin = end + 1, end = csv.find('\n', begin))
        rows.push_back(csv.substr(begin, end - begin));
    return rows;
}

std::vector<std::string> cells_of(const std::string& row) {
    std::vector<std::string> cells{""};
    for (const char c : row) {
        if (c == ',')
            cells.emplace_back();
        else
            cells.back() += c;
    }
    return cells;
}

TEST_F(Output, EveryRasterIsAValidCloudOptimisedGeotiffWithProvenance) {
    write_polygon("scar", {{15, 50}, {180, 50}, {180, 100}, {15, 100}});
    run("frame-interval = 2\n[output]\nmaps = off\nanimation = off\nreport = off\n[hazard]\nscheme = "
        "swiss-flood\n"
        "[scar]\nperimeter = scar.geojson\n");
    const std::string hash = json_text(text("manifest.json"), "scene_hash");
    EXPECT_EQ(hash.size(), 36U);
    int rasters = 0;
    const gis::GdalSession session;
    for (const auto& entry : fs::recursive_directory_iterator(path("result"))) {
        if (entry.path().extension() != ".tif") continue;
        ++rasters;
        const std::string file = entry.path().string();
        EXPECT_EQ(gis::test::cog_problems(file), std::vector<std::string>{}) << file;
        const GDALDatasetUniquePtr tif(GDALDataset::Open(file.c_str(), GDAL_OF_RASTER));
        ASSERT_TRUE(tif) << file;
        EXPECT_STREQ(tif->GetMetadataItem("SCENE_HASH"), hash.c_str()) << file;
        EXPECT_STREQ(tif->GetMetadataItem("PROGRAM"), "frana") << file;
        EXPECT_STREQ(tif->GetMetadataItem("VERSION"), FRANA_VERSION) << file;
        EXPECT_STREQ(tif->GetMetadataItem("TIFFTAG_SOFTWARE"), "frana " FRANA_VERSION) << file;
        GDALRasterBand& band = *tif->GetRasterBand(1);
        EXPECT_NE(std::string(band.GetDescription()), "") << file;
        int has_nodata = 0;
        const double nodata = band.GetNoDataValue(&has_nodata);
        EXPECT_TRUE(has_nodata) << file;
        EXPECT_STREQ(tif->GetMetadataItem("COMPRESSION", "IMAGE_STRUCTURE"), "DEFLATE") << file;
        if (band.GetRasterDataType() != GDT_Float32) continue;
        EXPECT_EQ(nodata, -9999) << file;
        EXPECT_NE(std::string(band.GetUnitType()), "") << file;
        EXPECT_STREQ(tif->GetMetadataItem("PREDICTOR", "IMAGE_STRUCTURE"), "3") << file;
        EXPECT_TRUE(band.GetMetadataItem("STATISTICS_MAXIMUM")) << file;
    }
    // Six results, depth outside the release, release, dtm, bed, flux, head, momentum flux, hazard, comparison, three
    // frames of two.
    EXPECT_EQ(rasters, 6 + 3 + 3 + 1 + 1 + 1 + 6);
}

TEST_F(Output, GdalsOwnValidatorAgrees) {
    const std::string validator = "/usr/bin/python3 -m osgeo_utils.samples.validate_cloud_optimized_geotiff ";
    if (std::system("/usr/bin/python3 -c 'import osgeo_utils.samples.validate_cloud_optimized_geotiff' 2> "
                    "/dev/null") != 0)
        GTEST_SKIP() << "GDAL's validator (Debian: python3-gdal) is not installed";
    run(k_numbers_only + "[hazard]\nscheme = swiss-debris-flow\n");
    for (const std::string name : {"max_depth", "dtm", "hazard"}) {
        const std::string report = path("report_" + name);
        const int status = std::system(
            (validator + "--full-check=yes '" + path("result/" + name + ".tif") + "' > '" + report + "' 2>&1").c_str());
        EXPECT_EQ(status, 0) << read_text(report);
        EXPECT_NE(read_text(report).find("is a valid cloud optimized GeoTIFF"), std::string::npos) << read_text(report);
    }
}

TEST_F(Output, TheHashFollowsTheScene) {
    EXPECT_EQ(app::text_hash("a"), app::text_hash("a"));
    EXPECT_NE(app::text_hash("a"), app::text_hash("b"));
    // RFC 4122's method for "http://www.example.com/" in the URL namespace, from another implementation
    // (Python's uuid5).
    EXPECT_EQ(app::text_hash("http://www.example.com/"), "fcde3c85-2270-590f-9e7c-ee003d65e0e2");
}

TEST_F(Output, OutlinesHaveTheirValues) {
    run(k_numbers_only);
    const gis::GdalSession session;
    const GDALDatasetUniquePtr file(GDALDataset::Open(path("result/extent.gpkg").c_str(), GDAL_OF_VECTOR));
    ASSERT_TRUE(file);
    const std::string summary = text("summary.json");
    for (const std::string name : {"trace", "deposit"}) {
        OGRLayer* layer = file->GetLayerByName(name.c_str());
        ASSERT_TRUE(layer) << name;
        const OGRFeatureUniquePtr feature(layer->GetNextFeature());
        ASSERT_TRUE(feature) << name;
        const auto value = [&](const char* field) { return feature->GetFieldAsDouble(field); };
        EXPECT_GT(value("area_m2"), 0);
        EXPECT_GT(value("volume_m3"), 0);
        EXPECT_GT(value("runout_m"), 0);
        EXPECT_NEAR(value("reach_angle_deg"), std::atan2(value("drop_m"), value("runout_m")) * 180 / M_PI, 1e-9);
        if (name == "deposit") {
            // Volume deeper than the threshold; the rest is a thin film.
            EXPECT_LE(value("volume_m3"), 4000 * (1 + 1e-9));
            EXPECT_GT(value("volume_m3"), 0.9 * 4000);
            continue;
        }
        EXPECT_EQ(value("area_m2"), json_number(summary, "covered_area_m2"));
        EXPECT_NEAR(value("volume_m3"), 4000, 1e-6);
        EXPECT_EQ(value("max_depth_m"), json_number(summary, "max_depth_m"));
        EXPECT_EQ(value("max_velocity_ms"), json_number(summary, "max_velocity_ms"));
        EXPECT_EQ(value("max_depth_p999_m"), json_number(summary, "max_depth_p999_m"));
        EXPECT_EQ(value("max_velocity_p999_ms"), json_number(summary, "max_velocity_p999_ms"));
        EXPECT_EQ(value("runout_m"), json_number(summary, "horizontal_m"));
    }
}

TEST_F(Output, HighValuesAreThoseOfTheRasters) {
    run(k_pages_only + "trace-threshold = 0.3\n");
    const std::string summary = text("summary.json"), report = text("report.html");
    const Raster depth = gis::read_result_raster(path("result/max_depth.tif"));
    const std::array<std::array<std::string, 2>, 3> statistics{
        {{"max_depth", "m"}, {"max_velocity", "ms"}, {"max_pressure", "kpa"}}};
    for (const auto& [name, unit] : statistics) {
        const Raster raster = gis::read_result_raster(path("result/" + name + ".tif"));
        std::vector<double> inside;
        for (std::size_t i = 0; i < raster.values.size(); ++i)
            if (depth.values[i] > 0.3) inside.push_back(raster.values[i]);
        std::sort(inside.begin(), inside.end());
        ASSERT_GT(inside.size(), 100U);
        for (const int thousandths : {999, 990}) {
            // As numpy.percentile(inside, 99.9) and 99; files have 4 bytes per value, 6e-8 of it.
            const std::size_t last = inside.size() - 1, place = last * thousandths / 1000;
            const double beyond = static_cast<double>(last * thousandths % 1000) / 1000;
            const double expected = inside[place] + beyond * (inside[place + 1] - inside[place]);
            const std::string key = name + (thousandths == 999 ? "_p999_" : "_p99_") + unit;
            EXPECT_NEAR(json_number(summary, key), expected, 1e-6 * expected) << key;
            EXPECT_NE(report.find(">" + app::number_text(json_number(summary, key), 4) + "<"), std::string::npos)
                << key;
        }
        EXPECT_NEAR(json_number(summary, name + "_" + unit), inside.back(), 1e-6 * inside.back()) << name;
        EXPECT_LE(json_number(summary, name + "_p99_" + unit), json_number(summary, name + "_p999_" + unit));
        EXPECT_LE(json_number(summary, name + "_p999_" + unit), json_number(summary, name + "_" + unit));
    }
    EXPECT_NE(report.find("<td>Maximum depth, vertical [m]</td>"), std::string::npos);
}

TEST_F(Output, HighValuesOfNoAreaAreNone) {
    run(k_numbers_only + "trace-threshold = 50\n");
    const std::string summary = text("summary.json");
    EXPECT_EQ(json_number(summary, "covered_area_m2"), 0);
    EXPECT_GT(json_number(summary, "max_depth_m"), 1);
    EXPECT_TRUE(json_value(summary, "max_depth_p999_m").is_null());
}

TEST_F(Output, ProfilesAlongTheFlowPathAndTheUsersLine) {
    write_features("axis", {{"LineString", {{10, 75}, {210, 75}}, named("axis")}});
    run(k_numbers_only + "profiles = axis.geojson\n");
    const std::vector<std::string> rows = rows_of(text("profiles.csv"));
    ASSERT_GT(rows.size(), 42U);
    EXPECT_EQ(rows[0],
              "line,distance_m,x,y,bed_m,release_m,max_depth,max_velocity,final_depth,arrival_time,max_pressure,"
              "depth_direction");
    const Raster depth = raster("max_depth.tif"), bed = raster("bed.tif");
    int on_axis = 0;
    double path_length = 0;
    for (std::size_t i = 1; i < rows.size(); ++i) {
        const std::vector<std::string> cells = cells_of(rows[i]);
        ASSERT_EQ(cells.size(), 12U) << rows[i];
        EXPECT_EQ(cells[11], "vertical");
        const double x = std::stod(cells[2]), y = std::stod(cells[3]);
        const auto row = static_cast<std::int64_t>((bed.grid.north - y) / k_cell);
        const auto column = static_cast<std::int64_t>((x - bed.grid.west) / k_cell);
        EXPECT_NEAR(std::stod(cells[4]), bed.at(row, column), 1e-4) << rows[i];  // the file contains floats
        if (cells[6].empty())
            EXPECT_FALSE(depth.has_data(row, column));
        else
            EXPECT_NEAR(std::stod(cells[6]), depth.at(row, column), 1e-5);
        if (cells[0] == "axis") {
            EXPECT_NEAR(std::stod(cells[1]), 5.0 * on_axis, 1e-9);
            ++on_axis;
        } else {
            EXPECT_EQ(cells[0], "flow path");
            path_length = std::stod(cells[1]);
        }
    }
    EXPECT_EQ(on_axis, 41);  // 200 m, one station per cell
    // The flow runs straight down the slope: not shorter than the straight run-out, not longer than with a turn of 45
    // degrees.
    const double straight = json_number(text("summary.json"), "horizontal_m");
    EXPECT_GE(path_length, straight * (1 - 1e-9));
    EXPECT_LE(path_length, 1.083 * straight + k_cell);
    const gis::GdalSession session;
    const GDALDatasetUniquePtr file(GDALDataset::Open(path("result/profiles.gpkg").c_str(), GDAL_OF_VECTOR));
    ASSERT_TRUE(file);
    EXPECT_EQ(file->GetLayerByName("lines")->GetFeatureCount(), 2);
    EXPECT_EQ(file->GetLayerByName("stations")->GetFeatureCount(), static_cast<GIntBig>(rows.size() - 1));
}

TEST_F(Output, GaugesAndCrossSectionsRecordTheFlow) {
    write_features("gauges", {{"Point", {{45, 75}}, named("top")}, {"Point", {{290, 5}}, named("never")}});
    // Across the slope 10 m below the release, drawn from the south to the north: downhill is to the right.
    write_features("sections", {{"LineString", {{80, 0}, {80, 150}}, named("bridge")}});
    run(k_numbers_only + "gauges = gauges.geojson\ncross-sections = sections.geojson\nsample-interval = 0.5\n");
    const std::vector<std::string> gauges = rows_of(text("gauges.csv")), sections = rows_of(text("sections.csv"));
    EXPECT_EQ(gauges[0], "time_s,gauge,depth_m,speed_ms");
    EXPECT_EQ(sections[0], "time_s,section,discharge_m3s,volume_m3,wetted_width_m,max_depth_m,max_speed_ms");
    EXPECT_EQ(gauges.size(), 1 + 2 * 8U);                     // 0, 0.5 ... 3.5 s
    EXPECT_NEAR(std::stod(cells_of(gauges[1])[2]), 2, 0.01);  // the release's thickness at the start
    EXPECT_EQ(cells_of(gauges[1])[1], "top");
    EXPECT_EQ(cells_of(gauges.back())[2], "0");
    const auto last = cells_of(sections.back());
    EXPECT_GE(std::stod(last[2]), 0);
    double passed = 0;
    for (std::size_t i = 1; i < sections.size(); ++i) {
        EXPECT_GE(std::stod(cells_of(sections[i])[3]), passed - 1e-9) << "all of it flows down";
        passed = std::stod(cells_of(sections[i])[3]);
    }
    EXPECT_GT(passed, 100);
    EXPECT_LE(passed, 4000);
    EXPECT_TRUE(fs::exists(path("result/gauges.gpkg")));
}

TEST_F(Output, PlacesOutsideTheGridAndLayersOfTheWrongKindAreRefusedTogether) {
    write_features("gauges", {{"Point", {{1000, 75}}, named("far")}});
    write_features("points", {{"Point", {{10, 75}}, named("p")}});
    write_features("twice",
                   {{"LineString", {{10, 5}, {20, 5}}, named("a")}, {"LineString", {{10, 9}, {20, 9}}, named("a")}});
    write_scene("[output]\ngauges = gauges.geojson\ncross-sections = points.geojson\nprofiles = twice.geojson\n");
    refusal_of(frana({"run", "scene.ini", "--out", "result"}),
               {"output.gauges: lies outside the working grid (value gauge far at 528000",
                "output.cross-sections: is not a layer of lines", "output.profiles: two have the same name (value a"});
    EXPECT_FALSE(fs::exists(path("result")));
}

TEST_F(Output, HazardClassesFollowFromTheRasters) {
    run(k_numbers_only + "[hazard]\nscheme = swiss-debris-flow\n");
    const Raster classes = raster("hazard.tif"), depth = raster("max_depth.tif"), speed = raster("max_velocity.tif");
    double high = 0, thin = 0;
    for (std::size_t i = 0; i < classes.values.size(); ++i) {
        const bool has_class = depth.values[i] > 0.1;  // the default of output.trace-threshold
        ASSERT_EQ(!std::isnan(classes.values[i]), has_class) << depth.values[i];
        thin += depth.values[i] <= 0.1 ? 1 : 0;
        if (!has_class) continue;
        const bool is_high = depth.values[i] > 1 && speed.values[i] > 1;
        ASSERT_EQ(classes.values[i], is_high ? 3 : 2) << depth.values[i] << ' ' << speed.values[i];
        high += is_high ? 25 : 0;
    }
    EXPECT_GT(std::min(high, thin * 1.0), 0) << "cells without a class";
    const gis::GdalSession session;
    const GDALDatasetUniquePtr file(GDALDataset::Open(path("result/hazard_zones.gpkg").c_str(), GDAL_OF_VECTOR));
    ASSERT_TRUE(file);
    double zones = 0;
    for (const auto& feature : *file->GetLayer(0))
        if (feature->GetFieldAsInteger("class") == 3) zones += feature->GetFieldAsDouble("area_m2");
    EXPECT_NEAR(zones, high, 1e-6 * high);
    for (const char* name : {"hazard.qml", "hazard.sld", "hazard_zones.qml", "hazard_zones.sld"})
        EXPECT_TRUE(fs::exists(path(std::string("result/") + name))) << name;
    EXPECT_FALSE(fs::exists(path("result/max_flux.tif"))) << "not asked for, not computed";
    const Json named = json_value(text("summary.json"), "hazard");
    EXPECT_TRUE(std::any_of(named.begin(), named.end(), [](const Json& one) {
        return one["label"] == "High intensity";
    })) << named;
}

// Classes made by depth alone cover what is deep enough; those by speed as well follow their rasters however thin the
// flow.
TEST_F(Output, HazardClassesAddUpToTheCoveredArea) {
    write("by_depth.ini", own_scheme("depth > ", "0.5 m", "2 m"));
    const std::string by_depth = "[hazard]\nscheme = by_depth.ini\n";
    for (const std::string& more : {k_numbers_only + by_depth, k_numbers_only + "trace-threshold = 0.3\n" + by_depth}) {
        run(more);
        double classes = 0;
        for (const Json& one : json_value(text("summary.json"), "hazard")) classes += one["area_m2"].get<double>();
        EXPECT_NEAR(classes, json_number(text("summary.json"), "covered_area_m2"), 1e-6) << more;  // rounding of sums
    }
    run(k_numbers_only + by_depth + "minimum-depth = 1\n");
    const Raster classes = raster("hazard.tif"), depth = raster("max_depth.tif");
    for (std::size_t i = 0; i < classes.values.size(); ++i)
        ASSERT_EQ(!std::isnan(classes.values[i]), depth.values[i] > 1) << depth.values[i];
}

TEST_F(Output, GreatestValuesHavePlaceAndTime) {
    run(k_numbers_only);
    for (const auto& [name, column] : {std::pair{"max_depth", "max_depth"}, {"max_velocity", "max_speed"}}) {
        const Raster values = raster(std::string(name) + ".tif");
        const Json at = json_value(text("summary.json"), std::string(name) + "_at");
        const GridSpec& grid = values.grid;
        const auto row = static_cast<std::int64_t>((grid.north - at["y"].get<double>()) / grid.cell_size),
                   cell = static_cast<std::int64_t>((at["x"].get<double>() - grid.west) / grid.cell_size);
        EXPECT_EQ(values.at(row, cell), maximum(values)) << name;
        const std::vector<std::string> series = rows_of(text("timeseries.csv"));
        const auto column_of = [&](const std::string& line, const std::string& wanted) {
            std::istringstream names(series.front()), numbers(line);
            std::string key, number;
            while (std::getline(names, key, ',') && std::getline(numbers, number, ','))
                if (key.starts_with(wanted)) return std::stod(number);
            throw std::runtime_error(wanted);
        };
        double greatest = 0, when = 0;
        for (std::size_t i = 1; i < series.size(); ++i) {
            if (const double value = column_of(series[i], column); value > greatest) {
                greatest = value;
                when = column_of(series[i], "time");
            }
        }
        // The series is written with fewer digits.
        EXPECT_NEAR(at["time_s"].get<double>(), when, 1e-3) << name;
    }
}

TEST_F(Output, DoubtfulReleasesAreWarnings) {
    const auto warns = [&](const std::string& words) { return json_lists(text("summary.json"), "warnings", words); };
    const std::string step = "release step of", stout = "too thick for depth-averaging", few = "particles only",
                      energy = "energy error ";
    const auto energy_is_told = [&] {
        return warns(energy) == (json_number(text("summary.json"), "energy_error") > 0.05);
    };
    run(k_numbers_only);
    for (const std::string& words : {step, stout, few}) EXPECT_FALSE(warns(words)) << words;
    EXPECT_TRUE(energy_is_told());
    // Thicker than half of its width of sqrt(2000) m, with a wall of 45 m.
    run(k_numbers_only, {"release.thickness=45"});
    for (const std::string& words : {step, stout}) EXPECT_TRUE(warns(words)) << words;
    EXPECT_FALSE(warns(few));
    const Outcome check = succeeded(frana({"check", "scene.ini", "--json", "--set", "release.thickness=45"}));
    for (const std::string& words : {step, stout}) EXPECT_TRUE(json_lists(check.out, "warnings", words)) << words;
    EXPECT_FALSE(json_lists(check.out, "warnings", few));
    EXPECT_TRUE(energy_is_told());
    write_polygon("small", {{20, 55}, {35, 55}, {35, 70}, {20, 70}});
    run(k_numbers_only, {"release.perimeter=small.geojson"});
    EXPECT_TRUE(warns(few)) << text("summary.json");
}

TEST_F(Output, SchemesThatNeedFluxOrHeadRecordThem) {
    run(k_numbers_only + "[hazard]\nscheme = austrian-torrent\n");
    const Raster classes = raster("hazard.tif"), head = raster("max_head.tif"), deposit = raster("final_depth.tif");
    for (std::size_t i = 0; i < classes.values.size(); ++i) {
        if (std::isnan(classes.values[i])) continue;
        // The file's floats may be on the other side of a limit than the classified doubles.
        if (std::abs(head.values[i] - 1.5) < 1e-6 || std::abs(deposit.values[i] - 0.7) < 1e-6) continue;
        ASSERT_EQ(classes.values[i], head.values[i] >= 1.5 || deposit.values[i] >= 0.7 ? 2 : 1);
    }
}

// A citation that nobody could read is none, and zones are no intensities.
TEST_F(Output, AMapOfASchemeWhoseSourceWasNotReadSaysSo) {
    run("[output]\nmaps = hazard\nmap-formats = svg\nanimation = off\nframes = off\ncharts = off\n"
        "[hazard]\nscheme = austrian-torrent\n");
    const std::string map = text("maps/hazard.svg");
    expect_words(map, {"customary limits, source", "Zones, ", "Zones of one scenario", "Red zone"});
    expect_no_words(map, {"BMLFUW", "Intensity"});
    const std::string report = text("report.html");
    EXPECT_NE(report.find("source not read"), std::string::npos);
    EXPECT_EQ(report.find("Intensity classes"), std::string::npos);
    EXPECT_NE(text("summary.json").find("\"source_read\": false"), std::string::npos);
}

// A scheme of the user's own: its classes, colours and words in rasters, map, report and summary, in the language of
// the map, and the file among the inputs.
TEST_F(Output, AnOwnSchemeIsAFile) {
    const std::string own =
        "[scheme]\ntitle = Our valley\ntitle-it = La nostra valle\nclasses-are = zones\nsource = Office\n"
        "[class-1]\nname = Outer\nname-it = Esterna\ncolour = ffdd33\n"
        "[class-2]\nname = Inner\nname-it = Interna\ncolour = d7191c\ncondition = pressure >= 2 kPa or depth > 1 m\n";
    std::ofstream(path("own.ini")) << own;
    run("[output]\nmaps = hazard\nmap-formats = svg\nanimation = off\nframes = off\ncharts = off\nlanguage = it\n"
        "[hazard]\nscheme = own.ini\n",
        {"material.density=2000"});
    const Raster classes = raster("hazard.tif"), pressure = raster("max_pressure.tif"), depth = raster("max_depth.tif");
    int inner = 0, outer = 0;
    for (std::size_t i = 0; i < classes.values.size(); ++i) {
        if (std::isnan(classes.values[i])) continue;
        // The file's floats may be on the other side of a limit than the classified doubles.
        if (std::abs(pressure.values[i] - 2) < 1e-5 || std::abs(depth.values[i] - 1) < 1e-6) continue;
        const bool is_inner = pressure.values[i] >= 2 || depth.values[i] > 1;
        ASSERT_EQ(classes.values[i], is_inner ? 2 : 1);
        (is_inner ? inner : outer) += 1;
    }
    EXPECT_GT(inner, 0);
    EXPECT_GT(outer, 0);
    EXPECT_FALSE(std::filesystem::exists(path("result/max_head.tif"))) << "not used";
    const std::string map = text("maps/hazard.svg"), report = text("report.html"), summary = text("summary.json");
    for (const char* said : {"La nostra valle", "Interna", "Esterna", "fonte non letta"}) {
        EXPECT_NE(map.find(said), std::string::npos) << said;
        EXPECT_NE(report.find(said), std::string::npos) << said;
    }
    EXPECT_NE(report.find("own.ini"), std::string::npos);
    EXPECT_NE(text("inputs.json").find("own.ini"), std::string::npos);
    const Json scheme = parse_json(summary)["hazard_scheme"];
    EXPECT_EQ(scheme["name"], "own");
    EXPECT_EQ(scheme["title"], "Our valley");
    EXPECT_EQ(scheme["source_read"], false);
    succeeded(frana({"schemes", "own.ini"}));
    // What is wrong with it is told before anything is computed.
    std::ofstream(path("own.ini")) << own << "colour = red\n[class-4]\n";
    refusal_of(frana({"schemes", "own.ini"}), {"own.ini: class-2.colour", "is given more than once"});
}

// The slope falls 1 in 2 as far as column 39 (cosine 1 / sqrt(1.25)), is level from column 41 on.
TEST_F(Output, DepthsNormalToTheBedAreTheVerticalOnesTimesTheCosineOfTheSlope) {
    const std::string maps =
        "frame-interval = 2\n[output]\nmaps = max_depth, hazard\nmap-formats = svg\nanimation = off\nreport = off\n"
        "[hazard]\nscheme = swiss-debris-flow\n";
    run(maps);
    fs::rename(path("result"), path("vertical"));
    run(maps, {"output.depth=normal"});
    const double cosine = 1 / std::sqrt(1.25);
    for (const std::string name : {"max_depth.tif", "final_depth.tif", "frames/depth_0001.tif", "max_flux.tif",
                                   "max_velocity.tif", "release.tif"}) {
        if (name == "max_flux.tif" && !fs::exists(path("vertical/" + name))) continue;
        const bool is_depth = name.find("depth") != std::string::npos || name == "max_flux.tif";
        const Raster normal = raster(name), vertical = gis::read_result_raster(path("vertical/" + name));
        int cells = 0;
        for (std::int64_t row = 0; row < k_rows; ++row) {
            for (std::int64_t column = 0; column < k_columns; ++column) {
                ASSERT_EQ(normal.has_data(row, column), vertical.has_data(row, column));
                if (!normal.has_data(row, column) || column == 39 || column == 40) continue;
                const double factor = is_depth && column < 39 ? cosine : 1;
                // Float32 in the file, and six digits of the grid's text.
                ASSERT_NEAR(normal.at(row, column), vertical.at(row, column) * factor,
                            2e-5 * (1 + vertical.at(row, column)))
                    << name << ' ' << row << ' ' << column;
                ++cells;
            }
        }
        EXPECT_GT(cells, 50) << name;
        const GDALDatasetUniquePtr file(GDALDataset::Open(path("result/" + name).c_str()));
        const std::string band = file->GetRasterBand(1)->GetDescription();
        EXPECT_EQ(band.find(", normal to the bed") != std::string::npos, is_depth && name != "max_flux.tif") << band;
        EXPECT_STREQ(file->GetMetadataItem("DEPTH"), "normal to the bed");
    }
    // Classes are those of the rasters written; volumes are those of vertical depths.
    const Raster classes = raster("hazard.tif"), depth = raster("max_depth.tif");
    for (std::size_t i = 0; i < classes.values.size(); ++i)
        ASSERT_EQ(!std::isnan(classes.values[i]), depth.values[i] > 0.1F) << i;
    const auto number = [&](const std::string& folder, const std::string& key) {
        return json_number(read_text(path(folder + "/summary.json")), key);
    };
    EXPECT_EQ(number("result", "final_depth_raster_m3"), number("vertical", "final_depth_raster_m3"));
    EXPECT_NEAR(number("result", "max_depth_m"), maximum(depth), 1e-6);
    EXPECT_LT(number("result", "max_depth_m"), number("vertical", "max_depth_m"));
    EXPECT_EQ(json_text(text("summary.json"), "depth_direction"), "normal to the bed");
    std::vector<std::string> stations = rows_of(text("profiles.csv"));
    ASSERT_GT(stations.size(), 10U);
    for (std::size_t i = 1; i < stations.size(); ++i)
        EXPECT_EQ(cells_of(stations[i]).back(), "normal to the bed") << stations[i];
    const GDALDatasetUniquePtr profiles(GDALDataset::Open(path("result/profiles.gpkg").c_str(), GDAL_OF_VECTOR));
    const OGRFeatureUniquePtr station(profiles->GetLayerByName("stations")->GetNextFeature());
    EXPECT_STREQ(station->GetFieldAsString("depth_direction"), "normal to the bed");
    const auto deposit = [&](const std::string& folder) {
        const GDALDatasetUniquePtr file(GDALDataset::Open(path(folder + "/extent.gpkg").c_str(), GDAL_OF_VECTOR));
        const OGRFeatureUniquePtr feature(file->GetLayerByName("deposit")->GetNextFeature());
        return feature->GetFieldAsDouble("volume_m3");
    };
    EXPECT_NEAR(deposit("result"), deposit("vertical"),
                0.02 * deposit("vertical"));  // a thinner film counts as deposit
    for (const std::string map : {"maps/max_depth.svg", "maps/hazard.svg"})
        EXPECT_NE(text(map).find("normal to the"), std::string::npos) << map;  // the title may be in two lines
    EXPECT_NE(read_text(path("vertical/maps/max_depth.svg")).find("vertical"), std::string::npos);
}

// 2 m normal to a slope of 1 in 2 are sqrt(1.25) times as thick vertically.
TEST_F(Output, TheThicknessOfAReleaseIsGivenInBothDirections) {
    const gis::GdalSession session;
    for (const std::string direction : {"normal", "vertical"}) {
        run(k_numbers_only, {"release.thickness-direction=" + direction});
        const GDALDatasetUniquePtr file(GDALDataset::Open(path("result/extent.gpkg").c_str(), GDAL_OF_VECTOR));
        const OGRFeatureUniquePtr release(file->GetLayerByName("release")->GetNextFeature());
        const auto value = [&](const char* field) { return release->GetFieldAsDouble(field); };
        EXPECT_NEAR(value("thickness_vertical_m"), value("volume_m3") / 2000, 1e-9);
        EXPECT_NEAR(value("thickness_vertical_m") / value("thickness_normal_m"), std::sqrt(1.25), 1e-5) << direction;
        EXPECT_NEAR(value(direction == "normal" ? "thickness_normal_m" : "thickness_vertical_m"), 2, 2e-5) << direction;
    }
}

}  // namespace
}  // namespace frana::test
