// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

#include "app/ensemble/member_run.h"
#include "core/error.h"

namespace frana::app {

/// What the ranks of a study send each other. Rank 0 reads, gives out members and writes; the others compute.
enum class RankMessage {
    start,        ///< from rank 0: a hash of what decides its members
    member,       ///< from rank 0: a task
    stop,         ///< from rank 0: nothing more is to be done
    ready,        ///< to rank 0: number of members that may run at once
    record,       ///< to rank 0: number of a member and its record
    problem,      ///< to rank 0: the texts of an error
    interrupted,  ///< to rank 0: number of the signal
    bye,          ///< to rank 0, after `stop`: the last message
};
inline int kind_of(RankMessage message) noexcept {
    return static_cast<int>(message);
}

/// Returns bytes with a number before them.
std::string with_number(std::size_t number, const std::string& rest = {});
/// Takes the number off again.
std::size_t take_number(std::string& bytes);

/// Returns a task as bytes.
std::string bytes_of(const MemberTask& task);
MemberTask task_from(std::string bytes);

/// Returns the kind and the first problem of an error as bytes.
std::string bytes_of(const Error& error, const std::string& rank);
/// Returns that error, which says in which rank it happened.
Error error_from(std::string bytes);

}  // namespace frana::app
