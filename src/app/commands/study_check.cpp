// SPDX-License-Identifier: Apache-2.0
#include "app/commands/study_check.h"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/commands/command_line.h"
#include "app/input/check_inputs.h"
#include "app/input/memory_bound.h"
#include "app/input/prepare_release.h"
#include "app/input/prepare_zones.h"
#include "app/process/machine_memory.h"
#include "app/store/result_directory.h"
#include "app/study/plan/calibration_input.h"
#include "app/study/plan/region_input.h"
#include "app/study/publish/publish_calibration.h"
#include "app/study/publish/scheme_check.h"
#include "app/study/publish/study_files.h"
#include "app/text/number_text.h"
#include "app/text/text_table.h"
#include "core/geometry.h"
#include "core/text.h"
#include "simulation/simulation.h"

namespace frana::app {
namespace {

/// What is known of a slope before it runs.
struct SlopePlan {
    double area = 0;               ///< of its polygons [m2]
    std::optional<Bounds> window;  ///< of the terrain; none: the whole DTM, or it fails
    std::string problem;           ///< why it fails; empty: it runs
};

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

void print_scheme(const study::StudyInput& input) {
    if (const auto scheme = study::common_scheme(input))
        print_fact("scheme", word_of(*scheme, k_schemes) + "; two members again by the other one, as a check");
}

/// Returns the plan of each slope of a region, in order.
std::vector<SlopePlan> slope_plans(const study::StudyInput& input) {
    std::vector<SlopePlan> plans;
    for (std::size_t i = 0; i < input.slopes.size(); ++i) plans.push_back(plan_of(input, i));
    return plans;
}

/// Returns the time of all slopes together [s], by their areas.
double region_seconds(const std::vector<SlopePlan>& plans, const StudyForecast& forecast, int threads) {
    double largest = 0, all = 0;
    for (const SlopePlan& plan : plans) {
        largest = std::max(largest, plan.area);
        if (plan.problem.empty()) all += plan.area;
    }
    return forecast.writing.seconds + (largest > 0 ? forecast.member_seconds() * all / largest / threads : 0);
}

/// Prints the slopes of a region, the terrain of each, those that would fail and why, and the cost of all.
/// @param forecast of its largest slope
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
    print_scheme(input);
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

/// Returns the list `slopes` of --json.
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

// Of a record: three Float32 numbers for each cell that the flow reached. Flows spread to about so many times their
// release in the samples.
constexpr std::int64_t k_record_cell_bytes = 12, k_spread = 10, k_record_head_bytes = 2000;
// Of the window of cells, and of the rasters made of a quantity at once.
constexpr std::int64_t k_window_bytes = 256'000'000, k_rasters_at_once = 16;
// Particles split where the flow spreads thin.
constexpr double k_growth = 2;

const char* use_of(study::TableColumn::Use use) {
    switch (use) {
        case study::TableColumn::Use::key:
            return "varied";
        case study::TableColumn::Use::weight:
            return "weight of the member";
        case study::TableColumn::Use::result:
            break;
    }
    return "a value of an earlier study, not used";
}

double study_seconds(const StudyForecast& forecast, std::size_t members, int threads) {
    return forecast.member_seconds() * static_cast<double>(members) / threads + forecast.writing.seconds;
}

std::string time_text(const StudyForecast& forecast, std::size_t members, int threads) {
    return std::string(forecast.trial ? "about " : "at least ") +
           duration_text(study_seconds(forecast, members, threads)) + ": " + duration_text(forecast.member_seconds()) +
           " a member on one thread, " + std::to_string(threads) + " at a time, and " +
           duration_text(forecast.writing.seconds) + " of writing and drawing";
}

void print_study(const study::StudyInput& input, const StudyForecast& forecast, int threads,
                 const std::string& directory) {
    const study::StudySpec& study = input.reading.study;
    std::printf("Study %s is ready to run.\n\nScene %s\n\nKeys that vary\n", study.file.c_str(), study.scene.c_str());
    for (const study::Variation& one : study.vary) print_fact(one.key, one.distribution.text);
    if (study.vary.empty())
        for (const std::string& key : input.table.keys)
            print_fact(key, study.per_polygon() ? "a polygon for each member" : "as in " + study.table);
    for (const study::TableColumn& column : input.table.columns)
        if (column.use != study::TableColumn::Use::key) print_fact(column.name, use_of(column.use));
    for (const study::Correlation& one : study.correlate)
        print_fact(one.first, "rank correlation with " + one.second + " " + number_text(one.rho));
    std::printf("\nMembers\n");
    const auto members = input.members();
    print_fact("members", std::to_string(members) + (study.until ? " at most" : "") + ", sampling " +
                              study::name_of(study.sampling) +
                              (study.per_polygon() ? "" : ", seed " + std::to_string(study.seed)));
    if (const auto& exposed = input.base.extra.exposure)
        print_fact("exposed", grouped(static_cast<double>(exposed->features.size())) + " features");
    print_scheme(input);
    print_fact("estimated time", time_text(forecast, members, threads));
    print_fact("memory", bytes_text(static_cast<double>(forecast.peak_bytes)) +
                             ", of which each member that runs takes " +
                             bytes_text(static_cast<double>(forecast.worker_bytes)));
    print_fact("disk", disk_text(forecast));
    const std::string target = result_path(directory);
    print_fact("result",
               target + (has_files(target) ? ", which contains a result already: --overwrite replaces it" : ""));
    std::fflush(stdout);
}

}  // namespace

std::string disk_text(const StudyForecast& forecast) {
    return "about " + bytes_text(forecast.writing.disk_bytes) + "; until it is complete " +
           bytes_text(static_cast<double>(forecast.disk_bytes)) + " more for the members";
}

double StudyForecast::member_seconds() const noexcept {
    return engine_seconds(member, trial);
}

std::string study_directory(const study::StudySpec& study, const SceneSpec& scene) {
    return output_directory(scene) + (study.region ? "-region" : "-ensemble");
}

StudyForecast forecast_study(const study::StudyInput& input, int threads, bool with_trial) {
    const Prepared& base = input.base;
    StudyForecast forecast;
    forecast.member = estimate(base.scene, 1);
    if (with_trial) forecast.trial = estimate_time(input.central, base, forecast.member, 1);
    const std::int64_t most =
        forecast.trial ? forecast.trial->particles_peak
                       : static_cast<std::int64_t>(k_growth * static_cast<double>(forecast.member.particles));
    forecast.worker_bytes = forecast.member.memory_bytes + forecast.member.bytes_of_particles(std::max<std::int64_t>(
                                                               0, most - forecast.member.particles));
    const std::int64_t combining =
        k_window_bytes + forecast.member.stored_cells * k_rasters_at_once * static_cast<std::int64_t>(sizeof(double));
    forecast.peak_bytes = resident_memory() + std::max(threads * forecast.worker_bytes, combining);
    const auto released = static_cast<std::int64_t>(base.release.area_m2 / base.scene.grid.cell_area());
    const auto records = static_cast<std::int64_t>(input.members());
    forecast.disk_bytes = records * (k_record_head_bytes + k_record_cell_bytes * k_spread * released);
    forecast.writing = forecast_study_writing(input, forecast.member, forecast.trial, threads);
    if (input.reading.study.is_extensible())  // k_joined_records
        forecast.writing.disk_bytes += static_cast<double>(forecast.disk_bytes);
    return forecast;
}

void refuse_study_beyond_memory(const study::StudyInput& input, const StudyForecast& forecast, int threads,
                                int processes) {
    const MemoryBound bound = usable_memory(input.reading.session);
    const double needed = static_cast<double>(forecast.peak_bytes) * processes;
    if (needed <= bound.bytes) return;
    throw Error(
        ErrorKind::input,
        Problem{"the study needs about " + bytes_text(needed) + " of memory, " +
                    bytes_text(static_cast<double>(forecast.worker_bytes)) + " for each member that runs",
                input.reading.label,
                std::to_string(threads) + " threads" +
                    (processes > 1 ? " in each of " + std::to_string(processes) + " ranks on this machine" : ""),
                bound_text(bound), "Use fewer --threads or ranks, larger cells, or provide more memory"});
}

Json check_study(const std::string& path, const std::optional<std::string>& out, int threads, bool print,
                 const Session& session, RunLog& log) {
    study::StudyTexts texts = study::read_study_texts(path, session, log);
    const std::string directory = out.value_or(study_directory(texts.reading.study, texts.central.scene));
    const std::optional<Problem> place = check_result_directory(
        directory, Older::unknown, {}, out ? "--out" : "the result's place", texts.central.problems);
    const study::StudyInput input = study::prepare_study(std::move(texts), place, log);
    study::load_study_drawing(input, Loading::later);
    const StudyForecast forecast = forecast_study(input, threads, true);
    refuse_study_beyond_memory(input, forecast, threads);
    const study::StudySpec& study = input.reading.study;
    const std::vector<SlopePlan> plans = study.region ? slope_plans(input) : std::vector<SlopePlan>{};
    if (print && study.region)
        print_region(input, plans, forecast, threads, result_path(directory));
    else if (print)
        print_study(input, forecast, threads, directory);
    if (print && input.base.friction)
        print_fact("friction",
                   study::shown_friction(input).of + ": " + friction_text(input.base.friction->choice()).text());
    warn_of_release(input.base.scene, log);
    study::warn_of_unknown_exposure(input, log);
    const auto members = input.members();
    Json json = document_of("check");
    Warnings warnings = input.base.scene.warnings;
    json["warnings"] = texts_of(warnings += log.take_warnings());
    json["study"] = study.file;
    json["scene"] = study.scene;
    json["members"] = members;
    json["sampling"] = study::name_of(study.sampling);
    json["keys"] = input.table.keys;
    for (const study::TableColumn& column : input.table.columns)
        json["columns"].push_back({{"name", column.name}, {"use", use_of(column.use)}});
    json["run"] = {{"threads", threads},
                   {"estimated_seconds", study.region ? region_seconds(plans, forecast, threads)
                                                      : study_seconds(forecast, members, threads)},
                   {"estimate_is_lower_bound", !forecast.trial.has_value()},
                   {"memory_bytes", forecast.peak_bytes},
                   {"disk_bytes", forecast.writing.disk_bytes},
                   {"members_disk_bytes", forecast.disk_bytes}};
    if (study.region) json["slopes"] = slopes_json(input, plans);
    if (const auto& exposed = input.base.extra.exposure) json["exposed_features"] = exposed->features.size();
    const std::string target = result_path(directory);
    json["result"] = {{"folder", target}, {"exists", has_files(target)}};
    return json;
}

namespace {

/// Expected resources of all members.
struct CalibrationForecast {
    double seconds = 0;  ///< wall time of all members on one thread
    std::int64_t peak_bytes = 0, disk_bytes = 0;
    WritingForecast writing;
    bool trial = true;  ///< for all events

    void add(const StudyForecast& one, double members, double table_size) {
        seconds += one.member_seconds() * members;
        peak_bytes = std::max(peak_bytes, one.peak_bytes);
        disk_bytes += static_cast<std::int64_t>(static_cast<double>(one.disk_bytes) * members / table_size);
        trial = trial && one.trial.has_value();
    }
    void write(const WritingForecast& one) {
        writing.seconds += one.seconds;
        writing.disk_bytes += one.disk_bytes;
    }
};

CalibrationForecast forecast(const study::CalibrationInput& input, int threads) {
    CalibrationForecast all;
    for (std::size_t e = 0; e < input.events(); ++e) {
        const StudyForecast own = forecast_study(input.own[e], threads, true);
        refuse_study_beyond_memory(input.own[e], own, threads);
        all.add(own, static_cast<double>(input.spec().study.samples), static_cast<double>(input.design.size()));
        all.write(forecast_event_writing(input.own[e].base, own.member));
    }
    return all;
}

void print_keys(const std::vector<study::Variation>& vary, const std::string& of) {
    for (const study::Variation& one : vary) print_fact(one.key + of, one.distribution.text);
}

void print_event(const study::CalibrationInput& input, std::size_t e) {
    const study::EventSpec& event = input.spec().events[e];
    print_fact(event.name, event.members.study.scene);
    std::string measures;
    for (const study::Weight& one : input.spec().objective)
        if (study::has_evidence(input.own[e].base, event, study::row_of(one.measure).needs))
            measures += (measures.empty() ? "" : ", ") + std::string(study::row_of(one.measure).name) + " " +
                        shortest_text(one.weight);
    print_fact("", "compared by " + measures);
    print_fact("", "cells of " + shortest_text(input.own[e].base.scene.grid.cell_size) + " m");
}

void print_calibration(const study::CalibrationInput& input, const CalibrationForecast& expected, int threads,
                       const std::string& directory) {
    const study::CalibrationSpec& calibration = input.spec();
    std::printf("Calibration %s is ready to run.\n\nEvents\n", calibration.study.file.c_str());
    for (std::size_t e = 0; e < input.events(); ++e) print_event(input, e);
    std::printf("\nKeys that vary\n");
    print_keys(calibration.study.vary, "");
    for (const study::EventSpec& event : calibration.events) print_keys(event.vary, " of " + event.name);
    for (const study::Correlation& one : calibration.study.correlate)
        print_fact(one.first, "rank correlation with " + one.second + " " + number_text(one.rho));
    std::printf("\nMembers\n");
    print_fact("members", std::to_string(input.design.size()) + " first, then until the intervals settle, at most " +
                              std::to_string(calibration.study.samples) + ", each for " +
                              std::to_string(input.events()) + (input.events() == 1 ? " event" : " events") +
                              "; sampling " + study::name_of(calibration.study.sampling) + ", seed " +
                              std::to_string(calibration.study.seed));
    print_fact("estimated time", std::string(expected.trial ? "at most about " : "at least ") +
                                     duration_text(expected.seconds / threads + expected.writing.seconds) + ", " +
                                     std::to_string(threads) + " at a time, of which " +
                                     duration_text(expected.writing.seconds) + " of writing and drawing");
    print_fact("memory", bytes_text(static_cast<double>(expected.peak_bytes)));
    print_fact("disk", "about " + bytes_text(expected.writing.disk_bytes) + "; until it is complete " +
                           bytes_text(static_cast<double>(expected.disk_bytes)) + " more for the members");
    const std::string target = result_path(directory);
    print_fact("result",
               target + (has_files(target) ? ", which contains a result already: --overwrite replaces it" : ""));
    std::fflush(stdout);
}

}  // namespace

std::string calibration_directory(const SceneSpec& scene) {
    return output_directory(scene) + "-calibration";
}

Json check_calibration(const std::string& path, const std::optional<std::string>& out, int threads, bool print,
                       const Session& session, RunLog& log) {
    study::CalibrationTexts texts = study::read_calibration_texts(path, session, log);
    const std::string directory = out.value_or(calibration_directory(texts.first_scene.scene));
    const std::optional<Problem> place =
        check_result_directory(directory, Older::unknown, {}, out ? "--out" : "the result's place", texts.problems);
    const study::CalibrationInput input = study::prepare_calibration(std::move(texts), place, log);
    study::load_calibration_drawing(input, Loading::later);
    const study::CalibrationSpec& calibration = input.spec();
    const CalibrationForecast expected = forecast(input, threads);
    if (print) print_calibration(input, expected, threads, directory);
    Warnings warnings;
    for (const study::StudyInput& event : input.own) {
        warn_of_release(event.base.scene, log);
        warnings += event.base.scene.warnings;
    }
    Json json = document_of("check");
    json["warnings"] = texts_of(warnings += log.take_warnings());
    json["study"] = calibration.study.file;
    json["events"] = Json::array();
    for (const study::EventSpec& event : calibration.events)
        json["events"].push_back({{"name", event.name}, {"scene", event.members.study.scene}});
    json["members"] = calibration.study.samples;
    json["first_members"] = input.design.size();
    json["run"] = {{"threads", threads},
                   {"estimated_seconds", expected.seconds / threads + expected.writing.seconds},
                   {"estimate_is_lower_bound", !expected.trial},
                   {"memory_bytes", expected.peak_bytes},
                   {"disk_bytes", expected.writing.disk_bytes},
                   {"members_disk_bytes", expected.disk_bytes}};
    const std::string target = result_path(directory);
    json["result"] = {{"folder", target}, {"exists", has_files(target)}};
    return json;
}

}  // namespace frana::app
