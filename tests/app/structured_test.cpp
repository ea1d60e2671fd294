// SPDX-License-Identifier: Apache-2.0
// The structured model through the program: fluid alone.
#include <set>

#include "gis/raster/raster_in.h"
#include "support/tiny_scene.h"

namespace frana::test {
namespace {

namespace fs = std::filesystem;

class StructuredScene : public TinyScene {
  protected:
    // The tiny slope with water instead of a Voellmy material.
    void write_fluid(const std::string& more = "") const {
        write("scene.ini",
              "[terrain]\ndtm = dtm.asc\n[release]\nperimeter = perimeter.geojson\nthickness = 2\n[material]\n"
              "model = structured\n[structured]\nphases = fluid\nmanning = 0.05\n[time]\nend = 20\n" +
                  more);
    }
    [[nodiscard]] double summary_number(const std::string& result, const std::string& key) const {
        return json_number(read_text(path(result + "/summary.json")), key);
    }
};

TEST_F(StructuredScene, WritesTheSameFilesAsTheFirstModel) {
    write_fluid("frame-interval = 5\n[output]\nmap-size = 640x480\n");
    const Outcome outcome = ran();
    EXPECT_EQ(outcome.err, "");
    for (const std::string name :
         {"scene.ini", "summary.json", "extent.gpkg", "timeseries.csv", "log.txt", "dtm.tif", "bed.tif", "release.tif",
          "animation.mp4", "frames/depth_0000.tif", "frames/velocity_0004.tif", "maps/max_depth.png", "max_depth.tif",
          "max_velocity.tif", "final_depth.tif", "arrival_time.tif", "max_pressure.tif"})
        EXPECT_TRUE(fs::exists(path("result/" + name)) && fs::file_size(path("result/" + name)) > 0) << name;
    const std::string summary = read_text(path("result/summary.json"));
    EXPECT_EQ(json_text(summary, "model"), "structured");
    for (const std::string words : {"Manning bed resistance", "finite volumes"})
        EXPECT_TRUE(json_lists(summary, "terms", words)) << words;
    EXPECT_FALSE(json_lists(summary, "terms", "Coulomb"));
    // 50 m x 40 m, 2 m thick; nothing is lost.
    EXPECT_NEAR(summary_number("result", "initial_m3"), 4000, 1e-6);
    EXPECT_LT(summary_number("result", "relative_error"), 1e-12);
    EXPECT_GT(summary_number("result", "max_velocity_ms"), 3);

    // The map's depths give the volume: final depth times cell area is the remaining volume, except for films below 1
    // cm.
    const Raster depth = gis::read_result_raster(path("result/final_depth.tif"));
    double volume = 0;
    for (const double d : depth.values) volume += std::isnan(d) ? 0 : d * k_cell * k_cell;
    EXPECT_NEAR(volume, summary_number("result", "final_m3"), 0.02 * 4000);
}

// Blocks of solids with their water, through the same program: both phases in rasters and frames, nothing lost.
TEST_F(StructuredScene, RunsSolidsWithTheirFluid) {
    write_fluid(
        "frame-interval = 1\n[numerics]\nparticles-per-cell = 9\n[output]\nmaps = off\nanimation = off\nreport = off\n"
        "formats = geotiff, particles-gpkg\nmap-size = 640x480\n");
    ran("result", {"time.end=2", "structured.phases=solids-and-fluid", "structured.cohesion=2e3",
                   "structured.internal-friction-angle=28", "structured.bed-friction-angle=12",
                   "structured.young-modulus=1e6", "structured.bulk-modulus=1e6"});
    for (const std::string name : {"solid_depth", "solid_velocity", "solid_fraction", "cohesion_ratio", "strain",
                                   "fluid_depth", "fluid_velocity", "released_water"}) {
        EXPECT_TRUE(fs::exists(path("result/" + name + ".tif"))) << name;
        EXPECT_TRUE(fs::exists(path("result/" + name + ".qml"))) << name;
    }
    EXPECT_TRUE(fs::exists(path("result/frames/solid_depth_0002.tif")));
    EXPECT_GT(summary_number("result", "particle_steps"), 0);
    EXPECT_NEAR(summary_number("result", "initial_m3"), 4000, 1e-6);
    EXPECT_LT(summary_number("result", "relative_error"), 1e-12);
    // Half of the mass is solids: the raster contains at most that volume.
    const Raster solids = gis::read_result_raster(path("result/solid_depth.tif"));
    double volume = 0;
    for (const double d : solids.values) volume += std::isnan(d) ? 0 : d * k_cell * k_cell;
    EXPECT_NEAR(volume, 2000, 0.02 * 2000);
    // As densely as they were released the solids fill what failed, whatever water left them.
    double change = 0;
    for (const double d : gis::read_result_raster(path("result/elevation_change.tif")).values)
        change += std::isnan(d) ? 0 : d * k_cell * k_cell;
    EXPECT_NEAR(change, 0, 0.02 * 4000);
    const Raster left = gis::read_result_raster(path("result/cohesion_ratio.tif"));
    for (const double c : left.values) EXPECT_TRUE(std::isnan(c) || (c >= 0 && c <= 1));

    // Frames of what the phases do, and particles by the cohesion left to them, on maps and as an animation.
    const Outcome drawn = succeeded(
        frana({"render", "result", "--map", "cohesion_ratio@1", "--map", "solid_velocity@1", "--map",
               "fluid_velocity@2", "--map", "particle_cohesion@1", "--map", "particles@1", "--out", "drawn"}));
    // Named by the frame's true time, at or after the one asked for.
    std::set<std::string> pictures, contents;
    for (const auto& file : fs::directory_iterator(path("drawn"))) {
        const std::string name = file.path().filename().string();
        if (!name.ends_with(".png")) continue;
        pictures.insert(name.substr(0, name.rfind("_t")));
        contents.insert(read_text(file.path().string()));
    }
    EXPECT_EQ(pictures, (std::set<std::string>{"cohesion_ratio", "fluid_velocity", "particle_cohesion", "particles",
                                               "solid_velocity"}));
    EXPECT_EQ(contents.size(), pictures.size());
    succeeded(
        frana({"render", "result", "--map", "particle_cohesion", "--animation", "cohesion.gif", "--size", "640x480"}));
}

// What a result's frames do not have is no map of theirs.
TEST_F(StructuredScene, FluidAloneHasNoCohesionToDraw) {
    write_fluid("frame-interval = 5\n[output]\nmaps = off\nanimation = off\nreport = off\nmap-size = 640x480\n");
    ran("result", {"time.end=5"});
    succeeded(frana({"render", "result", "--map", "velocity@5"}));
    for (const char* map : {"cohesion_ratio@5", "particle_cohesion@5"}) {
        const Outcome refused = refusal_of(frana({"render", "result", "--map", map}), {"velocity@SECONDS"});
        EXPECT_EQ(refused.err.find("cohesion_ratio@SECONDS"), std::string::npos) << refused.err;
    }
}

// `frana run` on what a run wrote repeats it to the last bit, with another number of threads.
TEST_F(StructuredScene, EchoRepeatsTheRun) {
    write_fluid(k_numbers_only);
    succeeded(frana({"run", "scene.ini", "--out", "first", "--quiet", "--threads", "1"}));
    succeeded(frana({"run", "first/scene.ini", "--out", "second", "--quiet", "--threads", "3"}));
    EXPECT_EQ(read_text(path("first/timeseries.csv")), read_text(path("second/timeseries.csv")));
    for (const std::string name : {"max_depth", "max_velocity", "arrival_time"}) {
        const Raster a = gis::read_result_raster(path("first/" + name + ".tif"));
        const Raster b = gis::read_result_raster(path("second/" + name + ".tif"));
        for (std::size_t i = 0; i < a.values.size(); ++i)
            EXPECT_TRUE(a.values[i] == b.values[i] || (std::isnan(a.values[i]) && std::isnan(b.values[i])));
    }
}

TEST_F(StructuredScene, CheckPrintsWhatWouldRun) {
    write_fluid();
    const Outcome outcome = succeeded(frana({"check", "scene.ini"}));
    EXPECT_NE(outcome.out.find("bytes per cell"), std::string::npos) << outcome.out;
    EXPECT_EQ(outcome.out.find("particles"), std::string::npos) << outcome.out;
}

// Inflow and a release that fails later enter as in the first model.
TEST_F(StructuredScene, AddsLaterReleasesAndInflow) {
    write("hydrograph.csv", "time,discharge,velocity\n0,0,2\n2,30,2\n8,30,2\n10,0,2\n");
    write_features("line", {{"LineString", {{100, 60}, {100, 90}}}});
    write_fluid("[inflow]\nline = line.geojson\nhydrograph = hydrograph.csv\n" + k_numbers_only);
    ran("result", {"release.start=3"});
    EXPECT_NEAR(summary_number("result", "inflow_m3"), 240, 1e-9);
    EXPECT_NEAR(summary_number("result", "entered_m3"), 4240, 1e-6);
    EXPECT_LT(summary_number("result", "relative_error"), 1e-12);
}

// Rain of 5 mm in 10 s on 300 m x 150 m, into a soil that takes some of it: all of it is found again, and none after
// its end.
TEST_F(StructuredScene, RainFallsAndInfiltrates) {
    write("rain.csv", "time,depth_mm\n0,0\n5,2\n10,5\n");
    write_fluid(k_numbers_only +
                "[structured]\nrain = table:rain.csv\nsoil-conductivity = 400\nsoil-suction = 0.05\n"
                "soil-moisture-deficit = 0.3\n");
    const Outcome check = frana({"check", "scene.ini"});
    EXPECT_NE(check.out.find("5 mm until the end"), std::string::npos) << check.out << check.err;
    ran();
    const double rain = summary_number("result", "rain_m3"), infiltrated = summary_number("result", "infiltrated_m3");
    EXPECT_NEAR(rain, 0.005 * 300 * 150, 1e-9);
    EXPECT_NEAR(summary_number("result", "entered_m3"), 4000 + rain, 1e-6);
    EXPECT_NEAR(summary_number("result", "final_m3") + summary_number("result", "left_domain_m3") + infiltrated,
                4000 + rain, 1e-12 * rain);
    const std::string summary = read_text(path("result/summary.json"));
    for (const std::string words : {"rain", "Green-Ampt infiltration"})
        EXPECT_TRUE(json_lists(summary, "terms", words)) << words;
    // Under the release the head of 2 m drives in more than under rain alone.
    const Raster depth = gis::read_result_raster(path("result/infiltrated_depth.tif"));
    double volume = 0, most = 0;
    for (const double d : depth.values) volume += std::isnan(d) ? 0 : d * k_cell * k_cell;
    for (const double d : depth.values) most = std::fmax(most, d);
    EXPECT_NEAR(volume, infiltrated, 1e-6 * infiltrated);  // of Float32
    EXPECT_GT(most, 0.02);
    // By place: only where the polygon is, which is the release's.
    const Outcome placed = ran("placed", {"structured.soil-conductivity=attribute:depth", "structured.rain=36"});
    EXPECT_NEAR(summary_number("placed", "rain_m3"), 0.01 * 20 / 1000 * 300 * 150, 1e-9);
    const Raster part = gis::read_result_raster(path("placed/infiltrated_depth.tif"));
    EXPECT_EQ(std::count_if(part.values.begin(), part.values.end(), [](double d) { return d > 0; }), 10 * 8);
    EXPECT_LT(summary_number("placed", "relative_error"), 1e-12);
}

// A pond that only soaks away has not come to its end, though nothing moves: 20 cm on tight walls.
TEST_F(StructuredScene, APondSoaksAwayToTheEnd) {
    write_dtm([](int, int) { return 100.0; });
    write_polygon("perimeter", {{0, 0}, {300, 0}, {300, 150}, {0, 150}});
    write_fluid("[numerics]\nboundary = wall\n" + k_numbers_only +
                "[structured]\nsoil-conductivity = 40\nsoil-suction = 0\nsoil-moisture-deficit = 0.5\n");
    ran("result", {"release.thickness=0.2", "time.end=60"});
    EXPECT_EQ(summary_number("result", "simulated_seconds"), 60);
    // dF/dt = K (1 + D (H - F)/F), H = 0.2 m: the start, where F is small, follows sqrt(2 K D H t).
    const double k = 40 / 3.6e6, first = std::sqrt(2 * k * 0.5 * 0.2 * 60);
    EXPECT_NEAR(summary_number("result", "infiltrated_m3"), first * 300 * 150, 0.05 * first * 300 * 150);
}

// A shower of 12 s and one of 4 s on the eastern half, on flat ground out of reach of edges and of the release.
TEST_F(StructuredScene, RainFallsWhereRastersSay) {
    write_dtm([](int, int column) { return column < k_columns / 2 ? 0.0 : 2500.0; }, true, "east.asc");
    write_dtm();
    write("rain.csv", "time,raster\n0,east.asc\n12,\n16,east.asc\n20,\n");
    write_fluid(k_numbers_only + "[structured]\nrain = table:rain.csv\n");
    const Outcome check = frana({"check", "scene.ini"});
    EXPECT_NE(check.out.find("by place, at most 2500 mm/h"), std::string::npos) << check.out << check.err;
    for (const std::string threads : {"1", "3"}) {
        succeeded(frana({"run", "scene.ini", "--out", threads, "--quiet", "--threads", threads}));
    }
    const double depth = 2500 / 3.6e6 * 16, rain = depth * 150 * 150;
    EXPECT_NEAR(summary_number("1", "rain_m3"), rain, 1e-12 * rain);
    EXPECT_NEAR(summary_number("1", "final_m3") + summary_number("1", "left_domain_m3"), 4000 + rain, 1e-12 * 4000);
    const Raster found = gis::read_result_raster(path("1/final_depth.tif"));
    const auto at = [&](int row, int column) {
        const double x = k_west + (column + 0.5) * k_cell, y = k_south + (k_rows - row - 0.5) * k_cell;
        return found.grid.bounds().contains(x, y) ? found.at(static_cast<std::int64_t>((found.grid.north - y) / k_cell),
                                                             static_cast<std::int64_t>((x - found.grid.west) / k_cell))
                                                  : std::nan("");
    };
    EXPECT_NEAR(at(3, 50), depth, 1e-7);  // of Float32
    EXPECT_TRUE(std::isnan(at(3, 20)));
    EXPECT_EQ(read_text(path("1/final_depth.tif")), read_text(path("3/final_depth.tif")));
}

// A drizzle of 30 m3 does not hide that the flow ran off the map; and rain alone, which leaves everywhere, is no such
// news.
TEST_F(StructuredScene, RainDoesNotHideAFlowThatLeavesTheMap) {
    write_fluid(k_numbers_only);
    const auto told = [&](const std::string& result, const std::string& rain) {
        ran(result, {"time.end=120", "structured.rain=" + rain});
        return json_lists(read_text(path(result + "/summary.json")), "warnings", "left the computed ground");
    };
    EXPECT_TRUE(told("drizzle", "20"));
    EXPECT_GT(summary_number("drizzle", "left_domain_m3"), 100);
    EXPECT_FALSE(told("storm", "2500"));
    // Thinner than what maps show: no smaller cells would show it.
    ran("film", {"time.end=300", "release.thickness=0.2", "structured.rain=5"});
    const std::string film = read_text(path("film/summary.json"));
    EXPECT_GT(json_number(film, "greatest_thin_fraction"), 0.1);
    EXPECT_FALSE(json_lists(film, "warnings", "use smaller cells"));
}

TEST_F(StructuredScene, RecordsSections) {
    write_features("section", {{"LineString", {{150, 145}, {150, 5}}, named("foot")}});
    write_fluid(k_numbers_only + "cross-sections = section.geojson\n");
    ran();
    const std::string rows = read_text(path("result/sections.csv"));
    EXPECT_GT(std::count(rows.begin(), rows.end(), '\n'), 10);
}

}  // namespace
}  // namespace frana::test
