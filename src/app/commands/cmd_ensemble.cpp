// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <boost/program_options/value_semantic.hpp>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "app/commands/command_line.h"
#include "app/commands/commands.h"
#include "app/commands/memory_limit.h"
#include "app/commands/study_check.h"
#include "app/ensemble/member_runs.h"
#include "app/ensemble/publish_study.h"
#include "app/ensemble/study_result.h"
#include "app/process/signals.h"
#include "app/process/stopwatch.h"
#include "app/store/interrupted_run.h"
#include "app/store/manifest.h"
#include "app/store/result_directory.h"
#include "app/store/result_files.h"
#include "app/store/result_place.h"
#include "app/store/saved_work.h"
#include "app/store/scene_identity.h"
#include "app/text/number_text.h"
#include "app/text/text_file.h"
#include "app/text/text_hash.h"
#include "app/text/version.h"
#include "params/grammar/value_text.h"

namespace frana::app {
namespace {

CommandForm ensemble_form() {
    namespace options = boost::program_options;
    CommandForm form{"frana ensemble STUDY.ini [options]",
                     "Runs a scene many times with values drawn from their distributions and writes what the runs say "
                     "together:\nprobabilities, quantiles, sensitivities, with maps, charts, tables and a report.",
                     "STUDY.ini",
                     {}};
    form.options.add_options()("out", options::value<std::string>(),
                               "result directory (default: that of the scene, with -ensemble)")(
        "threads", options::value<std::string>(), "members that run side by side (default: all processors)")(
        "overwrite", "replace an existing result")(
        "resume", "run only the members that a stopped or killed study has not finished")(
        "memory-limit", options::value<std::string>(), "refuse a study that would need more (4GB, 500MB)")(
        "quiet,q", "no progress, no warnings on the terminal (they are in log.txt)");
    return form;
}

std::string text_of_file(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

void refuse_to_discard(const std::string& target, const std::string& study, Problems& problems) {
    if (!study.empty())
        problems.add({"an interrupted study of it is kept in " + study, target, "", "",
                      "--resume continues it; --overwrite starts anew and replaces it at the end"});
    if (const InterruptedRun run(target); !run.beside().empty())
        problems.add({"an interrupted run of it is kept in " + run.beside(), target, "", "",
                      "`frana run --resume` continues it; --overwrite replaces it at the end"});
}

void require_same_study(const StudyInput& input, const std::string& folder) {
    const std::string then = text_of_file((std::filesystem::path(folder) / k_record_identity).string());
    if (then == input.identity) return;
    throw Error(ErrorKind::input, Problem{"the members kept in " + folder + " are of another study: " +
                                              joined(identity_differences(input.identity, then), "; "),
                                          "--resume", "", "",
                                          "Restore the study as it was, or start anew: --overwrite without --resume"});
}

/// With study.until, errors are looked at after so many members, whatever the number of threads.
constexpr std::size_t k_members_between_checks = 64;

bool is_exact_enough(const StudyInput& input, const std::string& folder, std::size_t members) {
    const StudyResult result = read_study_result(input, folder, members);
    if (result.finished_at.size() < 2) return false;
    const OutputSpec& output = input.base.spec.output;
    const auto error = [&](study::Quantity quantity, const std::vector<double>& thresholds) {
        return study::error_of_first(result.finished, result.finished.size(), quantity, result.grid, thresholds)
            .largest;
    };
    return std::max(error(study::Quantity::depth, output.depth_thresholds),
                    error(study::Quantity::velocity, output.velocity_thresholds)) <= *input.reading.study.until;
}

/// Runs the members; returns how many belong to the study, or none if a signal stopped it.
std::optional<std::size_t> run_members(const StudyInput& input, const std::string& folder, MemberRunner& runner) {
    const std::size_t all = input.table.size();
    if (!input.reading.study.until) return runner.run_until(all) ? std::optional(all) : std::nullopt;
    for (std::size_t end = std::min(all, k_members_between_checks);;
         end = std::min(all, end + k_members_between_checks)) {
        if (!runner.run_until(end)) return std::nullopt;
        if (end == all || is_exact_enough(input, folder, end)) return end;
    }
}

/// A complete result of the same study: nothing is left to do.
bool is_complete(const StudyInput& input, const std::string& target) {
    const auto manifest = read_manifest(target);
    if (!manifest || !manifest->finished.value_or(false)) return false;
    if (manifest->scene_hash == text_hash(input.identity)) return true;
    throw Error(ErrorKind::input, Problem{"contains the finished result of another study", target, "", "",
                                          "Choose another folder with --out, or add --overwrite"});
}

}  // namespace

int cmd_ensemble(const Arguments& arguments) {
    const Stopwatch since_start;
    const auto values = parse_arguments(ensemble_form(), arguments);
    if (!values) return static_cast<int>(ExitCode::done);
    const int threads = thread_count(*values);
    const bool quiet = values->count("quiet") > 0, overwrite = values->count("overwrite") > 0,
               resume = values->count("resume") > 0;
    RunLog log(quiet);
    apply_memory_limit(*values, log);

    StudyTexts texts = read_study_texts((*values)["operand"].as<std::string>());
    const auto out = text_option(*values, "out");
    const std::string place = out.value_or(study_directory(texts.central.scene)), target = result_path(place);
    const std::string interrupted = interrupted_study(target);
    const bool may_be_complete = resume && !overwrite && interrupted.empty() && has_files(target);
    std::vector<std::string> inputs = input_files(texts.central.scene);
    inputs.push_back(texts.reading.study.file);
    std::optional<Problem> place_problem;
    if (!may_be_complete)
        place_problem = check_result_directory(place, overwrite, inputs, out ? "--out" : "the result's place",
                                               texts.central.problems);
    if (!resume && !overwrite) refuse_to_discard(target, interrupted, texts.central.problems);
    log.note(std::string(k_program) + " " + k_version + ", study " + texts.reading.study.file + ", " +
             std::to_string(threads) + " threads");
    StudyInput input = prepare_study(std::move(texts), place_problem, log);
    if (may_be_complete && is_complete(input, target)) {
        log.info("the study is complete: " + target);
        remove_working_files(target, false, log);
        return static_cast<int>(ExitCode::done);
    }
    refuse_study_beyond_memory(input, forecast_study(input, threads, false), threads);
    const std::string left = resume ? interrupted : "";
    if (!left.empty()) require_same_study(input, left);

    catch_stop_signals();
    ResultDirectory directory(target, overwrite, left);
    directory.make_folder(k_record_folder);
    write_text_file(directory.path(k_record_identity), input.identity);
    MemberRunner runner(input, directory.folder(), threads, quiet);
    const auto members = run_members(input, directory.folder(), runner);
    if (!members) {
        log.info("the study was stopped after " + std::to_string(records_in(directory.folder()).size()) +
                 " members: the same command with --resume runs the others");
        return static_cast<int>(ExitCode::signal) + stop_signal();
    }
    log.note("computed " + std::to_string(runner.computed()) + " members in " + number_text(since_start.seconds(), 3) +
             " s");
    const StudyOutcome outcome =
        publish_study({input, *members, runner.computed(), threads, since_start}, directory, log);
    const std::vector<Problem> of_the_older = directory.publish({text_hash(input.identity), 0, true}, log);
    remove_working_files(directory.target(), false, log);
    log.info("result in " + directory.target());
    if (outcome.too_many_failed || outcome.pictures_failed) log.print_deferred_warnings();
    if (!of_the_older.empty()) throw Error(ErrorKind::environment, of_the_older);
    if (outcome.too_many_failed) return static_cast<int>(ExitCode::numerical);
    return static_cast<int>(outcome.pictures_failed ? ExitCode::environment : ExitCode::done);
}

}  // namespace frana::app
