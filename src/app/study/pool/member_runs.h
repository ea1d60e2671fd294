// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "app/process/terminal.h"
#include "app/study/member_record.h"
#include "app/study/plan/study_input.h"
#include "app/study/ranks/job.h"
#include "app/study/record_files.h"

namespace frana::app::study {

/// A member and its values; the study's table need not have it.
struct MemberTask {
    std::size_t member = 0;
    std::vector<std::string> overrides;  ///< "key=value"
    std::size_t study = 0;               ///< of StudyInput::studies()
};

template <class Archive>
void serialise(Archive& archive, MemberTask& task) {
    archive(task.member, task.overrides, task.study);
}

/// Returns the record of a member of this study: with its number and its values; none if there is no such record.
std::optional<MemberRecord> own_record(const StudyInput& input, const RecordPlace& place, std::size_t member);

/// Returns the wall time of a member of the table on one thread, from its files to its record [s]; none if it takes
/// more processor time than `most`. Throws Error(environment).
std::optional<double> seconds_of_member(const StudyInput& input, std::size_t member, double most);

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

/// A rank other than 0 of a study: reads it, runs the members that rank 0 gives it, each on one thread, and sends their
/// records back. Writes neither files nor messages: rank 0 is told of problems. Returns once rank 0 has nothing more to
/// do.
/// @param file of the study, for messages
void work_for_rank_0(const Job& job, const std::function<StudyInput()>& read, const std::string& file, int threads);

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

/// Runs members side by side, each on one thread, in this process and in other ranks, and keeps a record of each in
/// RecordFiles, which this process alone writes. Those that have a record are not run again. Who runs
/// which member, and in which order, changes no bit of any record but its wall time.
class MemberRunner {
  public:
    /// @param folder in which the result is being built
    /// @param ranks the other processes; null: none
    /// @param study its number among StudyInput::studies() of what these have read
    MemberRunner(const StudyInput& input, const std::string& folder, int threads, bool quiet, RankPool* ranks = nullptr,
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
    RecordFiles records_;
    std::size_t threads_;
    RankPool* ranks_;
    std::size_t study_;
    std::size_t next_ = 0, end_ = 0;  ///< members below `next_` were given out or have a record
    std::size_t done_, total_;        ///< members with a record, also of earlier sessions; at most
    StatusLine line_;
    std::size_t computed_ = 0, out_ = 0;  ///< out: given to the threads of this process
    MemberThreads members_;
};

}  // namespace frana::app::study
