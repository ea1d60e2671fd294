// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "support/program.h"

namespace frana::test {

/// A call of the program that can be watched, stopped and killed while it runs. stdout and stderr are written to files.
class StartedProgram {
  public:
    /// @param program another one than frana, to be found in PATH, that starts it
    StartedProgram(const std::string& folder, const std::vector<std::string>& arguments,
                   const std::string& program = FRANA_PROGRAM);
    /// Kills it if it still runs.
    ~StartedProgram();
    StartedProgram(const StartedProgram&) = delete;
    StartedProgram& operator=(const StartedProgram&) = delete;

    void send(int signal_number) const;
    /// Stops it and returns when nothing of it runs any more; SIGCONT lets it go on.
    void pause() const;
    /// Polls every few milliseconds; returns false if the program ended without it.
    bool wait_until(const std::function<bool()>& happens);
    /// Waits for its end; the exit code is minus the signal's number if one killed it.
    Outcome wait();

  private:
    bool ended(bool block);

    std::string out_, err_;
    int child_ = -1, status_ = 0;
    bool ended_ = false;
};

}  // namespace frana::test
