// SPDX-License-Identifier: Apache-2.0
#include "app/ensemble/rank_messages.h"

#include <cstdint>
#include <cstring>

namespace frana::app {

std::string with_number(std::size_t number, const std::string& rest) {
    const std::uint64_t value = number;
    std::string bytes(sizeof value, '\0');
    std::memcpy(bytes.data(), &value, sizeof value);
    return bytes + rest;
}

std::size_t take_number(std::string& bytes) {
    std::uint64_t value = 0;
    if (bytes.size() < sizeof value)
        throw Error(ErrorKind::environment, Problem{"a message of another rank is damaged", "MPI", "", "",
                                                    "Start the same version of frana on all machines"});
    std::memcpy(&value, bytes.data(), sizeof value);
    bytes.erase(0, sizeof value);
    return static_cast<std::size_t>(value);
}

namespace {

std::string take_text(std::string& bytes) {
    const std::size_t size = take_number(bytes);
    std::string text = bytes.substr(0, size);
    bytes.erase(0, size);
    return text;
}

}  // namespace

std::string bytes_of(const MemberTask& task) {
    std::string bytes = with_number(task.member) + with_number(task.study);
    for (const std::string& text : task.overrides) bytes += with_number(text.size(), text);
    return bytes;
}

MemberTask task_from(std::string bytes) {
    MemberTask task{take_number(bytes), {}, take_number(bytes)};
    while (!bytes.empty()) task.overrides.push_back(take_text(bytes));
    return task;
}

std::string bytes_of(const Error& error, const std::string& rank) {
    const Problem& first = error.problems().front();
    std::string bytes = with_number(static_cast<std::size_t>(error.kind()));
    for (const std::string& text : {rank + ": " + first.what, first.where, first.value, first.limit, first.remedy})
        bytes += with_number(text.size(), text);
    return bytes;
}

Error error_from(std::string bytes) {
    const auto kind = static_cast<ErrorKind>(take_number(bytes));
    Problem problem;
    for (std::string* const text : {&problem.what, &problem.where, &problem.value, &problem.limit, &problem.remedy})
        *text = take_text(bytes);
    return {kind, problem};
}

}  // namespace frana::app
