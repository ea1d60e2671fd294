// SPDX-License-Identifier: Apache-2.0
#include "app/commands/study_command.h"

#include <filesystem>

#include "app/commands/commands.h"
#include "app/store/interrupted_run.h"
#include "app/store/manifest.h"
#include "app/store/result_files.h"
#include "app/store/scene_identity.h"
#include "app/text/text_file.h"
#include "app/text/text_hash.h"
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
                      "--resume continues it; --overwrite starts anew and replaces it at the end"});
    if (const InterruptedRun run(target); !run.beside().empty())
        problems.add({"an interrupted run of it is kept in " + run.beside(), target, "", "",
                      "`frana run --resume` continues it; --overwrite replaces it at the end"});
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

int publish_result(const std::string& identity, const StudyOutcome& outcome, bool strict, ResultDirectory& directory,
                   RunLog& log) {
    const bool refused = strict && outcome.has_troubles;
    const std::vector<Problem> of_the_older = directory.publish({text_hash(identity), 0, true}, log);
    remove_working_files(directory.target(), false, log);
    log.info("result in " + directory.target());
    if (refused || outcome.too_many_failed || outcome.pictures_failed) log.print_deferred_warnings();
    if (!of_the_older.empty()) throw Error(ErrorKind::environment, of_the_older);
    if (refused || outcome.too_many_failed) return static_cast<int>(ExitCode::numerical);
    return static_cast<int>(outcome.pictures_failed ? ExitCode::environment : ExitCode::done);
}

}  // namespace frana::app
