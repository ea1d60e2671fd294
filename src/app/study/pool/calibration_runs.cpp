// SPDX-License-Identifier: Apache-2.0
#include "app/study/pool/calibration_runs.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include "app/store/result_files.h"
#include "app/study/pool/member_runs.h"
#include "app/study/statistics/calibration_posterior.h"
#include "app/study/statistics/cell_statistics.h"
#include "app/text/number_text.h"
#include "core/raster.h"

namespace frana::app::study {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t k_prior_places = 2048;
constexpr std::size_t k_least_batch = 4, k_batches = 5;  // members of a batch: at least, and a part of those so far

/// Where the records of an event's members are, in the folder in which the result is being built.
std::string record_place(const RunSetting& setting, const std::string& event) {
    const fs::path place = fs::path(setting.folder) / k_record_folder / event;
    std::error_code error;
    fs::create_directories(place / k_record_folder, error);
    if (error)
        throw Error(ErrorKind::environment, Problem{"cannot be made: " + error.message(), place.string(), "", "",
                                                    "Check the place's rights and free space"});
    return place.string();
}

void require_a_member(const EventRuns& runs, const EventSpec& event) {
    if (failed_of(runs.members) < runs.members.size()) return;
    throw Error(
        ErrorKind::numerical,
        Problem{"no member of the event finished; the first: " + runs.members.front().failure, "event " + event.name,
                event.scene, "", "`frana run` on the scene shows more; correct the scene or the ranges in [vary]"});
}

/// Compares the records of an event's members from `first` on with its survey, and adds them to its runs.
void compare_members(const StudyInput& input, std::size_t event, const StudyInput& members, std::size_t first,
                     EventRuns& runs) {
    const Prepared& base = members.base;
    FinishedMembers finished;
    const RecordFiles records(runs.records);
    for (std::size_t i = first; i < members.table.size(); ++i) {
        runs.members.push_back(without_cells(require_own_record(members, records.place(i), i)));
        if (runs.members.back().failure.empty()) finished.records.push_back(records.place(i));
    }
    const EventSurvey survey(base, input.spec().events[event], input.spec().objective,
                             reached_window(finished, base.scene.grid));
    runs.measures = survey.measures();
    runs.observed_runout = survey.observed_runout();
    runs.pieces = survey.pieces();
    for (std::size_t i = first; i < runs.members.size(); ++i)
        runs.agreements.push_back(runs.members[i].failure.empty() ? survey.compare(require_record(records.place(i)))
                                                                  : MemberAgreement{k_no_data, {}, k_no_data});
}

/// Runs the members that are not in `runs` yet for every event. Returns false if a signal stopped it.
bool run_members(StudyInput& input, const RunSetting& setting, RunLog& log, CalibrationRuns& runs) {
    const StudySpec& calibration = input.spec();
    runs.events.resize(input.events());
    Problems of_values;  // a value outside its key's range: the member fails with the reason
    for (std::size_t e = 0; e < input.events(); ++e) {
        StudyInput& study = input.own[e];
        study.table = members_at(input.reading, e, runs.places, of_values);
        EventRuns& of_event = runs.events[e];
        of_event.records = record_place(setting, calibration.events[e].name);
        MemberRunner runner(study, of_event.records, setting.threads, setting.quiet, setting.ranks, e);
        const bool whole = runner.run_until(study.table.size());
        runs.computed += runner.computed();
        if (!whole) return false;
        compare_members(input, e, study, of_event.members.size(), of_event);
        require_a_member(of_event, calibration.events[e]);
        log.note(calibration.events[e].name + ": " + std::to_string(study.table.size()) + " members, computed " +
                 std::to_string(runner.computed()));
    }
    return true;
}

}  // namespace

std::vector<std::vector<double>> CalibrationRuns::misfits() const {
    std::vector<std::vector<double>> all(size());
    for (std::size_t i = 0; i < size(); ++i)
        for (const EventRuns& event : events) all[i].push_back(event.agreements[i].misfit);
    return all;
}

std::vector<MemberRecord> CalibrationRuns::runs() const {
    std::vector<MemberRecord> all;
    for (const EventRuns& event : events) all.insert(all.end(), event.members.begin(), event.members.end());
    return all;
}

CalibrationModel model_of(const StudySpec& calibration, const CalibrationRuns& runs) {
    std::vector<CubeKey> keys;
    for (const Variation& one : calibration.vary) keys.push_back({one.distribution, std::nullopt});
    std::vector<EventEvidence> evidence;
    for (std::size_t e = 0; e < runs.events.size(); ++e) {
        for (const Variation& one : calibration.events[e].vary) keys.push_back({one.distribution, e});
        const bool is_stated = runs.events[e].pieces > 0;
        EventEvidence& of_event = evidence.emplace_back(
            EventEvidence{{}, is_stated ? runs.events[e].pieces : calibration.exponent, is_stated});
        for (const MemberAgreement& one : runs.events[e].agreements)
            of_event.distances.push_back(is_stated ? std::sqrt(one.chi_square) : one.misfit);
    }
    StudySpec prior = calibration.of_all_events();
    prior.samples = k_prior_places;
    prior.sampling = Sampling::sobol;
    return {std::move(keys), runs.places, std::move(evidence), draw_places(prior), calibration.seed + 1};
}

std::optional<CalibrationRuns> run_calibration(StudyInput& input, const RunSetting& setting, RunLog& log) {
    const StudySpec& calibration = input.spec();
    const auto most = static_cast<std::size_t>(calibration.samples);
    CalibrationRuns runs;
    runs.places = input.design;
    runs.design = input.design.size();
    PosteriorSample before;
    for (;;) {
        if (!run_members(input, setting, log, runs)) return std::nullopt;
        const CalibrationModel model = model_of(calibration, runs);
        PosteriorSample now = model.sample();
        if (!now.possible())
            throw Error(ErrorKind::numerical, Problem{"no member finished for all events at once", input.reading.label,
                                                      "", "", "Narrow the ranges in [vary], or raise study.samples"});
        if (!before.places.empty()) {
            runs.moves[0] = runs.moves[1];
            runs.moves[1] = greatest_move(before, now);
            log.note("the quantiles moved by " + number_text(100 * runs.moves[1], 2) + " % of the distributions");
        }
        if (runs.has_settled() || runs.size() >= most) return runs;
        for (std::vector<double>& place :
             model.next(std::min(most - runs.size(), std::max(k_least_batch, runs.size() / k_batches))))
            runs.places.push_back(std::move(place));
        before = std::move(now);
    }
}

}  // namespace frana::app::study
