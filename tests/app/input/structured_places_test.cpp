// SPDX-License-Identifier: Apache-2.0
// Properties of the structured model's release that vary from place to place, and later additions.
#include <algorithm>
#include <cmath>
#include <sstream>

#include "particle_points.h"
#include "support/checked_scene.h"

namespace frana::test {
namespace {

class StructuredPlaces : public CheckedScene {
  protected:
    StructuredPlaces() {
        // Two halves of the release, 2000 m3 each, and ground around the western one.
        write_features("zones", {{"Polygon", box(0, 5, 45, 145), R"("c": 0, "alpha": 0.4)"},
                                 {"Polygon", box(45, 5, 90, 145), R"("c": 1e6, "alpha": 0.6)"}});
        write("scene.ini",
              "[terrain]\ndtm = dtm.asc\n[release]\nperimeter = perimeter.geojson\nthickness = 2\n[material]\n"
              "model = structured\n[structured]\nphases = solids-and-fluid\ncohesion = 1e6\n"
              "internal-friction-angle = 28\nbed-friction-angle = 12\nyoung-modulus = 1e6\nbulk-modulus = 1e6\n"
              "[numerics]\nparticles-per-cell = 9\n[time]\nend = 0.2\nframe-interval = 0.2\n"
              "[output]\nmaps = off\nanimation = off\nreport = off\nformats = geotiff, particles-gpkg\n");
    }
    [[nodiscard]] Outcome run(const std::vector<std::string>& set) const {
        return frana(with_sets({"run", "scene.ini", "--out", "result", "--quiet"}, set));
    }
    [[nodiscard]] double number(const std::string& key) const {
        return json_number(read_text(path("result/summary.json")), key);
    }
    [[nodiscard]] Points start() const { return read_points(path("result/frames/particles_0000.gpkg")); }
};

// Loose solids in the west, whose fluid is free from the start; intact material in the east, which confines its fluid.
TEST_F(StructuredPlaces, PolygonsGiveCohesionAndSolidFraction) {
    succeeded(run({"structured.zones=zones.geojson", "structured.cohesion=attribute:c",
                   "structured.solid-fraction=attribute:alpha"}));
    const Points points = start();
    double west = 0, east = 0, held = 0;
    for (std::size_t p = 0; p < points.size(); ++p) {
        const double volume = points.columns.at("volume_m3")[p], confined = points.columns.at("confined_fluid_m3")[p];
        if (points.columns.at("x")[p] < k_west + 45) {
            west += volume;
            EXPECT_EQ(confined, 0);
            EXPECT_EQ(points.columns.at("cohesion_ratio")[p], 0);
        } else {
            east += volume;
            held += confined;
            EXPECT_EQ(points.columns.at("cohesion_ratio")[p], 1);
        }
    }
    EXPECT_NEAR(west, 0.4 * 2000, 1e-6);
    EXPECT_NEAR(east, 2000, 1e-6);
    EXPECT_NEAR(held, 0.4 * 2000, 1e-6);
    EXPECT_NEAR(number("initial_m3"), 4000, 1e-6);
    EXPECT_LT(number("relative_error"), 1e-12);
}

// Depths of solids and of fluid as rasters: their sum is released, their ratio is the solids' fraction.
TEST_F(StructuredPlaces, RastersGiveTheDepthsOfBothPhases) {
    write_dtm([](int, int) { return 1.5; }, true, "solids.asc");
    write_dtm([](int, int column) { return column < 9 ? 0.5 : 1.0; }, true,
              "fluid.asc");  // 45 m from the west
    succeeded(run({"release.thickness=phases:solids.asc,fluid.asc"}));
    const Points points = start();
    EXPECT_NEAR(points.sum("volume_m3") - points.sum("confined_fluid_m3"), 1.5 * 2000, 0.005 * 3000);
    for (std::size_t p = 0; p < points.size(); ++p) {
        const double x = points.columns.at("x")[p] - k_west;
        if (std::abs(x - 45) < k_cell) continue;  // depths are interpolated between cells' centres
        EXPECT_NEAR(points.columns.at("depth_m")[p], x < 45 ? 2 : 2.5, 1e-9);
        EXPECT_NEAR(points.columns.at("confined_fluid_m3")[p] / points.columns.at("volume_m3")[p], x < 45 ? 0.25 : 0.4,
                    1e-9);
    }
}

// Water on the flat ground at the foot, 200 m to 290 m, besides the release.
TEST_F(StructuredPlaces, FluidIsOnTheGroundAtTheStart) {
    write_dtm([](int row, int column) { return column >= 42 && column < 58 && row >= 5 && row < 25 ? 1.5 : -9999; },
              true, "water.asc");
    succeeded(run({"structured.initial-fluid-depth=raster:water.asc"}));
    EXPECT_NEAR(number("initial_m3"), 4000 + 1.5 * 16 * 20 * 25, 1e-6);
    EXPECT_NEAR(start().sum("volume_m3"), 4000, 1e-6);
    EXPECT_LT(number("relative_error"), 1e-12);
}

// Solids that fail later, and a flood through a line: nothing is lost, and the flood has no particles.
TEST_F(StructuredPlaces, SolidsFailLaterAndFluidFlowsIn) {
    write("hydrograph.csv", "time,discharge,velocity\n0,0,2\n0.5,40,2\n1,40,2\n1.5,0,2\n");
    write_features("line", {{"LineString", {{100, 60}, {100, 90}}}});
    succeeded(run({"inflow.line=line.geojson", "inflow.hydrograph=hydrograph.csv", "release.start=1", "time.end=2",
                   "structured.solid-fraction=1"}));
    EXPECT_EQ(start().size(), 0U);
    EXPECT_NEAR(number("inflow_m3"), 40, 1e-9);
    EXPECT_NEAR(number("entered_m3"), 4040, 1e-6);
    EXPECT_LT(number("relative_error"), 1e-12);
    // The last frame: steps may be longer than the interval.
    std::string last;
    for (const auto& file : std::filesystem::directory_iterator(path("result/frames")))
        if (file.path().extension() == ".gpkg") last = std::max(last, file.path().string());
    const Points end = read_points(last);
    EXPECT_NEAR(end.sum("volume_m3"), 4000, 1e-6);
    // A second of sliding on 26.6 degrees with 12 degrees of friction, decelerated or accelerated by the surrounding
    // flow.
    const double angle = std::atan(0.5), gain = 9.81 * (std::sin(angle) - std::cos(angle) * std::tan(12 * M_PI / 180));
    EXPECT_NEAR(end.sum("speed_ms") / static_cast<double>(end.size()), gain, 0.1 * gain);
}

struct Dubious {
    Sets set;
    std::string words;  ///< empty: no warning of any of these
};

const std::string k_sound[] = {"structured.cohesion=2000", "structured.young-modulus=1e7",
                               "structured.bulk-modulus=6e6", "structured.critical-strain=0.05"};

// The release is 2 m thick, the cells are of 5 m: 0.81 tan(30) 5 m = 2.3 m, 0.81 tan(12) 5 m = 0.9 m.
TEST_F(StructuredPlaces, WhatIsLegalAndDubiousIsTold) {
    for (const Dubious& one :
         std::vector<Dubious>{{{}, ""},
                              {{"structured.bed-friction-angle=28"}, "release edges stand"},
                              {{"structured.bed-friction-angle=30", "structured.internal-friction-angle=25"},
                               "5 degrees over the internal"},
                              {{"structured.young-modulus=5e4", "structured.bulk-modulus=6e4"}, "before it yields"},
                              {{"structured.critical-strain=1e-6"}, "before it yields"},
                              {{"structured.cohesion=0", "structured.confined-fraction=0.5"},
                               "confined-fraction has no effect without structured.cohesion"},
                              {{"structured.solid-fraction=1", "structured.confined-fraction=0.5"},
                               "confined-fraction has no effect without structured.solid-fraction < 1"}}) {
        Sets set = one.set;
        for (const std::string& sound : k_sound)
            if (std::none_of(one.set.begin(), one.set.end(), [&](const std::string& own) {
                    return own.starts_with(sound.substr(0, sound.find('=') + 1));
                }))
                set.push_back(sound);
        const Checked checked = check(set);
        ASSERT_FALSE(checked.is_refused()) << checked.told();
        if (!one.words.empty()) {
            expect_words(checked.told(), {one.words});
            continue;
        }
        expect_no_words(checked.told(),
                        {"has no effect", "shear within itself", "before it yields", "release edges stand"});
    }
}

}  // namespace
}  // namespace frana::test
