// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/study/plan/study_input.h"
#include "app/study/pool/member_threads.h"
#include "app/study/ranks/job.h"

namespace frana::app::study {

/// What a rank reads: everything of which rank 0 may give it members.
struct RankStudies {
    std::vector<StudyInput> studies;  ///< by MemberTask::study
    std::string identity;             ///< as rank 0 has it (RankPool::start)
};

/// A rank other than 0 of a study: reads it, runs the members that rank 0 gives it, each on one thread, and sends their
/// records back. Writes neither files nor messages: rank 0 is told of problems. Returns once rank 0 has nothing more to
/// do.
/// @param file of the study, for messages
void work_for_rank_0(const Job& job, const std::function<RankStudies()>& read, const std::string& file, int threads);

/// The other ranks of a study, seen from rank 0: each gets a member whenever one of its threads is free, and sends back
/// the record, which rank 0 alone writes: files need not appear on several machines at once.
class RankPool {
  public:
    explicit RankPool(Job& job);
    /// Tells them that nothing more is to be done, whatever happened, and waits until they have stopped.
    ~RankPool();
    RankPool(const RankPool&) = delete;
    RankPool& operator=(const RankPool&) = delete;

    /// The study is ready: they may ask for members once they have read the same.
    /// @param identity facts that decide the members, the same in every rank
    void start(const std::string& identity);
    /// Handles the messages that have arrived and gives out members; does not wait. Throws what went wrong in a rank,
    /// and what `keep` throws.
    void exchange(const std::function<std::optional<MemberTask>()>& take,
                  const std::function<void(std::size_t member, const std::string& record)>& keep);
    [[nodiscard]] bool has_members_out() const noexcept { return !out_.empty(); }
    /// The signal that stopped a rank; 0: none.
    [[nodiscard]] int interrupted() const noexcept { return interrupted_; }

  private:
    void handle(Message& message, const std::function<void(std::size_t, const std::string&)>& keep);

    Job& job_;
    std::deque<int> free_;            ///< ranks with a free thread, once for each of these
    std::map<std::size_t, int> out_;  ///< members given out, and to whom
    int interrupted_ = 0;
};

}  // namespace frana::app::study
