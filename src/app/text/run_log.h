// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "app/process/terminal.h"
#include "core/error.h"
#include "core/words/sentence.h"

namespace frana::app {

/// The actions of a run, in order, for log.txt; warnings also go to the terminal unless it is quiet.
class RunLog {
  public:
    explicit RunLog(bool quiet) : quiet_(quiet) {}

    void note(const std::string& text);
    /// Logs a fact that the user must know before relying on the result.
    void warn(const Sentence& warning);
    void warn_all(const std::vector<Sentence>& warnings) {
        for (const Sentence& warning : warnings) warn(warning);
    }
    /// The same for what must be read before all other warnings, although it was found after some of them.
    void warn_first(const std::vector<Sentence>& warnings);
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
    [[nodiscard]] const std::vector<Sentence>& warnings() const noexcept { return warnings_; }
    [[nodiscard]] std::string text() const;

  private:
    void tell(const Sentence& warning);

    bool quiet_;
    Stopwatch since_start_;
    std::vector<std::string> lines_;
    std::vector<Sentence> warnings_;
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
