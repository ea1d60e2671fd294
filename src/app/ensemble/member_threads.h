// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "app/ensemble/member_run.h"

namespace frana::app {

/// Threads that run the members they are given and keep the records until somebody takes them. An
/// exception (of the environment: memory, a disk) is kept too. After a signal the threads end.
class MemberThreads {
  public:
    struct Record {
        std::size_t member = 0;
        std::string bytes;
    };

    /// @param studies by MemberTask::study
    MemberThreads(std::vector<const StudyInput*> studies, int count);
    /// Stops the members that run.
    ~MemberThreads();
    MemberThreads(const MemberThreads&) = delete;
    MemberThreads& operator=(const MemberThreads&) = delete;

    void add(MemberTask task);
    [[nodiscard]] std::optional<Record> take_record();
    [[nodiscard]] std::exception_ptr take_problem();
    /// Returns when there is something to take, or after so many milliseconds.
    void wait(int milliseconds);

  private:
    [[nodiscard]] std::optional<MemberTask> next();
    void work();
    void end();

    std::vector<const StudyInput*> studies_;
    std::mutex mutex_;
    std::condition_variable added_, finished_;
    std::deque<MemberTask> waiting_;
    std::deque<Record> records_;
    std::exception_ptr problem_;
    std::atomic<bool> ending_{false};
    std::vector<std::thread> threads_;
};

}  // namespace frana::app
