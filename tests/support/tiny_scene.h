// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "support/program.h"

namespace frana::test {

/// No pictures and no frames, but the report and the page with the map.
inline const std::string k_pages_only = "[output]\nmaps = off\nanimation = off\nframes = off\n";
/// Neither these: a run of a tenth of a second.
inline const std::string k_numbers_only = k_pages_only + "report = off\n";
// In [output]: pictures and the QGIS project show the day of the run, and two runs whose files are compared may have
// midnight between them.
inline const std::string k_one_day = "map-date = 2026-11-24\n";

/// Offsets from the DTM's south-western corner [m].
using Places = std::vector<std::pair<double, double>>;
inline Places box(double west, double south, double east, double north) {
    return {{west, south}, {east, south}, {east, north}, {west, north}};
}
/// A Point, a LineString or a Polygon, whose ring is closed when it is written; its properties as JSON without braces.
struct TestFeature {
    std::string type;
    Places places;
    std::string properties = "";
};
inline std::string named(const std::string& name) {
    return "\"name\": \"" + name + '"';
}

/// A separate folder for every test, with a slope small enough to run in a second: 60 x 30 cells of 5 m in EPSG:32632,
/// 27 degrees falling east to a flat, a release of 50 m x 40 m near the top.
class TinyScene : public ::testing::Test {
  protected:
    TinyScene();
    ~TinyScene() override;

    [[nodiscard]] std::string path(const std::string& name) const { return (folder_ / name).string(); }
    void write(const std::string& name, const std::string& text) const;
    /// Writes dtm.asc; `elevation` by row and column (default: the slope), nodata where it returns less than -9000.
    void write_dtm(const std::function<double(int, int)>& elevation = {}, bool with_crs = true,
                   const std::string& name = "dtm.asc") const;
    /// Writes NAME.geojson in EPSG:32632.
    void write_features(const std::string& name, const std::vector<TestFeature>& features) const;
    /// The same with one polygon and the attribute depth = 2.
    void write_polygon(const std::string& name, const Places& corners) const {
        write_features(name, {{"Polygon", corners, "\"depth\": 2.0"}});
    }
    /// Writes scene.ini with the minimal keys, and these lines after them. Without an [output] in them nothing is
    /// drawn.
    void write_scene(const std::string& more = "") const;
    [[nodiscard]] Outcome frana(const std::vector<std::string>& arguments, int signal_after_ms = 0) const {
        return run_program(folder_.string(), arguments, signal_after_ms);
    }
    /// Runs scene.ini quietly into a result, with these keys; throws unless it succeeds.
    Outcome ran(const std::string& result = "result", const std::vector<std::string>& sets = {},
                const std::source_location& place = std::source_location::current()) const {
        return succeeded(frana(with_sets({"run", "scene.ini", "--out", result, "--quiet"}, sets)), place);
    }
    /// Returns every file below the folder, sorted, as relative paths.
    [[nodiscard]] std::vector<std::string> files() const;

    std::filesystem::path folder_;
};

inline constexpr double k_west = 527000, k_south = 5094000, k_cell = 5;
inline constexpr int k_columns = 60, k_rows = 30;

/// A friction table of one return period (30 years), one class of terrain and one volume, with forest.
inline std::string own_friction_table(double mu) {
    return "[table]\ntitle = Own\nsource = None\nreturn-periods = 30\n[forest]\nmore-friction = 0.05\nturbulence = "
           "400\n"
           "[class-1]\nname = All\n30-years-from-0-m3 = " +
           std::to_string(mu) + " 1000\n";
}

/// A hazard scheme of three classes, the upper two by limits of one quantity, with the matrix of Bern.
/// @param quantity "depth > "  @param lower, upper "0.5 m"
inline std::string own_scheme(const std::string& quantity, const std::string& lower, const std::string& upper) {
    return "[scheme]\ntitle = Own\nsource = None\n[class-1]\nname = Low\ncolour = bae4b3\n[class-2]\nname = "
           "Middle\ncolour = 5d966f\ncondition = " +
           quantity + lower + "\n[class-3]\nname = High\ncolour = 00441b\ncondition = " + quantity + upper +
           "\n[degree]\nreturn-periods = 30, 100, 300\nstrong = red, red, red\nmedium = red, blue, blue\n"
           "weak = blue, blue, yellow\n";
}

}  // namespace frana::test
