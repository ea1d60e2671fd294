// SPDX-License-Identifier: Apache-2.0
#include "app/commands/run_study.h"
#include "app/study/plan/study_input.h"

#include <algorithm>
#include <filesystem>

#include "app/commands/command_line.h"
#include "app/commands/commands.h"
#include "app/commands/memory_forecast.h"
#include "app/commands/study_check.h"
#include "app/process/signals.h"
#include "app/process/stopwatch.h"
#include "app/store/interrupted_run.h"
#include "app/store/manifest.h"
#include "app/store/result_directory.h"
#include "app/store/result_files.h"
#include "app/store/result_place.h"
#include "app/store/scene_identity.h"
#include "app/study/pool/level_rounds.h"
#include "app/study/pool/member_runs.h"
#include "app/study/pool/rank_pool.h"
#include "app/study/pool/study_result.h"
#include "app/study/publish/publish_study.h"
#include "app/study/publish/study_files.h"
#include "app/text/number_text.h"
#include "app/text/text_file.h"
#include "app/text/version.h"
#include "params/grammar/value_text.h"

namespace frana::app {

CommandForm study_form(const std::string& command, const std::string& meaning, const std::string& default_place,
                       const std::string& what, const std::string& operand) {
    CommandForm form{"frana " + command + " " + operand + " [options]", meaning, operand, {}};
    const std::string out = "result directory (default: " + default_place + ")",
                      resume = "run only the members that a stopped or killed " + what + " has not finished",
                      limit = "refuse a " + what + " that would need more (4GB, 500MB)";
    form.options.add_options()("out", one("FOLDER"), out.c_str())(
        "threads", one("N"), "members that run side by side (default: all processors)")(
        "overwrite", "replace an existing result")("strict", k_strict_meaning)("resume", resume.c_str())(
        "memory-limit", one("SIZE"), limit.c_str())("quiet,q",
                                                    "no progress, no warnings on the terminal (they are in log.txt)");
    return form;
}

void refuse_to_discard(const std::string& target, const std::string& study, Problems& problems) {
    if (!study.empty())
        problems.add({"an interrupted study of it is kept in " + study, target, "", "",
                      has_files(target) ? "--resume --overwrite continues it and then replaces the older result; "
                                          "--overwrite alone removes it and starts anew"
                                        : "--resume continues it; --overwrite removes it and starts anew"});
    if (const InterruptedRun run(target); !run.beside().empty())
        problems.add({"an interrupted run of it is kept in " + run.beside(), target, "", "",
                      "`frana run --resume` continues it; --overwrite removes it"});
}

void require_same_study(const std::string& identity, const std::string& folder) {
    const std::string then = read_text_file((std::filesystem::path(folder) / k_record_identity).string());
    if (then == identity) return;
    throw Error(ErrorKind::input, Problem{"the members kept in " + folder + " are of another study: " +
                                              joined(identity_differences(identity, then), "; "),
                                          "--resume", "", "",
                                          "Restore the study as it was, or start anew: --overwrite without --resume"});
}

bool is_complete(const std::string& identity, const std::string& target) {
    const auto manifest = read_manifest(target);
    if (!manifest || !manifest->finished.value_or(false)) return false;
    if (manifest->scene_hash == text_hash(identity)) return true;
    throw Error(ErrorKind::input, Problem{"contains the finished result of another study", target, "", "",
                                          "Choose another folder with --out, or add --overwrite"});
}

int publish_result(const std::string& identity, const study::StudyOutcome& outcome, bool strict,
                   ResultDirectory& directory, RunLog& log) {
    const bool refused = strict && outcome.has_troubles;
    directory.publish({text_hash(identity), 0, true}, log);
    remove_working_files(directory.target(), false, log);
    log.info("result in " + directory.target());
    if (refused || outcome.too_many_failed || outcome.pictures_failed) log.print_deferred_warnings();
    if (refused || outcome.too_many_failed) return static_cast<int>(ExitCode::numerical);
    return static_cast<int>(outcome.pictures_failed ? ExitCode::environment : ExitCode::done);
}

namespace {

/// With study.until, errors are looked at after so many members, whatever the number of threads.
constexpr std::size_t k_members_between_checks = 64;

bool is_exact_enough(const study::StudyInput& input, const std::string& folder, std::size_t members) {
    const study::StudyResult result = study::read_study_result(input, folder, members);
    if (result.finished_at.size() < 2) return false;
    double largest = 0;
    for (const study::MappedEvents& events : study::mapped_events(input.base.spec))
        largest = std::max(largest, study::error_of_first(result.finished, result.finished.size(), events.quantity,
                                                          result.grid, events.thresholds)
                                        .largest);
    return largest <= *input.reading.study.until;
}

/// What ran of a study.
struct MembersRun {
    std::size_t members = 0;   ///< that belong to it
    std::size_t computed = 0;  ///< of these in this session
    int stopped_by = 0;        ///< a signal
};

/// Where members run, and where their records are.
struct Workers {
    std::string folder;
    int threads;
    bool quiet;
    study::RankPool* ranks;  ///< null: none
};

/// Runs the members below `end` with a runner of their own: a multilevel study's table grows.
bool run_until(const study::StudyInput& input, const Workers& workers, std::size_t end, MembersRun& ran) {
    study::MemberRunner runner(input, workers.folder, workers.threads, workers.quiet, workers.ranks);
    const bool complete = runner.run_until(end);
    ran.members = end;
    ran.computed += runner.computed();
    ran.stopped_by = runner.stopped_by();
    return complete;
}

MembersRun run_members(const study::StudyInput& input, const Workers& workers) {
    const std::size_t all = input.table.size();
    MembersRun ran;
    if (!input.reading.study.until) {
        run_until(input, workers, all, ran);
        return ran;
    }
    for (std::size_t end = std::min(all, k_members_between_checks);;
         end = std::min(all, end + k_members_between_checks)) {
        if (!run_until(input, workers, end, ran) || end == all || is_exact_enough(input, workers.folder, end))
            return ran;
    }
}

MembersRun run_level_members(study::StudyInput& input, const Workers& workers) {
    MembersRun ran;
    const bool has_limit = input.reading.study.until.has_value();
    study::run_levels(
        input, workers.folder, [&](std::size_t end) { return run_until(input, workers, end, ran); },
        [&](std::size_t members) { return has_limit && is_exact_enough(input, workers.folder, members); });
    ran.members = input.table.size();
    return ran;
}

}  // namespace

int run_study(const CommandForm& form, void (*check_file)(const std::string& file), const Arguments& arguments) {
    const Stopwatch since_start;
    const auto values = parse_arguments(form, arguments);
    if (!values) return static_cast<int>(ExitCode::done);
    const std::string file = (*values)["operand"].as<std::string>();
    check_file(file);
    OtherRanks ranks;
    const int threads = ranks.job && values->count("threads") == 0 ? 1 : thread_count(*values);
    if (ranks.job && ranks.job->rank() > 0) {
        const auto read = [&file] {
            RunLog silent(true);
            study::RankStudies own;
            own.studies.push_back(
                study::prepare_study(study::read_study_texts(file, {}, silent), std::nullopt, silent));
            own.identity = own.studies.front().identity;
            return own;
        };
        study::work_for_rank_0(*ranks.job, read, file, threads);
        return static_cast<int>(ExitCode::done);
    }
    const bool quiet = values->count("quiet") > 0, overwrite = values->count("overwrite") > 0,
               resume = values->count("resume") > 0;
    RunLog log(quiet);
    const Session session = session_of(*values, log);

    study::StudyTexts texts = study::read_study_texts(file, session, log);
    const auto out = text_option(*values, "out");
    const std::string place = out.value_or(study_directory(texts.reading.study, texts.central.scene)),
                      target = result_path(place);
    const std::string interrupted = interrupted_study(target);
    const bool may_be_complete = resume && !overwrite && interrupted.empty() && has_files(target);
    std::vector<std::string> inputs = input_files(texts.central.scene);
    inputs.push_back(texts.reading.study.file);
    std::optional<Problem> place_problem;
    if (!may_be_complete)
        place_problem = check_result_directory(place, overwrite ? Older::replaced : Older::refused, inputs,
                                               out ? "--out" : "the result's place", texts.central.problems);
    if (!resume && !overwrite) refuse_to_discard(target, interrupted, texts.central.problems);
    log.note(std::string(k_program) + " " + k_version + ", study " + texts.reading.study.file + ", " +
             std::to_string(threads) + " threads");
    study::StudyInput input = study::prepare_study(std::move(texts), place_problem, log);
    input.base.result_folder = target;
    if (may_be_complete && is_complete(input.identity, target)) {
        log.info("the study is complete: " + target);
        remove_working_files(target, false, log);
        return static_cast<int>(ExitCode::done);
    }
    study::load_study_drawing(input);
    refuse_study_beyond_memory(input, forecast_study(input, threads, false), threads,
                               ranks.job ? ranks.job->ranks_here() : 1);
    const std::string left = resume ? interrupted : "";
    if (!left.empty()) require_same_study(input.identity, left);

    catch_stop_signals();
    ResultDirectory directory(target, overwrite, !left.empty());
    directory.make_folder(k_record_folder);
    write_text_file(directory.path(k_record_identity), input.identity);
    if (ranks.pool) ranks.pool->start(input.identity);
    const Workers workers{directory.folder(), threads, quiet, ranks.pool.get()};
    const MembersRun ran = input.level_draws.empty() ? run_members(input, workers) : run_level_members(input, workers);
    const int all_threads = threads * (ranks.job ? ranks.job->size() : 1);
    ranks.release();
    if (ran.stopped_by != 0) {
        log.info("the study was stopped after " + std::to_string(records_in(directory.folder()).size()) +
                 " members: the same command with --resume runs the others");
        return static_cast<int>(ExitCode::signal) + ran.stopped_by;
    }
    log.note("computed " + std::to_string(ran.computed) + " members in " + number_text(since_start.seconds(), 3) +
             " s");
    const study::StudyOutcome outcome =
        study::publish_study({input, ran.members, ran.computed, all_threads, since_start}, directory, log);
    return publish_result(input.identity, outcome, values->count("strict") > 0, directory, log);
}

}  // namespace frana::app
