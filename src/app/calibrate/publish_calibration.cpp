// SPDX-License-Identifier: Apache-2.0
#include "app/calibrate/publish_calibration.h"

#include "app/calibrate/calibration_charts.h"
#include "app/calibrate/calibration_maps.h"
#include "app/calibrate/calibration_report.h"
#include "app/calibrate/calibration_tables.h"
#include "app/ensemble/study_result.h"
#include "app/input/scene_language.h"
#include "app/pictures/charts.h"
#include "app/store/provenance.h"
#include "app/store/recorded_inputs.h"
#include "app/store/result_files.h"
#include "app/text/number_text.h"
#include "app/text/text_file.h"
#include "app/text/today.h"
#include "params/grammar/picture_text.h"
#include "params/scene/write_scene.h"
#include "render/canvas/drawing_modules.h"

namespace frana::app {
namespace {

MapSource chart_source(const CalibrationInput& input) {
    const OutputSpec& output = input.own.front().base.spec.output;
    MapSource source;
    source.title = calibration_title(input);
    source.style.words = words_of(input.own.front().base.spec);
    if (const auto size = size_from_text(output.map_size)) source.style.size = *size;
    source.style.formats = output.map_formats;
    source.style.attribution = output.map_attribution.value_or("");
    source.style.author = output.map_author.value_or("");
    source.style.organisation = output.map_organisation.value_or("");
    source.style.date = date_on_maps(output.map_date, today());
    return source;
}

/// Returns false if a chart could not be drawn, with a warning.
bool draw(const CalibrationInput& input, const CalibrationRuns& runs, const CalibrationResult& result,
          const ResultDirectory& directory, RunLog& log) {
    const OutputSpec& output = input.own.front().base.spec.output;
    if (output.maps.front() == "off" || !output.charts) return true;
    const MapSource source = chart_source(input);
    directory.make_folder("charts");
    bool good = true;
    for (const NamedChart& one : calibration_charts(input, runs, result, source)) {
        try {
            write_chart(one, source.style, directory.folder(), output.report);
            log.note("drew charts/" + one.name);
        } catch (const Error& error) {
            log.warn(worded("{1} could not be drawn: {2}", {"charts/" + one.name, std::string(error.what())}));
            good = false;
        }
    }
    return good;
}

/// The files that the study and the scenes of its events name.
std::vector<NamedFile> inputs_of(const CalibrationInput& input) {
    std::vector<NamedFile> files;
    static_cast<void>(with_files(input.spec(), [&](const std::string& key, const std::string& path) {
        files.push_back({key, path});
        return path;
    }));
    for (const StudyInput& event : input.own)
        for (NamedFile& file : named_files(event.base.spec)) files.push_back(std::move(file));
    return files;
}

void write_best_scenes(const CalibrationInput& input, const CalibrationResult& result,
                       const ResultDirectory& directory) {
    for (std::size_t e = 0; e < input.events(); ++e) {
        const StudyInput& study = input.spec().refine == 0 ? input.coarse[e] : input.own[e];
        const std::string name = input.events() == 1 ? k_best_scene : best_scene_of(input.spec().events[e].name);
        write_text_file(directory.path(name), echoed_scene(study.member(result.best).scene, directory.target()));
    }
}

void tell(const CalibrationInput& input, const CalibrationResult& result, RunLog& log) {
    for (std::size_t e = 0; e < input.events(); ++e) {
        const EventResult& event = result.events[e];
        std::string text = input.spec().events[e].name + ": score " + number_text(event.fitted.best_score, 3) +
                           " fitted (mean " + number_text(event.fitted.mean, 3) + ")";
        if (input.events() > 1)
            text += event.predicted.possible
                        ? ", " + number_text(event.predicted.best_score, 3) + " predicted from the others (mean " +
                              number_text(event.predicted.mean, 3) + ")"
                        : ", not predicted: no member finished for the others";
        log.info(text);
    }
    for (const Sentence& sentence : result.sentences) log.info(sentence.text());
}

/// All runs, each with the table that has its row.
std::vector<RunOfStudy> runs_of(const CalibrationRuns& runs) {
    std::vector<RunOfStudy> all;
    const auto add = [&](const Stage& stage, const char* table) {
        for (RunOfStudy& run : stage.runs()) {
            run.table = table;
            all.push_back(std::move(run));
        }
    };
    add(runs.design, k_design_table);
    if (runs.refined) add(*runs.refined, k_posterior_table);
    return all;
}

bool warn_of_failures(const CalibrationRuns& runs, std::size_t events, RunLog& log) {
    const std::size_t failed = runs.last().failed(), all = runs.last().size() * events;
    if (failed == 0) return false;
    log.warn(worded("{1} of {2} runs failed: their members have no weight. posterior.csv has the reason of each",
                    {std::to_string(failed), std::to_string(all)}));
    return static_cast<double>(failed) > k_most_failed * static_cast<double>(all);
}

}  // namespace

void load_calibration_drawing(const CalibrationInput& input) {
    for (const StudyInput& event : input.own)
        if (event.base.spec.output.maps.front() != "off") render::vtk();
}

StudyOutcome publish_calibration(const CalibrationInput& input, const CalibrationRuns& runs, int threads,
                                 const Stopwatch& since_start, const ResultDirectory& directory, RunLog& log) {
    const CalibrationResult result = calibration_result(input, runs);
    StudyOutcome outcome;
    const std::vector<RunOfStudy> all = runs_of(runs);
    const Troubles troubles = troubles_of(all, false);
    outcome.has_troubles = troubles.any();
    if (troubles.open > 0) {
        const Sentence told = headline(troubles);
        log.warn(told);
        const bool in_posterior = troubles_of(runs.last().runs(), false).open > 0;
        if (in_posterior)
            log.warn(
                worded("The scores of runs that were cut or left the ground are those of unfinished flows, and so is "
                       "the posterior: raise time.end, or use a larger DTM"));
        else
            log.warn(
                worded("The scores of runs that were cut or left the ground are those of unfinished flows; all of them "
                       "are rows of design.csv, none of posterior.csv"));
    }
    outcome.too_many_failed = warn_of_failures(runs, input.events(), log);
    for (const Sentence& kind : kinds_of_warnings(all, log.warnings())) log.warn(kind);
    if (const auto warning = study::few_members(result.effective)) log.warn(*warning);
    write_text_file(directory.path(k_study_file), calibration_text(seen_from(input.spec(), directory.target())));
    write_text_file(directory.path(k_inputs_file), recorded_inputs(inputs_of(input), directory.target()));
    write_text_file(directory.path(k_posterior_table), posterior_csv(input, runs, result));
    write_text_file(directory.path(k_design_table), design_csv(input, runs));
    for (std::size_t e = 0; input.events() > 1 && e < input.events(); ++e)
        if (const study::EventSpec& event = input.spec().events[e]; !event.vary.empty())
            write_text_file(directory.path(posterior_of(event.name)), event_posterior_csv(runs, result, e));
    write_text_file(directory.path(k_calibration_file), calibration_json(input, runs, result));
    write_best_scenes(input, result, directory);
    const bool mapped = publish_calibration_maps(input, runs, result, directory, log);
    outcome.pictures_failed = !draw(input, runs, result, directory, log) || !mapped;
    tell(input, result, log);
    const CalibrationFacts facts{troubles, since_start.seconds(), threads, log.warnings(), today()};
    if (input.own.front().base.spec.output.report) write_calibration_report(input, runs, result, facts, directory);
    write_text_file(directory.path(k_summary_file), calibration_summary_json(input, runs, facts));
    write_text_file(directory.path(k_log_file), log.text());
    return outcome;
}

}  // namespace frana::app
