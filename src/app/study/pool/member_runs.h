// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "app/process/terminal.h"
#include "app/study/plan/study_input.h"
#include "app/study/pool/member_threads.h"
#include "app/study/pool/rank_pool.h"

namespace frana::app::study {

/// Shows how many members have run and the time left.
class MemberProgress {
  public:
    /// @param done members that ran before the study was resumed
    MemberProgress(std::size_t done, std::size_t total, bool quiet);
    void add_member();
    /// Clears the updated line.
    void finish();

  private:
    std::size_t done_, total_, here_ = 0;
    StatusLine line_;
};

/// Runs members side by side, each on one thread, in this process and in other ranks, and writes a record of each to a
/// folder of the result (record_file), by this process alone. Those that have a record are not run again. Who runs
/// which member, and in which order, changes no bit of any record but its wall time.
class MemberRunner {
  public:
    /// @param folder in which the result is being built
    /// @param ranks the other processes; null: none
    /// @param study its number among the studies that these have read (RankStudies)
    MemberRunner(const StudyInput& input, std::string folder, int threads, bool quiet, RankPool* ranks = nullptr,
                 std::size_t study = 0);

    /// Runs the members below `end` that have no record. Returns false if a signal stopped it before. Throws
    /// Error(environment).
    bool run_until(std::size_t end);
    /// Members computed so far, without those of earlier sessions.
    [[nodiscard]] std::size_t computed() const noexcept { return computed_; }
    /// The signal that stopped this process or a rank; 0: none.
    [[nodiscard]] int stopped_by() const;

  private:
    void run_until_all_are_back();
    void keep(std::size_t member, const std::string& record);

    [[nodiscard]] std::optional<MemberTask> take();

    const StudyInput& input_;
    std::string folder_;
    std::size_t threads_;
    RankPool* ranks_;
    std::size_t study_;
    std::size_t next_ = 0, end_ = 0;  ///< members below `next_` were given out or have a record
    MemberProgress progress_;
    std::size_t computed_ = 0, out_ = 0;  ///< out: given to the threads of this process
    MemberThreads members_;
};

}  // namespace frana::app::study
