// SPDX-License-Identifier: Apache-2.0
#include "app/study/pool/calibration_runs.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include "app/store/interrupted_run.h"
#include "app/store/result_files.h"
#include "app/study/pool/member_runs.h"
#include "app/study/statistics/calibration_posterior.h"
#include "app/study/statistics/cell_statistics.h"
#include "core/raster.h"

namespace frana::app::study {
namespace {

namespace fs = std::filesystem;

/// Where the records of an event's members are, in the folder in which the result is being built.
std::string record_place(const RunSetting& setting, const char* cells, const std::string& event) {
    const fs::path place = fs::path(setting.folder) / k_record_folder / (std::string(cells) + "_" + event);
    std::error_code error;
    fs::create_directories(place / k_record_folder, error);
    if (error)
        throw Error(ErrorKind::environment, Problem{"cannot be made: " + error.message(), place.string(), "", "",
                                                    "Check the place's rights and free space"});
    return place.string();
}

void require_a_member(const EventRuns& runs, const EventSpec& event) {
    const auto finished = [](const MemberOutcome& one) { return one.failure.empty(); };
    if (std::any_of(runs.members.begin(), runs.members.end(), finished)) return;
    throw Error(ErrorKind::numerical,
                Problem{"no member of the event finished; the first: " + runs.members.front().failure,
                        "event " + event.name, event.members.study.scene, "",
                        "`frana run` on the scene shows more; correct the scene or the ranges in [vary]"});
}

/// Runs a stage's members for every event. Returns false if a signal stopped it.
/// @param studies by event; the first of them is number `first` of studies_of()
bool run_stage(const CalibrationInput& input, const std::vector<StudyInput>& studies, std::size_t first,
               const char* cells, const RunSetting& setting, RunLog& log, Stage& stage, std::size_t& computed) {
    for (std::size_t e = 0; e < studies.size(); ++e) {
        const EventSpec& event = input.spec().events[e];
        const std::string place = record_place(setting, cells, event.name);
        MemberRunner runner(studies[e], place, setting.threads, setting.quiet, setting.ranks, first + e);
        const bool whole = runner.run_until(studies[e].table.size());
        computed += runner.computed();
        if (!whole) return false;
        stage.tables.push_back(studies[e].table);
        stage.events.push_back(compare_members(input, e, studies[e], place));
        require_a_member(stage.events.back(), event);
        log.note(event.name + ": " + std::to_string(studies[e].table.size()) + " members on " + cells +
                 " cells, computed " + std::to_string(runner.computed()));
    }
    return true;
}

}  // namespace

RankStudies studies_of(CalibrationInput input) {
    RankStudies all{std::move(input.coarse), std::move(input.identity)};
    for (StudyInput& own : input.own) all.studies.push_back(std::move(own));
    return all;
}

Misfits Stage::misfits() const {
    Misfits all(size());
    for (std::size_t i = 0; i < size(); ++i)
        for (const EventRuns& event : events) {
            const MemberOutcome& one = event.members[i];
            all[i].push_back(one.failure.empty() ? one.agreement.misfit : k_no_data);
        }
    return all;
}

std::vector<RunOfStudy> Stage::runs() const {
    std::vector<RunOfStudy> all;
    for (const EventRuns& event : events)
        for (std::size_t i = 0; i < event.members.size(); ++i)
            all.push_back({i, event.members[i].end, event.members[i].failure});
    return all;
}

std::size_t Stage::failed() const {
    std::size_t count = 0;
    for (const EventRuns& event : events)
        for (const MemberOutcome& one : event.members) count += one.failure.empty() ? 0 : 1;
    return count;
}

EventRuns compare_members(const CalibrationInput& input, std::size_t event, const StudyInput& members,
                          const std::string& records) {
    const Prepared& base = members.base;
    EventRuns runs;
    runs.cell_size = base.scene.grid.cell_size;
    runs.records = records;
    FinishedMembers finished;
    for (std::size_t i = 0; i < members.table.size(); ++i) {
        const std::string file = record_file(records, i);
        const auto record = own_record(members, records, i);
        if (!record)
            throw Error(ErrorKind::environment, Problem{"the record of a member cannot be read", file, "", "",
                                                        "--resume computes that member again"});
        runs.members.push_back({record->failure, {}, record->engine_seconds, record->end});
        if (record->finished()) finished.records.push_back(file);
    }
    const EventSurvey survey(base, input.spec().events[event], input.spec().objective,
                             reached_window(finished, base.scene.grid));
    runs.measures = survey.measures();
    runs.observed_runout = survey.observed_runout();
    for (std::size_t i = 0; i < runs.members.size(); ++i)
        if (runs.members[i].failure.empty())
            runs.members[i].agreement = survey.compare(*own_record(members, records, i));
    return runs;
}

std::vector<double> weights_to_refine(const Misfits& misfits, double exponent) {
    const std::size_t events = misfits.front().size();
    std::vector<double> weights = posterior_weights(misfits, std::vector<double>(misfits.size(), 1.0), exponent / 2);
    double parts = 1;
    for (std::size_t e = 0; events > 1 && e < events; ++e) {
        const std::vector<double> others =
            posterior_weights(misfits, std::vector<double>(misfits.size(), 1.0), exponent / 2, e);
        for (std::size_t i = 0; i < weights.size(); ++i) weights[i] += others[i];
        ++parts;
    }
    for (double& weight : weights) weight /= parts;
    return weights;
}

std::optional<CalibrationRuns> run_calibration(CalibrationInput& input, const RunSetting& setting, RunLog& log) {
    const CalibrationSpec& calibration = input.spec();
    CalibrationRuns runs;
    runs.design.places = input.design;
    runs.design.density.assign(input.design.size(), 1);
    if (!run_stage(input, input.coarse, 0, "coarse", setting, log, runs.design, runs.computed)) return std::nullopt;
    if (calibration.refine == 0) return runs;
    const std::vector<double> weights = weights_to_refine(runs.design.misfits(), calibration.exponent);
    if (effective_count(weights) == 0)
        throw Error(ErrorKind::numerical, Problem{"no member finished for all events at once", input.reading.label, "",
                                                  "", "Narrow the ranges in [vary], or raise study.samples"});
    RefinedPlaces refined =
        refined_places(input.design, weights, static_cast<std::size_t>(calibration.refine), calibration.study.seed + 1);
    runs.refined.emplace();
    runs.refined->places = std::move(refined.places);
    runs.refined->density = std::move(refined.density);
    Problems of_values;  // a value outside its key's range: the member fails with the reason
    for (std::size_t e = 0; e < input.events(); ++e)
        input.own[e].table = members_at(calibration, e, runs.refined->places, of_values);
    if (!run_stage(input, input.own, input.events(), "own", setting, log, *runs.refined, runs.computed))
        return std::nullopt;
    return runs;
}

}  // namespace frana::app::study
