// SPDX-License-Identifier: Apache-2.0
#include "app/commands/study_check.h"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>
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
#include "app/study/pool/calibration_runs.h"
#include "app/study/pool/member_runs.h"
#include "app/study/publish/publish_study.h"
#include "app/study/publish/scheme_check.h"
#include "app/text/number_text.h"
#include "app/text/text_table.h"
#include "core/geometry.h"
#include "core/text.h"
#include "params/keys/laws.h"
#include "params/scene/write_scene.h"
#include "simulation/simulation.h"

namespace frana::app {
namespace {

/// What is known of a slope before it runs.
struct SlopePlan {
    double area = 0;      ///< of its polygons [m2]
    std::string problem;  ///< why it fails; empty: it runs
};

constexpr std::size_t k_listed = 30;  // a screen; members.csv has all

SlopePlan plan_of(const study::StudyInput& input, std::size_t member) {
    const study::Slope& slope = input.slopes[member];
    SlopePlan plan{area(slope.outline), slope.problem};
    if (!plan.problem.empty()) return plan;
    if (const Bounds all = input.base.scene.grid.bounds(), own = bounds(slope.outline);
        !slope.outline.empty() && are_apart(all, own)) {
        plan.problem = describe(Problem{"the polygon lies outside the DTM", input.central.where("release.perimeter"),
                                        extent_text(own), extent_text(all),
                                        "Check the coordinate reference systems of both files"});
        return plan;
    }
    const auto note = [&](const Error& error) { plan.problem = describe(error.problems().front()); };
    attempt(note, [&] {
        RunLog silent(true);
        Warnings unused;
        SceneReading reading = input.member(input.first_member(member));
        reading.session.reads = std::make_shared<RememberedReads>();
        Problems problems;
        std::vector<UsedFile> files;
        prepare_release(reading, nullptr, files, {silent, unused}, problems);  // its own columns
        problems.throw_if_any();
    });
    return plan;
}

std::string label_of(const study::Slope& slope, std::size_t member) {
    return std::to_string(member) + (slope.name.empty() ? "" : " " + slope.name) +
           (slope.scenario.empty() ? "" : ", scenario " + slope.scenario);
}

/// What all members of a study need.
struct StudyCost {
    double seconds = 0;           ///< wall time of computing on one thread
    bool is_lower_bound = false;  ///< of the time: not every scene could be tried
    bool may_end_early = false;   ///< not all members may run
    std::int64_t peak_bytes = 0, worker_bytes = 0;

    void add(double more_seconds, const StudyForecast& one) {
        seconds += more_seconds;
        peak_bytes = std::max(peak_bytes, one.peak_bytes);
        worker_bytes = std::max(worker_bytes, one.worker_bytes);
    }
};

/// The facts that every check of a study ends with.
void print_end(const StudyCost& cost, int threads, const std::string& directory) {
    print_fact("estimated time", std::string(cost.is_lower_bound  ? "at least "
                                             : cost.may_end_early ? "at most about "
                                                                  : "about ") +
                                     duration_text(cost.seconds / threads) + " of computing, " +
                                     std::to_string(threads) + " members at a time");
    print_fact("memory", bytes_text(static_cast<double>(cost.peak_bytes)) +
                             ", of which a member that runs takes up to " +
                             bytes_text(static_cast<double>(cost.worker_bytes)));
    print_result(directory);
    std::fflush(stdout);
}

void add_end(const StudyCost& cost, int threads, const std::string& directory, Json& json) {
    json["run"] = {{"threads", threads},
                   {"estimated_seconds", cost.seconds / threads},
                   {"estimate_is_lower_bound", cost.is_lower_bound},
                   {"memory_bytes", cost.peak_bytes}};
    json["result"] = result_json(directory);
}

/// Returns the mean wall time of members that are run as a trial, spread over all [s]; none if one takes too long: then
/// larger cells must do.
std::optional<double> tried_seconds(const study::StudyInput& input) {
    constexpr double k_trial = 3, k_first = 6;  // [s]
    constexpr std::size_t k_most = 16;
    const std::size_t all = input.table.size();
    double sum = 0, longest = 0;
    std::size_t count = 0;
    for (std::size_t i = 1; i <= std::min(all, k_most) && sum + longest <= k_trial; ++i) {
        double place = 0;  // 1/2, 1/4, 3/4, 1/8 ...
        for (std::size_t rest = i, half = 1; rest > 0; rest /= 2)
            place += static_cast<double>(rest % 2) / static_cast<double>(half *= 2);
        const auto seconds =
            study::seconds_of_member(input, static_cast<std::size_t>(place * static_cast<double>(all)), k_first);
        if (!seconds) break;
        ++count;
        sum += *seconds;
        longest = std::max(longest, *seconds);
    }
    return count > 0 ? std::optional(sum / static_cast<double>(count)) : std::nullopt;
}

/// Slopes take time by their areas.
double members_of(const study::StudyInput& input, const std::vector<SlopePlan>& plans) {
    if (!input.reading.study.region) return static_cast<double>(input.members());
    double largest = 0, all = 0;
    for (const SlopePlan& plan : plans) {
        largest = std::max(largest, plan.area);
        if (plan.problem.empty()) all += plan.area;
    }
    return largest > 0 ? all / largest * static_cast<double>(input.table.draws) : 0;
}

void print_keys(const std::vector<study::Variation>& vary, const std::string& of = {}) {
    for (const study::Variation& one : vary) print_fact(one.key + of, one.distribution.text);
}

void print_correlations(const study::StudySpec& study) {
    for (const study::Correlation& one : study.correlate)
        print_fact(one.first, "rank correlation with " + one.second + " " + number_text(one.rho));
}

void print_frequency(const study::StudyInput& input) {
    const study::StudySpec& study = input.spec();
    if (!study.frequency.is_given()) return;
    double all = 0;
    for (const study::Slope& slope : input.slopes) all += slope.frequency.rate ? slope.frequency.rate->value : 0;
    print_fact("events a year", study.region
                                    ? number_text(all, 3)
                                    : *find_parameter(study::study_keys(study.kind), "frequency.rate")->write(study));
    if (!study.region) return;
    print_keys(study.vary);
    print_correlations(study);
    print_fact("runs", std::to_string(study.samples) + " of each slope, seed " + std::to_string(study.seed));
}

/// Prints the slopes of a region, those that would fail and why.
void print_slopes(const study::StudyInput& input, const std::vector<SlopePlan>& plans) {
    std::vector<std::pair<std::string, std::string>> failing;
    std::printf("Slopes\n");
    for (std::size_t i = 0; i < plans.size(); ++i) {
        const study::Slope& slope = input.slopes[i];
        const SlopePlan& plan = plans[i];
        if (!plan.problem.empty())
            failing.emplace_back(label_of(slope, i), plan.problem);
        else if (i < k_listed)
            print_fact(label_of(slope, i), grouped(plan.area) + " m2");
    }
    if (plans.size() > k_listed) print_fact("...", "and " + std::to_string(plans.size() - k_listed) + " more");
    if (!failing.empty()) std::printf("\nSlopes that fail\n");
    for (const auto& [label, problem] : failing) print_fact(label, problem);
    std::printf("\nAll\n");
    print_fact("slopes", std::to_string(plans.size()) +
                             (failing.empty() ? "" : ", of which " + std::to_string(failing.size()) + " fail"));
    print_frequency(input);
    std::vector<std::string> scenarios;
    for (const study::Scenario& one : study::scenarios_of(input))
        scenarios.push_back(one.name +
                            (one.return_period > 0 ? " (" + shortest_text(one.return_period) + " years)" : ""));
    if (!scenarios.empty()) print_fact("scenarios", joined(scenarios, ", "));
    for (const study::RegionSpec::Column& one : input.reading.study.region->columns)
        print_fact(one.key, "column " + one.column);
}

/// Returns the list `slopes` of --json.
Json slopes_json(const study::StudyInput& input, const std::vector<SlopePlan>& plans) {
    const auto text = [](const std::string& value) { return value.empty() ? Json() : Json(value); };
    Json list = Json::array();
    for (std::size_t i = 0; i < plans.size(); ++i) {
        const study::Slope& slope = input.slopes[i];
        list.push_back(
            {{"member", i},
             {"name", text(slope.name)},
             {"group", text(slope.group)},
             {"scenario", text(slope.scenario)},
             {"return_period", slope.return_period ? Json(*slope.return_period) : Json()},
             {"annual_rate", slope.frequency.rate ? Json(slope.frequency.rate->value) : Json()},
             {"annual_rate_deviation", slope.frequency.rate ? Json(slope.frequency.rate->deviation) : Json()},
             {"area_m2", plans[i].area},
             {"problem", text(plans[i].problem)}});
    }
    return list;
}

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

void print_members(const study::StudyInput& input) {
    const study::StudySpec& study = input.reading.study;
    std::printf("Keys that vary\n");
    print_keys(study.vary);
    if (study.vary.empty())
        for (const std::string& key : input.table.keys) print_fact(key, "as in " + study.table);
    for (const study::TableColumn& column : input.table.columns)
        if (column.use != study::TableColumn::Use::key) print_fact(column.name, use_of(column.use));
    print_correlations(study);
    print_frequency(input);
    std::printf("\nMembers\n");
    print_fact("members", std::to_string(input.members()) + (study.until ? " at most" : "") + ", sampling " +
                              study::name_of(study.sampling) + ", seed " + std::to_string(study.seed));
}

const std::string k_density = "material.density";

}  // namespace

void print_result(const std::string& directory) {
    const std::string place = result_path(directory);
    print_fact("result",
               place + (has_files(place) ? ", which contains a result already: --overwrite replaces it" : ""));
}

Json result_json(const std::string& directory) {
    const std::string place = result_path(directory);
    return {{"folder", place}, {"exists", has_files(place)}};
}

void print_defaults(const Prepared& prepared) {
    if (model_reads(prepared.spec, k_density))
        print_fact("density", shortest_text(prepared.spec.material.density) +
                                  " kg/m3, from: " + describe(prepared.spec.origin_of(k_density)));
    if (const std::string left = joined(left_at_default(prepared), ", "); !left.empty()) print_fact("at default", left);
}

void add_defaults(const Prepared& prepared, Json& json) {
    if (model_reads(prepared.spec, k_density)) json["density_kg_m3"] = prepared.spec.material.density;
    json["left_at_default"] = left_at_default(prepared);
}

double StudyForecast::member_seconds() const noexcept {
    return engine_seconds(member, trial);
}

std::string study_directory(const study::StudySpec& study, const SceneSpec& scene) {
    constexpr const char* k_endings[] = {"-ensemble", "-region", "-calibration"};
    return output_directory(scene) + k_endings[static_cast<std::size_t>(study.kind)];
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

namespace {

void print_event(const study::StudyInput& input, std::size_t e) {
    const study::EventSpec& event = input.spec().events[e];
    print_fact(event.name, event.scene);
    std::vector<std::string> measures;
    for (const study::Weight& one : input.spec().objective)
        if (const study::MeasureRow& row = study::row_of(one.measure);
            study::has_evidence(input.own[e].base, event, row.needs))
            measures.push_back(std::string(row.name) + " " + shortest_text(one.weight));
    print_fact("", "compared by " + joined(measures, ", "));
    print_fact("", "cells of " + shortest_text(input.own[e].base.scene.grid.cell_size) + " m");
}

void print_calibration(const study::StudyInput& input) {
    const study::StudySpec& calibration = input.spec();
    std::printf("Events\n");
    for (std::size_t e = 0; e < input.events(); ++e) print_event(input, e);
    std::printf("\nKeys that vary\n");
    print_keys(calibration.vary);
    for (const study::EventSpec& event : calibration.events) print_keys(event.vary, " of " + event.name);
    print_correlations(calibration);
    std::printf("\nMembers\n");
    print_fact("members", std::to_string(input.own.front().design.size()) +
                              " first, then until the intervals settle, at most " +
                              std::to_string(calibration.samples) + ", each for " + std::to_string(input.events()) +
                              (input.events() == 1 ? " event" : " events") + "; then " +
                              std::to_string(study::forecast_runs(calibration)) + " for the forecast; sampling " +
                              study::name_of(calibration.sampling) + ", seed " + std::to_string(calibration.seed));
}

/// What a study or a region says of its only scene.
void print_scene(const study::StudyInput& input) {
    if (const auto& exposed = input.base.extra.exposure)
        print_fact("exposed", grouped(static_cast<double>(exposed->features.size())) + " features");
    if (const auto scheme = study::common_scheme(input))
        print_fact("scheme", word_of(*scheme, k_schemes) + "; two members again by the other one, as a check");
    if (input.base.friction)
        print_fact("friction",
                   study::shown_friction(input).of + ": " + friction_text(input.base.friction->choice()).text());
    print_defaults(input.base);
}

void add_scene(const study::StudyInput& input, const std::vector<SlopePlan>& plans, Json& json) {
    json["scene"] = input.spec().scene;
    json["sampling"] = study::name_of(input.spec().sampling);
    json["keys"] = input.table.keys;
    for (const study::TableColumn& column : input.table.columns)
        json["columns"].push_back({{"name", column.name}, {"use", use_of(column.use)}});
    add_defaults(input.base, json);
    if (input.spec().region) json["slopes"] = slopes_json(input, plans);
    if (const auto& exposed = input.base.extra.exposure) json["exposed_features"] = exposed->features.size();
}

}  // namespace

Json check_study(const std::string& path, study::StudyKind kind, const std::optional<std::string>& out, int threads,
                 bool print, const Session& session, RunLog& log) {
    study::StudyInput texts = study::read_study_texts(path, kind, session, log);
    const std::string directory = out.value_or(study_directory(texts.reading.study, texts.central.scene));
    const std::optional<Problem> place = check_result_directory(
        directory, Older::unknown, {}, out ? "--out" : "the result's place", texts.central.problems);
    const study::StudyInput input = study::prepare_study(std::move(texts), place, log);
    const study::StudySpec& study = input.spec();
    std::vector<SlopePlan> plans;
    for (std::size_t i = 0; i < input.slopes.size(); ++i) plans.push_back(plan_of(input, i));
    StudyCost cost;
    cost.may_end_early = study.is_calibration() || study.until;
    for (const study::StudyInput* one : input.studies()) {
        load_drawing(one->base.spec.output.maps.front() != "off", false, Loading::later);
        const auto tried = tried_seconds(*one);
        const bool has_particles = one->base.scene.numerics.scheme != Scheme::finite_volume;
        const StudyForecast forecast = forecast_study(*one, threads, !tried || has_particles);
        refuse_study_beyond_memory(*one, forecast, threads);
        const double members = study.is_calibration() ? static_cast<double>(study.samples) +
                                                            static_cast<double>(study::forecast_runs(study))
                               : tried ? static_cast<double>(one->members())
                                       : members_of(*one, plans);
        cost.add(tried.value_or(forecast.member_seconds()) * members, forecast);
        cost.is_lower_bound = cost.is_lower_bound || !(tried || forecast.trial);
    }
    if (print) {
        constexpr const char* k_names[] = {"Study", "Region", "Calibration"};
        std::printf("%s %s is ready to run.\n\n", k_names[static_cast<std::size_t>(kind)], study.file.c_str());
        if (!study.is_calibration()) std::printf("Scene %s\n\n", study.scene.c_str());
        study.is_calibration() ? print_calibration(input)
        : study.region         ? print_slopes(input, plans)
                               : print_members(input);
        if (!study.is_calibration()) print_scene(input);
        print_end(cost, threads, directory);
    }
    Warnings warnings, later = input.warnings;
    for (const study::StudyInput* one : input.studies()) {
        later += log.tell(doubt_release(one->base.scene));
        if (!study.is_calibration()) later += log.tell(doubt_exposure(one->base, !one->reading.study.region));
        warnings += one->base.scene.warnings;
    }
    Json json = document_of("check");
    json["warnings"] = texts_of(warnings += later);
    json["study"] = study.file;
    json["members"] = study.is_calibration() ? static_cast<std::size_t>(study.samples) : input.members();
    if (study.is_calibration()) {
        json["first_members"] = input.own.front().design.size();
        for (const study::EventSpec& event : study.events)
            json["events"].push_back({{"name", event.name}, {"scene", event.scene}});
    } else {
        add_scene(input, plans, json);
    }
    add_end(cost, threads, directory, json);
    return json;
}

}  // namespace frana::app
