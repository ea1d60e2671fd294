// SPDX-License-Identifier: Apache-2.0
#include "app/commands/command_line.h"
#include "app/commands/commands.h"
#include "app/commands/memory_forecast.h"
#include "app/commands/run_study.h"
#include "app/commands/study_check.h"
#include "app/process/signals.h"
#include "app/process/stopwatch.h"
#include "app/store/interrupted_run.h"
#include "app/store/result_directory.h"
#include "app/store/result_files.h"
#include "app/store/result_place.h"
#include "app/study/pool/calibration_runs.h"
#include "app/study/publish/publish_calibration.h"
#include "app/text/number_text.h"
#include "app/text/text_file.h"
#include "app/text/version.h"

namespace frana::app {

CommandForm calibrate_form() {
    return study_form(
        "calibrate",
        "Finds the values of uncertain keys that explain one or several surveyed events, and how uncertain "
        "they stay:\na table of weighted members that `frana ensemble` takes, with charts and a report.",
        "that of the first scene, with -calibration", "calibration");
}

int cmd_calibrate(const Arguments& arguments) {
    const Stopwatch since_start;
    const auto values = parse_arguments(calibrate_form(), arguments);
    if (!values) return static_cast<int>(ExitCode::done);
    const std::string file = (*values)["operand"].as<std::string>();
    OtherRanks ranks;
    const int threads = ranks.job && values->count("threads") == 0 ? 1 : thread_count(*values);
    if (ranks.job && ranks.job->rank() > 0) {
        const auto read = [&file] {
            RunLog silent(true);
            return study::studies_of(
                study::prepare_calibration(study::read_calibration_texts(file, {}, silent), std::nullopt, silent));
        };
        study::work_for_rank_0(*ranks.job, read, file, threads);
        return static_cast<int>(ExitCode::done);
    }
    const bool quiet = values->count("quiet") > 0, overwrite = values->count("overwrite") > 0,
               resume = values->count("resume") > 0;
    RunLog log(quiet);
    const Session session = session_of(*values, log);

    study::CalibrationTexts texts = study::read_calibration_texts(file, session, log);
    const auto out = text_option(*values, "out");
    const std::string place = out.value_or(calibration_directory(texts.first_scene.scene)), target = result_path(place);
    const std::string interrupted = interrupted_study(target);
    const bool may_be_complete = resume && !overwrite && interrupted.empty() && has_files(target);
    std::vector<std::string> inputs{texts.reading.calibration.study.file};
    for (const study::StudyTexts& event : texts.events)
        for (std::string& one : input_files(event.central.scene)) inputs.push_back(std::move(one));
    std::optional<Problem> place_problem;
    if (!may_be_complete)
        place_problem = check_result_directory(place, overwrite ? Older::replaced : Older::refused, inputs,
                                               out ? "--out" : "the result's place", texts.problems);
    if (!resume && !overwrite) refuse_to_discard(target, interrupted, texts.problems);
    log.note(std::string(k_program) + " " + k_version + ", study " + texts.reading.calibration.study.file + ", " +
             std::to_string(threads) + " threads");
    study::CalibrationInput input = study::prepare_calibration(std::move(texts), place_problem, log);
    if (may_be_complete && is_complete(input.identity, target)) {
        log.info("the calibration is complete: " + target);
        remove_working_files(target, false, log);
        return static_cast<int>(ExitCode::done);
    }
    study::load_calibration_drawing(input);
    for (const study::StudyInput& event : input.own)
        refuse_study_beyond_memory(event, forecast_study(event, threads, false), threads,
                                   ranks.job ? ranks.job->ranks_here() : 1);
    const std::string left = resume ? interrupted : "";
    if (!left.empty()) require_same_study(input.identity, left);

    catch_stop_signals();
    ResultDirectory directory(target, overwrite, !left.empty());
    directory.make_folder(k_record_folder);
    write_text_file(directory.path(k_record_identity), input.identity);
    if (ranks.pool) ranks.pool->start(input.identity);
    const int all_threads = threads * (ranks.job ? ranks.job->size() : 1);
    const auto runs = study::run_calibration(input, {directory.folder(), threads, quiet, ranks.pool.get()}, log);
    ranks.release();
    if (!runs) {
        log.info("the calibration was stopped after " + std::to_string(records_in(directory.folder()).size()) +
                 " runs: the same command with --resume runs the others");
        return static_cast<int>(ExitCode::signal) + stop_signal();
    }
    log.note("computed " + std::to_string(runs->computed) + " runs in " + number_text(since_start.seconds(), 3) + " s");
    const study::StudyOutcome outcome =
        study::publish_calibration(input, *runs, all_threads, since_start, directory, log);
    return publish_result(input.identity, outcome, values->count("strict") > 0, directory, log);
}

}  // namespace frana::app
