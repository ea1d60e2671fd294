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
        runs.members.push_back(without_cells(require_record(records.place(i))));
        if (runs.members.back().failure.empty()) finished.records.push_back(records.place(i));
    }
    const EventSurvey survey(base, input.spec().events[event], input.spec().objective,
                             reached_window(finished, base.scene.grid));
    runs.measures = survey.measures();
    runs.observed_runout = survey.observed_runout();
    runs.pieces = survey.pieces();
    runs.scatter = survey.scatter();
    for (std::size_t i = first; i < runs.members.size(); ++i)
        runs.agreements.push_back(runs.members[i].failure.empty()
                                      ? survey.compare(require_record(records.place(i)))
                                      : MemberAgreement{k_no_data, {}, k_no_data, k_no_data});
}

/// Runs the members of an event that are not in its runs yet. Returns false if a signal stopped it.
bool run_members(StudyInput& input, std::size_t event, const RunSetting& setting, RunLog& log, CalibrationRuns& runs) {
    Problems of_values;  // a value outside its key's range: the member fails with the reason
    StudyInput& study = input.own[event];
    EventRuns& of_event = runs.events[event];
    study.table = members_at(input.reading, event, of_event.places, of_values);
    of_event.records = record_place(setting, input.spec().events[event].name);
    MemberRunner runner(study, of_event.records, setting.threads, setting.quiet, setting.ranks, event);
    const bool whole = runner.run_until(study.table.size());
    runs.computed += runner.computed();
    if (!whole) return false;
    compare_members(input, event, study, of_event.members.size(), of_event);
    require_a_member(of_event, input.spec().events[event]);
    log.note(input.spec().events[event].name + ": " + std::to_string(study.table.size()) + " members, computed " +
             std::to_string(runner.computed()));
    return true;
}

/// The search of one event. Returns the posterior of its survey alone; none if a signal stopped it.
std::optional<PosteriorSample> search(StudyInput& input, std::size_t event, const RunSetting& setting, RunLog& log,
                                      CalibrationRuns& runs) {
    const StudySpec& calibration = input.spec();
    const auto most = static_cast<std::size_t>(calibration.samples);
    EventRuns& of_event = runs.events[event];
    of_event.places = input.own[event].design;
    of_event.design = of_event.places.size();
    PosteriorSample before;
    for (;;) {
        if (!run_members(input, event, setting, log, runs)) return std::nullopt;
        of_event.searched = of_event.places.size();
        EventModel model = model_of(calibration, event, of_event);
        PosteriorSample now = model.sample();
        if (!before.places.empty()) {
            of_event.moves[0] = of_event.moves[1];
            of_event.moves[1] = greatest_move(before, now);
            log.note("the quantiles moved by " + number_text(100 * of_event.moves[1], 2) + " % of the distributions");
        }
        if (of_event.has_settled() || of_event.searched >= most) {
            runs.models.push_back(std::move(model));
            return now;
        }
        for (std::vector<double>& place :
             model.next(std::min(most - of_event.searched, std::max(k_least_batch, of_event.searched / k_batches))))
            of_event.places.push_back(std::move(place));
        before = std::move(now);
    }
}

}  // namespace

std::vector<MemberRecord> CalibrationRuns::runs() const {
    std::vector<MemberRecord> all;
    for (const EventRuns& event : events) all.insert(all.end(), event.members.begin(), event.members.end());
    return all;
}

EventModel model_of(const StudySpec& calibration, std::size_t event, const EventRuns& runs) {
    StudySpec prior = calibration.of_event(event);
    EventEvidence evidence{{}, runs.is_stated() ? runs.pieces : calibration.exponent, runs.scatter, runs.is_stated()};
    for (std::size_t i = 0; i < runs.searched; ++i)
        evidence.distances.push_back(runs.is_stated() ? std::sqrt(runs.agreements[i].chi_square)
                                                      : runs.agreements[i].misfit);
    prior.samples = k_prior_places;
    prior.sampling = Sampling::sobol;
    return {prior.vary,
            {runs.places.begin(), runs.places.begin() + static_cast<std::ptrdiff_t>(runs.searched)},
            std::move(evidence),
            draw_places(prior),
            calibration.seed + 1};
}

std::optional<CalibrationRuns> run_calibration(StudyInput& input, const RunSetting& setting, RunLog& log) {
    const StudySpec& calibration = input.spec();
    CalibrationRuns runs;
    runs.events.resize(input.events());
    for (std::size_t e = 0; e < input.events(); ++e) {
        auto one = search(input, e, setting, log, runs);
        if (!one) return std::nullopt;
        runs.alone.push_back(std::move(*one));
    }
    runs.population = population_of(calibration.vary, runs.alone, calibration.seed);
    for (std::size_t e = 0; e < input.events(); ++e) {
        for (std::vector<double>& place : evenly_drawn(runs.population.events[e], forecast_runs(calibration)))
            runs.events[e].places.push_back(std::move(place));
        if (!run_members(input, e, setting, log, runs)) return std::nullopt;
    }
    return runs;
}

}  // namespace frana::app::study
