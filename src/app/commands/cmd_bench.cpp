// SPDX-License-Identifier: Apache-2.0
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

#include "app/commands/command_line.h"
#include "core/error.h"
#include "gis/access/file_access.h"

namespace frana::app {
namespace {

int cmd_bench(const Options& values) {
    std::error_code error;
    const std::string program =
        (std::filesystem::read_symlink("/proc/self/exe", error).parent_path() / "frana-bench").string();
    Arguments words = values.words;
    words.insert(words.begin(), program);
    if (gis::network_allowed()) words.emplace_back("--allow-network");
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    ::execv(program.c_str(), pointers.data());
    throw Error(ErrorKind::environment,
                Problem{errno == ENOENT ? "a part of frana is missing" : "a part of frana cannot be started", program,
                        errno == ENOENT ? "" : std::strerror(errno), "",
                        "Install frana anew, or build it anew with ./build.sh build"});
}

}  // namespace

Command command_bench() {
    CommandForm form{
        "frana bench accuracy|stability|speed [options]",
        "Measures frana itself. accuracy: cases with exact solutions, every scheme, several resolutions.\nstability: "
        "hard cases. speed: particle-steps per second. Prints the table; with --out also writes\naccuracy.csv and "
        "accuracy.png, stability.csv, or speed.csv and speed.png.\naccuracy takes a quarter of an hour, with --quick "
        "a minute.",
        "accuracy|stability|speed",
        {}};
    form.repeats = true;
    form.options.add_options()("out", one("FOLDER"), "folder for the files")(
        "quick", "accuracy: two resolutions; speed: at most a million particles")(
        "case", many("CASE"), "accuracy, stability: only this case (may be repeated)")(
        "threads", one("N"),
        "stability: threads of a run; speed: maximum number of threads (default: all; accuracy always uses one)");
    return {"bench", "tests of frana: exact solutions, hard cases, throughput", form, cmd_bench};
}

}  // namespace frana::app
