// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <string>

namespace frana::test {

/// Returns FRANA_SEED, else 1: the default tests run the same trials every time.
std::uint64_t trial_seed();

/// Returns FRANA_TRIALS, else `usual`.
int trial_count(int usual);

/// Counts trials by their kind, and reports at the end, on stdout and in the test's record, their number, how the
/// program ended in them, and in how many the test failed.
class Trials {
  public:
    Trials();
    ~Trials();
    Trials(const Trials&) = delete;
    Trials& operator=(const Trials&) = delete;

    /// Begins one, and ends the previous one.
    void begin(const std::string& kind);
    void ended(int exit_code) { ++kinds_[kind_].endings[exit_code]; }

  private:
    struct Kind {
        int count = 0, failed = 0;
        std::map<int, int> endings;  ///< by exit code
    };
    void settle();

    std::map<std::string, Kind> kinds_;
    std::string kind_;
    int failures_before_ = 0;
};

}  // namespace frana::test
