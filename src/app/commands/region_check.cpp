// SPDX-License-Identifier: Apache-2.0
#include "app/commands/region_check.h"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <set>

#include "app/input/prepare_release.h"
#include "app/store/result_place.h"
#include "app/study/plan/region_input.h"
#include "app/text/number_text.h"
#include "app/text/text_table.h"
#include "core/geometry.h"
#include "core/text.h"

namespace frana::app {
namespace {

constexpr std::size_t k_listed = 30;  // a screen; members.csv has all

SlopePlan plan_of(const study::StudyInput& input, std::size_t member) {
    const study::Slope& slope = input.slopes[member];
    SlopePlan plan{area(slope.outline), std::nullopt, slope.problem};
    if (!plan.problem.empty()) return plan;
    const auto note = [&](const Error& error) { plan.problem = describe(error.problems().front()); };
    attempt(note, [&] {
        RunLog silent(true);
        SceneReading reading = input.member(member);
        reading.session.reads = std::make_shared<RememberedReads>();
        study::cut_terrain(*input.reading.study.region, reading, silent);
        Problems problems;
        std::vector<UsedFile> files;
        prepare_release(reading, nullptr, files, silent, problems);  // its own columns
        problems.throw_if_any();
        plan.window = reading.scene.terrain.bounds;
    });
    return plan;
}

std::string window_text(const SlopePlan& plan, double cell) {
    if (!plan.window) return "the whole DTM";
    return grouped(plan.window->width() / cell) + " x " + grouped(plan.window->height() / cell) + " cells";
}

std::string label_of(const study::StudyInput& input, std::size_t member) {
    const study::Slope& slope = input.slopes[member];
    return std::to_string(member) + (slope.name.empty() ? "" : " " + slope.name) +
           (slope.scenario.empty() ? "" : ", scenario " + slope.scenario);
}

void print_scenarios(const study::StudyInput& input) {
    std::set<std::string> scenarios;
    for (const study::Slope& slope : input.slopes) {
        if (slope.scenario.empty()) continue;
        const auto& years = slope.return_period;
        scenarios.insert(slope.scenario + (years ? " (" + shortest_text(*years) + " years)" : ""));
    }
    std::string text;
    for (const std::string& one : scenarios) text += (text.empty() ? "" : ", ") + one;
    if (!text.empty()) print_fact("scenarios", text);
}

}  // namespace

std::vector<SlopePlan> slope_plans(const study::StudyInput& input) {
    std::vector<SlopePlan> plans;
    for (std::size_t i = 0; i < input.slopes.size(); ++i) plans.push_back(plan_of(input, i));
    return plans;
}

double region_seconds(const std::vector<SlopePlan>& plans, const StudyForecast& forecast, int threads) {
    double largest = 0, all = 0;
    for (const SlopePlan& plan : plans) {
        largest = std::max(largest, plan.area);
        if (plan.problem.empty()) all += plan.area;
    }
    return forecast.writing.seconds + (largest > 0 ? forecast.member_seconds() * all / largest / threads : 0);
}

void print_region(const study::StudyInput& input, const std::vector<SlopePlan>& plans, const StudyForecast& forecast,
                  int threads, const std::string& target) {
    const study::StudySpec& study = input.reading.study;
    std::printf("Region %s is ready to run.\n\nScene %s\n\nSlopes\n", study.file.c_str(), study.scene.c_str());
    const double cell = input.base.scene.grid.cell_size;
    const auto fails = [](const SlopePlan& plan) { return !plan.problem.empty(); };
    for (std::size_t i = 0; i < std::min(k_listed, plans.size()); ++i)
        if (!fails(plans[i]))
            print_fact(label_of(input, i), grouped(plans[i].area) + " m2 on " + window_text(plans[i], cell));
    if (plans.size() > k_listed) print_fact("...", "and " + std::to_string(plans.size() - k_listed) + " more");
    const auto failing = std::count_if(plans.begin(), plans.end(), fails);
    if (failing > 0) std::printf("\nSlopes that fail\n");
    for (std::size_t i = 0; i < plans.size(); ++i)
        if (fails(plans[i])) print_fact(label_of(input, i), plans[i].problem);
    std::printf("\nAll\n");
    print_fact("slopes",
               std::to_string(plans.size()) + (failing == 0 ? "" : ", of which " + std::to_string(failing) + " fail"));
    print_scenarios(input);
    for (const study::RegionSpec::Column& one : study.region->columns) print_fact(one.key, "column " + one.column);
    if (const auto& exposed = input.base.extra.exposure)
        print_fact("exposed", grouped(static_cast<double>(exposed->features.size())) + " features");
    print_fact("estimated time", std::string(forecast.trial ? "about " : "at least ") +
                                     duration_text(region_seconds(plans, forecast, threads)) +
                                     ", by the areas: " + duration_text(forecast.member_seconds()) +
                                     " for the largest slope on one thread, " + std::to_string(threads) +
                                     " at a time, and " + duration_text(forecast.writing.seconds) +
                                     " of writing and drawing");
    print_fact("memory", bytes_text(static_cast<double>(forecast.peak_bytes)) + ", of which the largest slope takes " +
                             bytes_text(static_cast<double>(forecast.worker_bytes)));
    print_fact("disk", disk_text(forecast));
    print_fact("result",
               target + (has_files(target) ? ", which contains a result already: --overwrite replaces it" : ""));
    std::fflush(stdout);
}

Json slopes_json(const study::StudyInput& input, const std::vector<SlopePlan>& plans) {
    const auto text = [](const std::string& value) { return value.empty() ? Json() : Json(value); };
    Json list = Json::array();
    for (std::size_t i = 0; i < plans.size(); ++i) {
        const study::Slope& slope = input.slopes[i];
        const SlopePlan& plan = plans[i];
        const auto& box = plan.window;
        list.push_back({{"member", i},
                        {"name", text(slope.name)},
                        {"group", text(slope.group)},
                        {"scenario", text(slope.scenario)},
                        {"return_period", slope.return_period ? Json(*slope.return_period) : Json()},
                        {"area_m2", plan.area},
                        {"window", box ? Json::array({box->west, box->south, box->east, box->north}) : Json()},
                        {"problem", text(plan.problem)}});
    }
    return list;
}

}  // namespace frana::app
