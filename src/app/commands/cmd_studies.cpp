// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "app/commands/command_line.h"
#include "app/commands/forecast.h"
#include "app/commands/study_check.h"
#include "app/process/terminal.h"
#include "app/store/interrupted_run.h"
#include "app/store/manifest.h"
#include "app/store/result_directory.h"
#include "app/store/result_files.h"
#include "app/store/scene_identity.h"
#include "app/study/plan/read_study.h"
#include "app/study/plan/study_input.h"
#include "app/study/pool/calibration_runs.h"
#include "app/study/pool/member_runs.h"
#include "app/study/pool/study_result.h"
#include "app/study/publish/publish_calibration.h"
#include "app/study/publish/publish_study.h"
#include "app/study/record_files.h"
#include "app/study/statistics/importance.h"
#include "app/study/statistics/sensitivity.h"
#include "app/text/number_text.h"
#include "app/text/text_file.h"
#include "app/text/version.h"
#include "core/error.h"
#include "params/grammar/value_text.h"

namespace frana::app {
namespace {

// What the commands that run many members have in common.

/// The other processes of a study under mpirun; none otherwise. They end when these do.
struct OtherRanks {
    std::optional<study::Job> job;
    std::unique_ptr<study::RankPool> pool;  ///< in rank 0, if there are others

    /// Throws Error(input) if srun started several processes that cannot exchange messages.
    OtherRanks() {
        study::refuse_separate_processes();
        if (!study::started_as_rank()) return;
        job.emplace();
        if (job->rank() == 0 && job->size() > 1) pool = std::make_unique<study::RankPool>(*job);
    }
    /// They are not needed any more.
    void release() {
        pool.reset();
        job.reset();
    }
};

/// Returns the form of such a command.
/// @param what the study is called in its sentences
CommandForm study_form(const std::string& command, const std::string& meaning, const std::string& default_place,
                       const std::string& what, const std::string& operand = "STUDY.ini") {
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

/// Adds a problem for work that an interrupted study or run has kept for this result.
/// @param study folder of the interrupted study; empty: none
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

/// Throws Error(input) if the members kept in a folder belong to a study with another identity, with the differences.
/// @param then that of those members
void require_same_study(const std::string& identity, const std::string& then, const std::string& folder) {
    if (then == identity) return;
    throw Error(ErrorKind::input,
                Problem{"the members kept in " + folder +
                            " are of another study: " + joined(identity_differences(identity, then), "; "),
                        "--resume, --extend", "", "", "Restore the study as it was, or start anew: --overwrite alone"});
}

/// The lines of a study's identity that concern its first members.
std::string identity_of_first(const std::string& identity, std::size_t members) {
    std::string kept;
    bool keeps = true;
    for (std::size_t at = 0, end = 0; at < identity.size(); at = end) {
        end = std::min(identity.find('\n', at), identity.size() - 1) + 1;
        const std::string line = identity.substr(at, end - at);
        unsigned long long member = 0;
        char after = 0;
        // "member 7 KEY = VALUE", and "member 7:" before the scene of one whose files are its own
        const bool is_of_member = std::sscanf(line.c_str(), "member %llu%c", &member, &after) == 2;
        if (is_of_member && after == ':') keeps = member < members;
        if (is_of_member && after != ':' ? member < members : keeps) kept += line;
    }
    return kept;
}

/// Returns the number of members of a complete study with `more` of them. Throws Error(input) if it cannot have more.
/// @param more as the user wrote it
std::int64_t extended_samples(const study::StudySpec& study, const std::string& target, const std::string& more) {
    const auto refuse = [&](const std::string& what, const std::string& limit, const std::string& remedy) {
        throw Error(ErrorKind::input, Problem{what, "--extend", more, limit, remedy});
    };
    const std::size_t members = study::split_records(target, nullptr).members;
    const auto count = integer_from_text(more);
    const std::int64_t most = study::k_most_samples - static_cast<std::int64_t>(members);
    if (!count || *count < 1 || *count > most)
        refuse("is not a number of members to add", "1 to " + std::to_string(most), "Write for example --extend 100");
    const std::string all = std::to_string(static_cast<std::int64_t>(members > 0 ? members : study.samples) + *count),
                      anew = "run the study anew with study.samples = " + all + " and --overwrite";
    if (!study.is_extensible())
        refuse(study.sampling == study::Sampling::table
                   ? "the table gives all members"
                   : "a design of sampling = " + name_of(study.sampling) + " is made for its number of members",
               "sampling = sobol or random",
               study.sampling == study::Sampling::table
                   ? "Add to the table and run the study anew with --overwrite"
                   : "To keep the design, " + anew + "; with sampling = sobol members can be added later");
    if (members == 0)
        refuse("there is no complete study with the records of its members in " + target, "",
               "Run the study without --extend first; if it is complete but older, or its " +
                   std::string(k_joined_records) + " was removed, " + anew);
    return static_cast<std::int64_t>(members) + *count;
}

/// Whether a result is complete and of the same study: nothing is left to do. Throws Error(input) if it is the finished
/// result of another one.
bool is_complete(const std::string& identity, const std::string& target) {
    const auto manifest = read_manifest(target);
    if (!manifest || !manifest->finished) return false;
    if (manifest->scene_hash == text_hash(identity)) return true;
    throw Error(ErrorKind::input, Problem{"contains the finished result of another study", target, "", "",
                                          "Choose another folder with --out, or add --overwrite"});
}

/// Gives a written result its name, and returns the exit code. Throws Error(environment).
/// @param strict whether a run that was cut, left the ground or failed makes the exit code 3
int publish_result(const std::string& identity, const study::StudyOutcome& outcome, bool strict,
                   ResultDirectory& directory, RunLog& log) {
    const bool refused = strict && outcome.has_troubles;
    Warnings told;
    directory.publish({text_hash(identity), 0, true}, {log, told});
    remove_working_files(directory.target(), false, {log, told});
    log.info("result in " + directory.target());
    if (!refused && !outcome.too_many_failed) return static_cast<int>(ExitCode::done);
    log.print_deferred_warnings();
    return static_cast<int>(ExitCode::numerical);
}

/// With study.until, errors are looked at after so many members, whatever the number of threads; later after a quarter
/// more, so that all looks together cost a few times the last one, and processors seldom wait for a round's end.
std::size_t next_check(std::size_t members) {
    constexpr std::size_t k_first = 64;
    return members + std::max(k_first, members / 4 / study::k_replicates * study::k_replicates);
}

bool is_exact_enough(const study::StudyInput& input, const std::string& folder, std::size_t members) {
    const study::StudyResult result = study::read_study_result(input, folder, members);
    if (result.finished_at.size() < 2) return false;
    return study::largest_error(input, result) <= *input.reading.study.until;
}

/// What ran of a study.
struct MembersRun {
    std::size_t members = 0;   ///< that belong to it
    std::size_t computed = 0;  ///< of these in this session
    int stopped_by = 0;        ///< a signal
    std::optional<study::CalibrationRuns> calibration;
};

/// Runs the members below `end` with a runner of their own: importance sampling's table grows.
bool run_until(const study::StudyInput& input, const study::RunSetting& setting, std::size_t end, MembersRun& ran) {
    study::MemberRunner runner(input, setting.folder, setting.threads, setting.quiet, setting.ranks);
    const bool complete = runner.run_until(end);
    ran.members = end;
    ran.computed += runner.computed();
    ran.stopped_by = runner.stopped_by();
    return complete;
}

MembersRun run_sample(const study::StudyInput& input, const study::RunSetting& setting) {
    const std::size_t all = input.table.size();
    MembersRun ran;
    for (std::size_t end = 0;;) {
        end = input.reading.study.until ? std::min(all, next_check(end)) : all;
        if (!run_until(input, setting, end, ran) || end == all || is_exact_enough(input, setting.folder, end))
            return ran;
    }
}

/// Importance sampling: each round follows from the runs of those before, with their distances from the rare place.
MembersRun run_rounds(study::StudyInput& input, const study::RunSetting& setting) {
    MembersRun ran;
    study::ImportanceSampling sampling(input.reading.study);
    const study::RareEvent event = rare_event(input);
    while (run_until(input, setting, input.table.size(), ran) && input.table.size() < input.members()) {
        const study::StudyResult result = read_study_result(input, setting.folder, input.table.size());
        std::vector<double> distances(input.table.size(), k_no_data);
        const std::vector<double> known = distances_from_outline(
            result.finished, study::Quantity::depth, event.threshold, result.grid, *cell_at(result.grid, event.place));
        for (std::size_t i = 0; i < known.size(); ++i) distances[result.finished_at[i]] = known[i];
        sampling.add_round(distances, input.table);
    }
    return ran;
}

MembersRun run_members(study::StudyInput& input, const study::RunSetting& setting, RunLog& log) {
    if (!input.spec().is_calibration())
        return input.table.parts.empty() ? run_sample(input, setting) : run_rounds(input, setting);
    MembersRun ran;
    ran.calibration = study::run_calibration(input, setting, log);
    if (ran.calibration)
        ran.computed = ran.calibration->computed;
    else
        ran.stopped_by = stop_signal();
    return ran;
}

study::StudyOutcome publish(study::StudyInput& input, const MembersRun& ran, int threads, const Stopwatch& since_start,
                            ResultDirectory& directory, RunLog& log) {
    if (ran.calibration)
        return study::publish_calibration(input, *ran.calibration, threads, since_start, directory, log);
    input.base.result_folder = directory.target();
    if (input.spec().is_extensible()) study::join_records(directory.folder());
    return study::publish_study(input, ran.members, ran.computed, threads, since_start, directory, log);
}

/// Words for a kind of study in messages: itself, and what it runs.
struct StudyWords {
    const char *name, *members;
};
StudyWords words_of(study::StudyKind kind) {
    return kind == study::StudyKind::calibration ? StudyWords{"calibration", "runs"} : StudyWords{"study", "members"};
}

/// The files that a study needs: its result must not replace them.
std::vector<std::string> files_of(const study::StudyInput& texts) {
    std::vector<std::string> files = input_files(texts.central.scene);
    files.push_back(texts.reading.study.file);
    for (const study::StudyInput& event : texts.own)
        for (std::string& file : input_files(event.central.scene)) files.push_back(std::move(file));
    return files;
}

study::StudyInput prepared(study::StudyInput texts, const std::optional<Problem>& place, RunLog& log) {
    study::StudyInput input = study::prepare_study(std::move(texts), place, log);
    if (!input.spec().is_calibration())
        input.warnings += log.tell(doubt_exposure(input.base, !input.reading.study.region));
    return input;
}

/// Members that are there already are those of this study. Throws Error(input).
/// @param left an unfinished study that is continued  @param finished one that gets more members; empty: none
void require_same_members(const std::string& identity, const std::string& left, const std::string& finished) {
    if (!left.empty())
        require_same_study(identity, read_text_file((std::filesystem::path(left) / k_record_identity).string()), left);
    if (finished.empty()) return;
    const study::JoinedRecords old = study::split_records(finished, nullptr);
    require_same_study(identity_of_first(identity, old.members), identity_of_first(old.identity, old.members),
                       finished);
}

/// Returns the study of a result; of what is none itself.
std::string study_of(const std::string& operand) {
    const std::string own = (std::filesystem::path(operand) / k_study_file).string();
    return std::filesystem::is_regular_file(own) ? own : operand;
}

/// Throws Error(input) for a region, or for what is none.
void require_kind(const std::string& file, study::StudyKind kind) {
    const bool is_region = study::study_kind(file) == study::StudyKind::region;
    if (is_region && kind != study::StudyKind::region)
        throw Error(ErrorKind::input, Problem{"is a region of many slopes", file, "", "a study, with [study]",
                                              "Run it with `frana batch`"});
    if (!is_region && kind == study::StudyKind::region)
        throw Error(ErrorKind::input,
                    Problem{"has no section [region]", file, "", "",
                            "A single scene runs with `frana run`, a study with `frana ensemble`; a region names its "
                            "scene under [region]"});
}

/// Runs the members of a study, region or calibration and writes what they say together. Returns the exit code; throws
/// Error.
int run_study(study::StudyKind kind, const Options& values) {
    const Stopwatch since_start;
    const auto more = text_option(values, "extend");
    const std::string operand = values["operand"].as<std::string>(), file = more ? study_of(operand) : operand;
    require_kind(file, kind);
    OtherRanks ranks;
    if (more && ranks.job)
        throw Error(ErrorKind::input,
                    Problem{"cannot be used under mpirun", "--extend", *more, "", "Start one process"});
    const int threads = ranks.job && values.count("threads") == 0 ? 1 : thread_count(values);
    if (ranks.job && ranks.job->rank() > 0) {
        const auto read = [&] {
            RunLog silent(true);
            return prepared(study::read_study_texts(file, kind, {}, silent), std::nullopt, silent);
        };
        study::work_for_rank_0(*ranks.job, read, file, threads);
        return static_cast<int>(ExitCode::done);
    }
    const bool quiet = values.count("quiet") > 0, discards = values.count("overwrite") > 0,
               overwrite = discards || more, resume = values.count("resume") > 0;
    RunLog log(quiet);
    const Session session = session_of(values, log);

    study::StudyInput texts = study::read_study_texts(file, kind, session, log);
    const auto out = text_option(values, "out");
    const std::string place = out.value_or(file != operand ? operand
                                                           : study_directory(texts.reading.study, texts.central.scene)),
                      target = result_path(place);
    if (more)
        texts = study::read_study_texts(file, kind, session, log, extended_samples(texts.reading.study, target, *more));
    const std::string interrupted = interrupted_study(target);
    const bool may_be_complete = resume && !overwrite && interrupted.empty() && has_files(target);
    std::optional<Problem> place_problem;
    if (!may_be_complete)
        place_problem = check_result_directory(place, overwrite ? Older::replaced : Older::refused, files_of(texts),
                                               out ? "--out" : "the result's place", texts.central.problems);
    if (!resume && !discards) refuse_to_discard(target, interrupted, texts.central.problems);
    log.note(std::string(k_program) + " " + k_version + ", study " + texts.reading.study.file + ", " +
             std::to_string(threads) + " threads");
    study::StudyInput input = prepared(std::move(texts), place_problem, log);
    const StudyWords words = words_of(kind);
    if (may_be_complete && is_complete(input.identity, target)) {
        log.info(std::string("the ") + words.name + " is complete: " + target);
        remove_working_files(target, false, {log, input.warnings});
        return static_cast<int>(ExitCode::done);
    }
    for (const study::StudyInput* one : input.studies()) {
        load_drawing(one->base.spec.output.maps.front() != "off", false, Loading::now);
        refuse_study_beyond_memory(*one, forecast_study(*one, threads, false), threads,
                                   ranks.job ? ranks.job->ranks_here() : 1);
    }
    const std::string left = resume ? interrupted : "";
    require_same_members(input.identity, left, more ? target : "");

    catch_stop_signals();
    ResultDirectory directory(target, overwrite, !left.empty());
    directory.make_folder(k_record_folder);
    write_text_file(directory.path(k_record_identity), input.identity);
    if (more) {
        study::RecordFiles records(directory.folder());
        study::split_records(target, &records);
        records.sync();
    }
    if (ranks.pool) ranks.pool->start(input.identity);
    const int all_threads = threads * (ranks.job ? ranks.job->size() : 1);
    const MembersRun ran = run_members(input, {directory.folder(), threads, quiet, ranks.pool.get()}, log);
    ranks.release();
    if (ran.stopped_by != 0) {
        log.info(std::string("the ") + words.name + " was stopped after " +
                 std::to_string(study::count_records(directory.folder())) + " " + words.members +
                 ": the same command with --resume runs the others");
        return static_cast<int>(ExitCode::signal) + ran.stopped_by;
    }
    log.note("computed " + std::to_string(ran.computed) + " " + words.members + " in " +
             number_text(since_start.seconds(), 3) + " s");
    const study::StudyOutcome outcome = publish(input, ran, all_threads, since_start, directory, log);
    return publish_result(input.identity, outcome, values.count("strict") > 0, directory, log);
}

}  // namespace

Command command_ensemble() {
    CommandForm form =
        study_form("ensemble",
                   "Runs a scene many times with values drawn from their distributions and writes what the runs say "
                   "together:\nprobabilities, quantiles, sensitivities, with maps, charts, tables and a report.",
                   "that of the scene, with -ensemble", "study", "STUDY.ini|RESULT_DIR");
    form.options.add_options()(
        "extend", one("N"),
        "add so many members to a complete study, which may be named by its result (sampling sobol or random)");
    return {"ensemble", "many runs with uncertain values: probabilities, sensitivities", form,
            [](const Options& values) { return run_study(study::StudyKind::ensemble, values); }, true};
}

Command command_batch() {
    return {"batch", "each polygon of a layer as a slope of its own: union, scenarios, degree of hazard",
            study_form("batch",
                       "Runs each polygon of a release layer as a slope of its own and "
                       "writes their union:\ngreatest depth, speed and pressure, how many slopes reach each cell and "
                       "which is the worst, maps of each scenario,\nthe degree of hazard, one table, one project.",
                       "that of the scene, with -region", "region", "REGION.ini"),
            [](const Options& values) { return run_study(study::StudyKind::region, values); }, true};
}

Command command_calibrate() {
    return {
        "calibrate", "values that explain surveyed events, and how uncertain they stay",
        study_form("calibrate",
                   "Finds the values of uncertain keys that explain one or several surveyed events, and how uncertain "
                   "they stay:\na table of weighted members that `frana ensemble` takes, with charts and a report.",
                   "that of the first scene, with -calibration", "calibration"),
        [](const Options& values) { return run_study(study::StudyKind::calibration, values); }, true};
}

}  // namespace frana::app
