// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "app/process/stopwatch.h"

namespace frana::app {

/// What was done, in order, for log.txt; warnings also go to the terminal unless it is to stay quiet.
class RunLog {
  public:
    explicit RunLog(bool quiet) : quiet_(quiet) {}

    void note(const std::string& text);
    /// Something the user must know before trusting the result.
    void warn(const std::string& text);
    /// A line for the terminal as well as the log.
    void info(const std::string& text);

    /// The warnings that were held back to be quiet: an exit code other than 0 has its reason on the terminal.
    void print_deferred_warnings() const;

    /// Lines of the session that this one continues, to stand before its own.
    void continue_from(const std::vector<std::string>& earlier);

    [[nodiscard]] const std::vector<std::string>& lines() const noexcept { return lines_; }
    [[nodiscard]] const std::vector<std::string>& warnings() const noexcept { return warnings_; }
    [[nodiscard]] std::string text() const;

  private:
    bool quiet_;
    Stopwatch since_start_;
    std::vector<std::string> lines_;
    std::vector<std::string> warnings_;
};

}  // namespace frana::app
