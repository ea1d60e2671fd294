// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <string>

#include "app/ensemble/member_progress.h"
#include "app/ensemble/study_input.h"

namespace frana::app {

/// Runs members side by side, each on one thread, as `frana run` computes them, and writes a record of each to a folder
/// of the result (record_file). Those that have a record are not run again. Which thread runs which member, and in
/// which order, changes no bit of any record but its wall time. Files are read by one member at a time, for GDAL and
/// PROJ keep tables of their own. A member that cannot be prepared or ends early has failed, and its record says why;
/// an error of the environment ends the study.
class MemberRunner {
  public:
    /// @param folder in which the result is being built
    MemberRunner(const StudyInput& input, std::string folder, int threads, bool quiet);

    /// Runs the members below `end` that have no record. Returns false if a signal stopped it before. Throws
    /// Error(environment).
    bool run_until(std::size_t end);
    /// Members computed so far, without those of earlier sessions.
    [[nodiscard]] std::size_t computed() const noexcept { return computed_; }

  private:
    void work(std::size_t end);
    void run_member(std::size_t member);
    [[nodiscard]] bool stops() const;

    const StudyInput& input_;
    std::string folder_;
    int threads_;
    MemberProgress progress_;
    std::atomic<std::size_t> next_{0}, computed_{0};
    std::atomic<bool> failed_{false};
    std::mutex reading_, reporting_;
    std::exception_ptr problem_;
};

}  // namespace frana::app
