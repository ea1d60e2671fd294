// SPDX-License-Identifier: Apache-2.0
#include "app/commands/calibration_check.h"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "app/calibrate/calibration_input.h"
#include "app/calibrate/event_survey.h"
#include "app/commands/json_output.h"
#include "app/commands/study_check.h"
#include "app/store/result_place.h"
#include "app/text/number_text.h"
#include "app/text/text_table.h"
#include "core/shortest_text.h"

namespace frana::app {
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

CalibrationForecast forecast(const CalibrationInput& input, int threads) {
    CalibrationForecast all;
    for (std::size_t e = 0; e < input.events(); ++e) {
        const auto size = static_cast<double>(input.design.size());
        const StudyForecast coarse = forecast_study(input.coarse[e], threads, true);
        refuse_study_beyond_memory(input.coarse[e], coarse, threads);
        all.add(coarse, size, size);
        all.write(forecast_event_writing(input.own[e].base, coarse.member));
        if (input.spec().refine == 0) continue;
        const StudyForecast own = forecast_study(input.own[e], threads, true);
        refuse_study_beyond_memory(input.own[e], own, threads);
        all.add(own, static_cast<double>(input.spec().refine), size);
    }
    return all;
}

void print_keys(const std::vector<study::Variation>& vary, const std::string& of) {
    for (const study::Variation& one : vary) print_fact(one.key + of, one.distribution.text);
}

void print_event(const CalibrationInput& input, std::size_t e) {
    const study::EventSpec& event = input.spec().events[e];
    print_fact(event.name, event.members.study.scene);
    std::string measures;
    for (const study::Weight& one : input.spec().objective)
        if (has_evidence(input.own[e].base, event, row_of(one.measure).needs))
            measures += (measures.empty() ? "" : ", ") + std::string(row_of(one.measure).name) + " " +
                        shortest_text(one.weight);
    print_fact("", "compared by " + measures);
    print_fact("", "cells of " + shortest_text(input.coarse[e].base.scene.grid.cell_size) + " m, then " +
                       shortest_text(input.own[e].base.scene.grid.cell_size) + " m");
}

void print_calibration(const CalibrationInput& input, const CalibrationForecast& expected, int threads,
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
    print_fact("members", std::to_string(input.design.size()) + " on coarse cells, then " +
                              std::to_string(calibration.refine) + ", each for " + std::to_string(input.events()) +
                              (input.events() == 1 ? " event" : " events") + "; sampling " +
                              study::name_of(calibration.study.sampling) + ", seed " +
                              std::to_string(calibration.study.seed));
    print_fact("estimated time", std::string(expected.trial ? "about " : "at least ") +
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
                       RunLog& log) {
    CalibrationTexts texts = read_calibration_texts(path, log);
    const std::string directory = out.value_or(calibration_directory(texts.first_scene.scene));
    const std::optional<Problem> place =
        check_result_directory(directory, true, {}, out ? "--out" : "the result's place", texts.problems);
    const CalibrationInput input = prepare_calibration(std::move(texts), place, log);
    const study::CalibrationSpec& calibration = input.spec();
    const CalibrationForecast expected = forecast(input, threads);
    if (print) print_calibration(input, expected, threads, directory);
    Json json = document_of("check");
    json["study"] = calibration.study.file;
    json["events"] = Json::array();
    for (const study::EventSpec& event : calibration.events)
        json["events"].push_back({{"name", event.name}, {"scene", event.members.study.scene}});
    json["members"] = input.design.size();
    json["members_on_own_cells"] = calibration.refine;
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
