// SPDX-License-Identifier: Apache-2.0
#include "app/study/ranks/job.h"

#include <chrono>
#include <cstdlib>
#include <thread>

#include "core/error.h"
#include "core/module.h"

namespace frana::app::study {
namespace {

/// Variables by which those who start ranks tell how many there are, and a process's number.
struct Starter {
    const char *size, *rank;
};
constexpr Starter k_open_mpi{"OMPI_COMM_WORLD_SIZE", "OMPI_COMM_WORLD_RANK"}, k_pmi{"PMI_SIZE", "PMI_RANK"},
    k_step{"SLURM_STEP_NUM_TASKS", "SLURM_PROCID"};
/// A rank of PMIx (srun --mpi=pmix) knows the number from Slurm.
constexpr const char* k_pmix = "PMIX_NAMESPACE";

/// 0: not set.
int number_in(const char* variable) {
    const char* const text = std::getenv(variable);
    return text == nullptr ? 0 : std::atoi(text);
}

const MpiFunctions& begun() {
    // MPI's plugins look for its functions in the whole process.
    const auto& mpi = module_table<MpiFunctions>("mpi", ModuleScope::process);
    mpi.begin();
    return mpi;
}

}  // namespace

bool started_as_rank() noexcept {
    return number_in(k_open_mpi.size) > 0 || number_in(k_pmi.size) > 0 || std::getenv(k_pmix) != nullptr;
}

StartedRank started_rank() noexcept {
    for (const Starter& one : {k_open_mpi, k_pmi, k_step})
        if (const int size = number_in(one.size); size > 0) return {number_in(one.rank), size};
    return {};
}

void refuse_separate_processes() {
    if (started_as_rank() || number_in(k_step.size) <= 1) return;
    throw Error(ErrorKind::input, Problem{"srun started several processes that cannot exchange messages",
                                          std::string(k_step.size) + " = " + std::getenv(k_step.size), "", "",
                                          "Add --mpi=pmix to srun, or use mpirun"});
}

Job::Job() : mpi_(begun()), rank_(mpi_.rank()), size_(mpi_.size()), ranks_here_(mpi_.ranks_here()) {
    const int expected = started_rank().size;
    if (size_ == 1 && expected > 1)
        throw Error(ErrorKind::environment,
                    Problem{"is one of " + std::to_string(expected) +
                                " processes started by another MPI than the one that frana is built with",
                            "MPI", "", "", "Start it with mpirun.openmpi, or the mpirun of that MPI"});
}

Job::~Job() {
    mpi_.end();
}

std::string Job::name() const {
    return "rank " + std::to_string(rank_) + " on " + mpi_.host();
}

std::optional<Message> Job::receive() const {
    Message message;
    if (!mpi_.receive(message)) return std::nullopt;
    return message;
}

void wait_a_moment() {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

}  // namespace frana::app::study
