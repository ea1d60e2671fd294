// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace frana::app {

/// Wall time since construction.
class Stopwatch {
  public:
    [[nodiscard]] double seconds() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    }

  private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Makes a file beyond the process's size limit, or a closed pipe, an error like a full disk instead of the end of the
/// process.
void ignore_file_signals();

/// Opens those of stdin, stdout and stderr that were closed before the program began on /dev/null: otherwise the next
/// opened file would get one of their numbers, and messages would be written into it.
void fill_standard_streams();

/// From now on SIGINT, SIGTERM and SIGHUP are only recorded, so that a run can stop in order; a second one ends the
/// process at once. SIGHUP remains ignored if it was at the start (nohup).
void catch_stop_signals();

/// Returns the signal received (1, 2 or 15); 0 if none.
int stop_signal() noexcept;

/// A line on stderr that says how far a command is: updated in place on a terminal, else a new line every ten seconds.
class StatusLine {
  public:
    explicit StatusLine(bool quiet);
    /// Whether the next line is to be shown now; asked often, so that lines are made only then.
    [[nodiscard]] bool is_due() const;
    void show(const std::string& line);
    /// Clears the updated line.
    void finish();
    /// Since the start [s].
    [[nodiscard]] double seconds() const { return since_start_.seconds(); }

  private:
    bool quiet_, terminal_, is_open_ = false;
    double next_;  ///< seconds after the start
    Stopwatch since_start_;
};

/// A width at which nothing is wrapped.
inline constexpr std::size_t k_any_width = 100'000;

/// Returns the columns that a text on stdout may take: those of the terminal, or of COLUMNS if the terminal does not
/// tell, or 80; `k_any_width` where stdout is no terminal, so that files and pipes do not depend on a window.
std::size_t output_width();

}  // namespace frana::app
