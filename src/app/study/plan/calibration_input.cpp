// SPDX-License-Identifier: Apache-2.0
#include "app/study/plan/calibration_input.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "app/store/recorded_inputs.h"
#include "app/study/plan/event_survey.h"
#include "app/study/plan/study_input.h"
#include "core/text.h"
#include "params/grammar/value_text.h"

namespace frana::app::study {
namespace {

constexpr const char* k_cell_size = "terrain.cell-size=";

/// All keys of a calibration as one study, for its design.
StudySpec all_keys(const CalibrationSpec& calibration) {
    StudySpec all = calibration.study;
    for (const EventSpec& event : calibration.events)
        all.vary.insert(all.vary.end(), event.vary.begin(), event.vary.end());
    return all;
}

void add_once(const Problems& from, Problems& to) {
    for (const Problem& problem : from.list()) {
        const auto& known = to.list();
        if (std::none_of(known.begin(), known.end(),
                         [&](const Problem& one) { return describe(one) == describe(problem); }))
            to.add(problem);
    }
}

/// Prepares what can be prepared; problems are collected over all events.
std::optional<StudyInput> prepared_event(StudyTexts texts, const std::optional<Problem>& place, RunLog& log,
                                         Problems& problems) {
    Problems of_event;
    auto event = attempt(of_event, [&] { return std::optional(prepare_study(std::move(texts), place, log)); });
    add_once(of_event, problems);
    return event;
}

StudyReading on_cells_of(StudyReading reading, double cell_size) {
    std::erase_if(reading.study.set, [](const std::string& one) { return one.starts_with(k_cell_size); });
    reading.study.set.push_back(k_cell_size + shortest_text(cell_size));
    return reading;
}

bool weighs(const CalibrationSpec& calibration, Evidence evidence) {
    return std::any_of(calibration.objective.begin(), calibration.objective.end(),
                       [&](const Weight& one) { return row_of(one.measure).needs == evidence; });
}

/// Every event needs something that is compared, every measure an event, and gauges must exist.
void check_evidence(const CalibrationInput& input, Problems& problems) {
    const CalibrationSpec& calibration = input.spec();
    std::vector<std::string> measures, sources;
    std::vector<bool> used(calibration.objective.size());
    for (const Weight& one : calibration.objective) {
        measures.emplace_back(row_of(one.measure).name);
        sources.emplace_back(source_of(row_of(one.measure).needs));
    }
    for (std::size_t e = 0; e < input.events(); ++e) {
        const EventSpec& event = calibration.events[e];
        const Prepared& base = input.own[e].base;
        bool any = false;
        for (std::size_t m = 0; m < measures.size(); ++m) {
            if (!has_evidence(base, event, row_of(calibration.objective[m].measure).needs)) continue;
            used[m] = any = true;
        }
        const std::string where = input.reading.where("event " + event.name);
        if (!any)
            problems.add({"has nothing that [objective] compares: " + joined(measures, ", "), where,
                          event.members.study.scene, "", "Give it " + joined(sources, "; or ")});
        check_gauges(base, event, where, problems);
    }
    for (std::size_t m = 0; m < measures.size(); ++m)
        if (!used[m])
            problems.add({"no event was surveyed for it", input.reading.where("objective." + measures[m]), "", "",
                          "Give an event " + sources[m] + ", or remove the line"});
}

/// Measures the survey as the members will be compared with it.
void check_survey(const CalibrationSpec& calibration, std::size_t event, const Prepared& base, Problems& problems) {
    attempt(problems, [&] { const EventSurvey survey(base, calibration.events[event], calibration.objective, {}); });
}

/// Figures and outlines of a member use the survey's threshold, and records contain what is compared.
void compare_by_survey(const CalibrationSpec& calibration, StudyInput& input) {
    input.base.spec.output.trace_threshold = observed_threshold(input.base.spec);
    const Survey& survey = input.base.extra.survey;
    const bool has_deposit = survey.elevation_change || !survey.deposit.empty();
    input.keeps_final_depth =
        has_deposit && (weighs(calibration, Evidence::deposit) || weighs(calibration, Evidence::elevation_change));
}

}  // namespace

SampleTable members_at(const CalibrationSpec& calibration, std::size_t event, const Places& places,
                       Problems& problems) {
    const EventSpec& spec = calibration.events[event];
    const std::size_t shared = calibration.study.vary.size(), first = calibration.first_own_key(event);
    Places of_event;
    for (const std::vector<double>& place : places) {
        std::vector<double>& one = of_event.emplace_back(place.begin(), place.begin() + static_cast<long>(shared));
        for (std::size_t k = first; k < first + spec.vary.size(); ++k) one.push_back(place[k]);
    }
    return samples_at(spec.members.study, of_event, spec.members.label, problems);
}

CalibrationTexts read_calibration_texts(const std::string& path, const Session& session, RunLog& log) {
    CalibrationTexts texts;
    texts.reading = read_calibration(path);
    for (EventSpec& event : texts.reading.calibration.events) event.members.session = session;
    find_recorded_inputs(texts.reading, log);
    const CalibrationSpec& calibration = texts.reading.calibration;
    texts.problems = texts.reading.problems;
    if (calibration.events.empty()) texts.problems.throw_if_any();
    const bool drawable = texts.problems.empty() && calibration.key_count() > 0;  // else values tell nothing
    if (drawable) texts.design = draw_places(all_keys(calibration));
    for (std::size_t e = 0; e < calibration.events.size(); ++e) {
        const EventSpec& event = calibration.events[e];
        SampleTable table;
        if (drawable) table = members_at(calibration, e, texts.design, texts.problems);
        Problems of_scene;  // the scene may be no INI
        attempt(of_scene, [&] {
            StudyTexts one = read_study_scenes(event.members, std::move(table));
            add_once(one.central.problems, texts.problems);
            warn_of_changed_inputs(calibration.study.file, one.central, log);
            if (texts.events.empty()) texts.first_scene = one.central;
            texts.events.push_back(std::move(one));
        });
        add_once(of_scene, texts.problems);
    }
    if (texts.events.empty()) texts.problems.throw_if_any();
    return texts;
}

CalibrationInput prepare_calibration(CalibrationTexts texts, const std::optional<Problem>& place, RunLog& log) {
    CalibrationInput input{std::move(texts.reading), std::move(texts.design), {}, {}, {}};
    const CalibrationSpec& calibration = input.spec();
    Problems problems = std::move(texts.problems);
    const bool alone = problems.empty();  // then a place that cannot be written is an error of the environment
    if (place && !alone) problems.add(*place);
    for (std::size_t e = 0; e < texts.events.size(); ++e) {
        auto own = prepared_event(std::move(texts.events[e]), e == 0 && alone ? place : std::nullopt, log, problems);
        if (own) input.own.push_back(std::move(*own));
    }
    problems.throw_if_any();
    check_evidence(input, problems);
    problems.throw_if_any();
    RunLog silent(true);
    for (StudyInput& own : input.own) {
        const double cell_size = calibration.coarse * own.base.scene.grid.cell_size;
        auto coarse = prepared_event(read_study_scenes(on_cells_of(own.reading, cell_size), own.table), std::nullopt,
                                     silent, problems);
        if (coarse) input.coarse.push_back(std::move(*coarse));
    }
    problems.throw_if_any();
    for (std::size_t e = 0; e < input.events(); ++e)
        for (const StudyInput* const study : {&input.own[e], &input.coarse[e]})
            check_survey(calibration, e, study->base, problems);
    problems.throw_if_any();
    input.identity = calibration_text(with_files(calibration, [](const std::string&, const std::string& path) {
        return std::filesystem::path(path).filename().string();
    }));
    for (std::size_t e = 0; e < input.events(); ++e) {
        compare_by_survey(calibration, input.own[e]);
        compare_by_survey(calibration, input.coarse[e]);
        input.identity +=
            "event " + calibration.events[e].name + ":\n" + input.coarse[e].identity + input.own[e].identity;
    }
    return input;
}

}  // namespace frana::app::study
