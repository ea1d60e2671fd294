// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "app/process/terminal.h"
#include "core/words/warning.h"

namespace frana::app {

/// The actions of a run, in order, for log.txt; warnings also go to the terminal unless it is quiet.
class RunLog {
  public:
    explicit RunLog(bool quiet) : quiet_(quiet) {}

    void note(const std::string& text);
    /// Tells facts that the user must know before relying on a result, and returns them: the log keeps texts only.
    const Warnings& tell(const Warnings& warnings);
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
};

/// The warnings of a scene or a result that is being made; each is told when it is added.
struct Findings {
    RunLog& log;
    Warnings& warnings;

    void warn_all(const Warnings& more) const { warnings += log.tell(more); }
    void warn(const Warning& warning) const { warn_all({warning}); }
    /// Adds such facts about one thing: "DTM: ...".
    void warn_of(const Sentence& thing, const std::vector<Sentence>& facts) const {
        for (const Sentence& fact : facts) warn(worded("{1}: {2}", {thing, fact}));
    }
};

}  // namespace frana::app
