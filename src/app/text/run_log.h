// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "app/process/terminal.h"
#include "core/error.h"
#include "core/words/warning.h"

namespace frana::app {

/// The actions of a run, in order, for log.txt; warnings also go to the terminal unless it is quiet.
class RunLog {
  public:
    explicit RunLog(bool quiet) : quiet_(quiet) {}

    void note(const std::string& text);
    /// Tells a fact that the user must know before relying on the result, and keeps it until it is taken.
    void warn(const Warning& warning);
    void warn_all(const Warnings& warnings) {
        for (const Warning& warning : warnings) warn(warning);
    }
    /// Tells what a result knows already.
    void tell(const Warnings& warnings);
    /// Returns what was found since the last call, for the values of a scene or a result: the log keeps texts only.
    [[nodiscard]] Warnings take_warnings() { return std::exchange(found_, {}); }
    /// Logs such facts about one thing: "DTM: ...".
    void warn_of(const Sentence& thing, const std::vector<Sentence>& warnings);
    /// Writes a line to the terminal and the log.
    void info(const std::string& text);

    /// Prints the warnings that were withheld by --quiet: an exit code other than 0 must be explained on the terminal.
    void print_deferred_warnings() const;

    /// Adds the lines of earlier sessions before those of this one.
    void continue_from(const std::vector<std::string>& earlier);

    [[nodiscard]] bool is_quiet() const noexcept { return quiet_; }
    [[nodiscard]] const std::vector<std::string>& lines() const noexcept { return lines_; }
    [[nodiscard]] std::string text() const;

  private:
    bool quiet_;
    Stopwatch since_start_;
    std::vector<std::string> lines_, withheld_;
    Warnings found_;
};

using frana::attempt;

/// Returns what `work` returns, or its empty value after an Error(input), which becomes a warning: `failed` has a place
/// for its message, "the survey could not be compared: {1}". Throws Error of other kinds.
template <class Work>
auto attempt(const char* failed, RunLog& log, const Work& work) {
    const auto warn = [&](const Error& error) {
        if (error.kind() != ErrorKind::input) throw error;
        log.warn(worded(failed, {std::string(error.what())}));
    };
    return attempt(warn, work);
}

}  // namespace frana::app
