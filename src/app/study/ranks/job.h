// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "app/study/ranks/functions.h"

namespace frana::app::study {

/// Whether mpirun, mpiexec or srun started this process as one of some that can exchange messages.
bool started_as_rank() noexcept;
/// A process's number among those that were started together, as their starter tells it; needs no MPI.
struct StartedRank {
    int rank = 0, size = 1;
};
StartedRank started_rank() noexcept;
/// Throws Error(input) if srun started several processes that cannot.
void refuse_separate_processes();

/// The processes ("ranks") that were started together. To be used by one thread.
class Job {
  public:
    /// Begins MPI, which only a process started as a rank pays for. Throws Error(environment) if that is not possible.
    Job();
    /// Ends it together with all other ranks: waits for them.
    ~Job();
    Job(const Job&) = delete;
    Job& operator=(const Job&) = delete;

    [[nodiscard]] int rank() const noexcept { return rank_; }
    [[nodiscard]] int size() const noexcept { return size_; }
    /// Ranks on the same machine, this one included.
    [[nodiscard]] int ranks_here() const noexcept { return ranks_here_; }
    /// "rank 2 on node07".
    [[nodiscard]] std::string name() const;

    /// Messages of a rank to another arrive in their order.
    void send(int to, int kind, const std::string& bytes = {}) const { mpi_.send(to, kind, bytes); }
    /// Returns the next message that has arrived; does not wait.
    [[nodiscard]] std::optional<Message> receive() const;

  private:
    const MpiFunctions& mpi_;
    int rank_, size_, ranks_here_;
};

/// Lets another program use the processor for a moment. MPI's own waiting would occupy it.
void wait_a_moment();

}  // namespace frana::app::study
