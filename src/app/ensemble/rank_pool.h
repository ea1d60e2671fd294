// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <string>

#include "app/ensemble/member_run.h"
#include "ranks/job.h"

namespace frana::app {

/// The other ranks of a study, seen from rank 0: each gets a member whenever one of its threads is free, and sends back
/// the record, which rank 0 alone writes: files need not appear on several machines at once.
class RankPool {
  public:
    explicit RankPool(ranks::Job& job);
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
    void handle(ranks::Message& message, const std::function<void(std::size_t, const std::string&)>& keep);

    ranks::Job& job_;
    std::deque<int> free_;            ///< ranks with a free thread, once for each of these
    std::map<std::size_t, int> out_;  ///< members given out, and to whom
    int interrupted_ = 0;
};

}  // namespace frana::app
