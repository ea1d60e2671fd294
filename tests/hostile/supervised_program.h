// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "support/program.h"
#include "watched_calls.h"

namespace frana::test {

/// A system call about to be made.
struct SystemCall {
    std::string name;  ///< rename, pwrite64 ...
    std::string path;  ///< relative to the folder watched; for a rename the new name; random letters and numbers of a
                       ///< name are *
    int again = 0;     ///< earlier calls of this name on this path

    /// The same call in another run of the same command.
    [[nodiscard]] bool operator==(const SystemCall&) const = default;
    [[nodiscard]] std::string text() const {
        return name + " of " + path + (again > 0 ? ", time " + std::to_string(again + 1) : "");
    }
};

/// The answer to a call.
struct Answer {
    enum class Kind { proceed, fail, shorten, signal } kind = Kind::proceed;
    int number = 0;  ///< errno to fail with; signal to send before the call (SIGKILL: it is not made)
};
using Judge = std::function<Answer(const SystemCall&)>;

struct Launch {
    std::vector<std::string> arguments;
    std::vector<std::string> environment{};  ///< NAME=value, added
    double stop_after_seconds = 0;           ///< SIGTERM then; 0: never
    double patience_seconds = 0;             ///< SIGKILL then; 0: longer than anything takes on a busy machine
    int processors = 0;                      ///< available to it; 0: all
};

struct Ending : Outcome {
    bool hung = false;  ///< it did not end in time and was killed
    std::vector<SystemCall> calls;
};

/// Whether calls can be watched here: kernels before 5.0 and some containers do not allow it.
bool can_watch_calls();

/// Runs frana in a folder to its end. `judge`, if given, decides on every watched call on a file below the folder (or
/// on memory).
Ending run_supervised(const std::string& folder, const Launch& launch, const Watch& watch = {},
                      const Judge& judge = {});

}  // namespace frana::test
