// SPDX-License-Identifier: Apache-2.0
#include "app/commands/region_check.h"

#include <algorithm>
#include <cstdio>
#include <set>

#include "app/ensemble/region_input.h"
#include "app/store/result_place.h"
#include "app/text/number_text.h"
#include "app/text/text_table.h"
#include "core/geometry.h"
#include "core/shortest_text.h"

namespace frana::app {
namespace {

constexpr std::size_t k_listed = 30;  // a screen; members.csv has all

void line(const std::string& name, const std::string& value) {
    std::printf("  %-16s %s\n", name.c_str(), value.c_str());
}

/// What is known of a slope before it runs.
struct SlopePlan {
    std::string window, problem;
};

SlopePlan plan_of(const StudyInput& input, std::size_t member) {
    SlopePlan plan{"", input.slopes[member].problem};
    if (!plan.problem.empty()) return plan;
    try {
        gis::RememberedReads own;
        const gis::UseRemembered remember(own);
        RunLog silent(true);
        SceneReading reading = input.member(member);
        cut_terrain(*input.reading.study.region, reading, silent);
        const double cell = input.base.scene.grid.cell_size;
        const auto& box = reading.scene.terrain.bounds;
        plan.window =
            box ? grouped(box->width() / cell) + " x " + grouped(box->height() / cell) + " cells" : "the whole DTM";
    } catch (const Error& error) {
        plan.problem = describe(error.problems().front());
    }
    return plan;
}

std::string label_of(const StudyInput& input, std::size_t member) {
    const Slope& slope = input.slopes[member];
    return std::to_string(member) + (slope.name.empty() ? "" : " " + slope.name) +
           (slope.scenario.empty() ? "" : ", scenario " + slope.scenario);
}

void print_scenarios(const StudyInput& input) {
    std::set<std::string> scenarios;
    for (const Slope& slope : input.slopes) {
        if (slope.scenario.empty()) continue;
        const auto& years = slope.return_period;
        scenarios.insert(slope.scenario + (years ? " (" + shortest_text(*years) + " years)" : ""));
    }
    std::string text;
    for (const std::string& one : scenarios) text += (text.empty() ? "" : ", ") + one;
    if (!text.empty()) line("scenarios", text);
}

}  // namespace

void print_region(const StudyInput& input, const StudyForecast& forecast, int threads, const std::string& target) {
    const study::StudySpec& study = input.reading.study;
    std::printf("Region %s is ready to run.\n\nScene %s\n\nSlopes\n", study.file.c_str(), study.scene.c_str());
    double largest = 0, all = 0;
    std::vector<std::pair<std::size_t, std::string>> failing;
    for (std::size_t i = 0; i < input.slopes.size(); ++i) {
        const double size = area(input.slopes[i].outline);
        largest = std::max(largest, size);
        all += size;
        const SlopePlan plan = plan_of(input, i);
        if (!plan.problem.empty())
            failing.emplace_back(i, plan.problem);
        else if (i < k_listed)
            line(label_of(input, i), grouped(size) + " m2 on " + plan.window);
    }
    if (input.slopes.size() > k_listed) line("...", "and " + std::to_string(input.slopes.size() - k_listed) + " more");
    if (!failing.empty()) std::printf("\nSlopes that fail\n");
    for (const auto& [member, problem] : failing) line(label_of(input, member), problem);
    std::printf("\nAll\n");
    line("slopes", std::to_string(input.slopes.size()) +
                       (failing.empty() ? "" : ", of which " + std::to_string(failing.size()) + " fail"));
    print_scenarios(input);
    for (const study::RegionSpec::Column& one : study.region->columns) line(one.key, "column " + one.column);
    const double seconds = largest > 0 ? forecast.member_seconds() * all / largest / threads : 0;
    line("estimated time", std::string(forecast.trial ? "about " : "at least ") + duration_text(seconds) +
                               ", engine alone, by the areas: " + duration_text(forecast.member_seconds()) +
                               " for the largest slope on one thread, " + std::to_string(threads) + " at a time");
    line("memory", bytes_text(static_cast<double>(forecast.peak_bytes)) + ", of which the largest slope takes " +
                       bytes_text(static_cast<double>(forecast.worker_bytes)));
    line("disk", "at most about " + bytes_text(static_cast<double>(forecast.disk_bytes)) +
                     " for the slopes until the result is complete");
    line("result", target + (has_files(target) ? ", which contains a result already: --overwrite replaces it" : ""));
    std::fflush(stdout);
}

}  // namespace frana::app
