// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "app/study/member_record.h"
#include "app/study/plan/study_input.h"

namespace frana::app::study {

/// A member and its values; the study's table need not have it.
struct MemberTask {
    std::size_t member = 0;
    std::vector<std::string> overrides;  ///< "key=value"
    std::size_t study = 0;               ///< of several whose members one command runs, as a calibration's events
};

/// Returns the record of a member of this study: with its number and its values; none if there is no such record.
std::optional<MemberRecord> own_record(const StudyInput& input, const std::string& folder, std::size_t member);

/// Runs a member on one thread, as `frana run` computes it; several may run at once. A member that cannot be prepared
/// or ends early has failed, and its record says why. Returns none if `stops` said so before its end. Throws
/// Error(environment).
std::optional<MemberRecord> run_member(const StudyInput& input, const MemberTask& task,
                                       const std::function<bool()>& stops);

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

}  // namespace frana::app::study
