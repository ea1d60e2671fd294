// SPDX-License-Identifier: Apache-2.0
// Texts of a report that are composed of several rows of the tables of words.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "app/publish/publish.h"
#include "app/publish/report_tables.h"
#include "app/publish/summary.h"
#include "app/text/number_text.h"
#include "simulation/run_summary.h"
#include "simulation/run_warnings.h"

namespace frana::app {
namespace {

const Words k_german(Language::german), k_french(Language::french);

TEST(ReportWords, AValueAtAPlaceKeepsItsName) {
    RunResult result;
    Scene scene;
    scene.recording.gauges.push_back({"{1}: x", {}});
    result.gauges.push_back({});
    const GridSpec grid{0, 0, 1, 1, 1, "", 0, 0};
    for (const char* name : {"max_depth", "max_velocity", "bed", "release"}) result.add(name, Raster(grid, 1.0));
    const std::vector<RunValue> values = reported_values(result, scene, 0.5);
    const auto title = [&](const std::string& key) {
        return std::find_if(values.begin(), values.end(), [&](const RunValue& one) { return one.key == key; })->title;
    };
    EXPECT_EQ(title("gauge {1}: x: max_depth_m").in(k_german), "{1}: x: Maximale Fließtiefe");
    EXPECT_EQ(title("gauge {1}: x: max_depth_m").text(), "{1}: x: Maximum depth");
    EXPECT_EQ(title("runout_m").in(k_french), "Distance de propagation");
}

/// Three levels whose only value settles slowly.
AccuracyRecord record(double finest) {
    AccuracyRecord all{0.025, finest, 10, 5, {}};
    for (const auto& [size, value] : {std::pair{20.0, 10.0}, std::pair{10.0, 12.0}, std::pair{5.0, 13.5}})
        all.levels.push_back({size, 100, 10, 1, 0, 0, {{"max_depth_m", "Maximum depth", "m", value, 0, 0}}, ""});
    return all;
}

TEST(WarningsOfAResult, AreToldOnceAndLimitTheUseOfMaps) {
    const Warnings all{{worded("it was cut"), true}, {worded("a number of the computation")}};
    EXPECT_EQ(texts_of(limits_of_use(all)), std::vector<std::string>{"it was cut"});
    EXPECT_EQ(texts_of(without(all, {worded("it was cut")})), std::vector<std::string>{"a number of the computation"});
    RunLog log(true);
    Warnings known{all[0]};
    const Findings found{log, known};
    log.tell({all[1]});  // known to the result already
    found.warn(worded("it left the map"));
    EXPECT_EQ(texts_of(known), (std::vector<std::string>{"it was cut", "it left the map"}));
    EXPECT_EQ(log.text().find("it was cut"), std::string::npos);
    EXPECT_NE(log.text().find("WARNING: it left the map"), std::string::npos);
    EXPECT_NE(log.text().find("WARNING: a number of the computation"), std::string::npos);
}

TEST(ReportWords, TheVerdictOnAccuracyIsInTheLanguage) {
    EXPECT_EQ(accuracy_verdict({0.05, 2, 2, 2, {}}).text(),
              "numerics.accuracy = 5 % not estimated, too few coarser levels; cells of 2 m");
    const std::string german = accuracy_verdict(record(2.5)).in(k_german);
    EXPECT_EQ(german.find("numerics.accuracy = 2,5 % nicht eingehalten von 1 der 1 Werte: Maximale Fließtiefe ("), 0U)
        << german;
    EXPECT_NE(german.find("Zellen von 5 m"), std::string::npos) << german;
    EXPECT_NE(german.find("feiner als das DGM (10 m)"), std::string::npos) << german;
    EXPECT_EQ(german.find(" the "), std::string::npos) << german;
}

TEST(ReportWords, AValueThatDivergesHasNoBar) {
    AccuracyRecord all = record(5);
    all.levels[1].values[0].value = 11;  // 10, 11, 13.5: each change is greater than the one before
    const std::string lines = estimate_lines(value_estimates(all)), verdict = accuracy_verdict(all).text();
    EXPECT_NE(lines.find(", not converged; diverging"), std::string::npos) << lines;
    EXPECT_EQ(lines.find("estimated error"), std::string::npos) << lines;
    EXPECT_NE(verdict.find("Maximum depth (not converging)"), std::string::npos) << verdict;
}

TEST(ReportWords, AnInputIsDescribedInTheLanguage) {
    UsedFile file;
    file.role = "Zones: zones.cohesion";
    file.resampling = "average";
    file.crs_label = "EPSG:32632";
    file.content = "1 300 x 270\n0.5 x 0.5\nFloat32, m (assumed)\nrotated";
    file.transform.operation = "UTM zone 32N";
    file.transform.accuracy_m = 0.5;
    EXPECT_EQ(role_in(file, k_german), "Zonen: zones.cohesion (average)");
    EXPECT_EQ(content_in(file, k_german), "1.300 × 270\n0,5 × 0,5\nFloat32, m (angenommen)\ngedreht");
    EXPECT_EQ(operation_in(file, k_german), "UTM zone 32N; ± 0,5 m");
    EXPECT_EQ(operation_in(file, Words()), "UTM zone 32N; ± 0.5 m");
    file.content = "polygons: 2\n63 071 m2";
    EXPECT_EQ(content_in(file, k_german), "Polygone: 2\n63.071 m²");
    file.transform = {};
    EXPECT_EQ(operation_in(file, k_french), "–");
    file.crs_label = "";
    EXPECT_EQ(operation_in(file, k_french), "");
}

TEST(UnitSign, IsThatOfPrint) {
    EXPECT_EQ(unit_sign("m3/s"), "m³/s");
    EXPECT_EQ(unit_sign("degrees"), "°");
    EXPECT_EQ(unit_sign("kg/m3"), "kg/m³");
    EXPECT_EQ(unit_sign("s/m^(1/3)"), "s/m^(1/3)");
    EXPECT_EQ(unit_sign(""), "");
}

}  // namespace
}  // namespace frana::app
