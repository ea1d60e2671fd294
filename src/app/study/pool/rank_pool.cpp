// SPDX-License-Identifier: Apache-2.0
#include "app/study/pool/rank_pool.h"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <exception>
#include <string>
#include <utility>

#include "app/process/signals.h"
#include "app/study/pool/member_threads.h"
#include "app/text/text_file.h"
#include "core/error.h"

namespace frana::app::study {
namespace {

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
int kind_of(RankMessage message) noexcept {
    return static_cast<int>(message);
}

/// Returns bytes with a number before them.
std::string with_number(std::size_t number, const std::string& rest = {});

std::string with_number(std::size_t number, const std::string& rest) {
    const std::uint64_t value = number;
    std::string bytes(sizeof value, '\0');
    std::memcpy(bytes.data(), &value, sizeof value);
    return bytes + rest;
}

/// Takes the number off again.
std::size_t take_number(std::string& bytes) {
    std::uint64_t value = 0;
    if (bytes.size() < sizeof value)
        throw Error(ErrorKind::environment, Problem{"a message of another rank is damaged", "MPI", "", "",
                                                    "Start the same version of frana on all machines"});
    std::memcpy(&value, bytes.data(), sizeof value);
    bytes.erase(0, sizeof value);
    return static_cast<std::size_t>(value);
}

std::string take_text(std::string& bytes) {
    const std::size_t size = take_number(bytes);
    std::string text = bytes.substr(0, size);
    bytes.erase(0, size);
    return text;
}

/// Returns a task as bytes.
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

/// Returns the kind and the first problem of an error as bytes.
std::string bytes_of(const Error& error, const std::string& rank) {
    const Problem& first = error.problems().front();
    std::string bytes = with_number(static_cast<std::size_t>(error.kind()));
    for (const std::string& text : {rank + ": " + first.what, first.where, first.value, first.limit, first.remedy})
        bytes += with_number(text.size(), text);
    return bytes;
}

/// Returns that error, which says in which rank it happened.
Error error_from(std::string bytes) {
    const auto kind = static_cast<ErrorKind>(take_number(bytes));
    Problem problem;
    for (std::string* const text : {&problem.what, &problem.where, &problem.value, &problem.limit, &problem.remedy})
        *text = take_text(bytes);
    return {kind, problem};
}

Message next_message(const Job& job) {
    for (;;) {
        if (auto message = job.receive()) return std::move(*message);
        wait_a_moment();
    }
}

bool is(const Message& message, RankMessage kind) {
    return message.kind == kind_of(kind);
}

void wait_for_stop(const Job& job) {
    while (!is(next_message(job), RankMessage::stop)) continue;
}

void send_problem(const Job& job, const std::exception_ptr& problem) {
    const auto send = [&](const Error& error) {
        job.send(0, kind_of(RankMessage::problem), bytes_of(error, job.name()));
    };
    try {
        std::rethrow_exception(problem);
    } catch (const Error& error) {
        send(error);
    } catch (const std::exception& error) {
        send({ErrorKind::environment,
              Problem{error.what(), "", "", "",
                      "If memory, threads or open files run out, start fewer ranks on a machine"}});
    }
}

void run_members(const Job& job, const std::vector<StudyInput>& studies, int threads) {
    std::vector<const StudyInput*> inputs;
    for (const StudyInput& one : studies) inputs.push_back(&one);
    MemberThreads members(std::move(inputs), threads);
    job.send(0, kind_of(RankMessage::ready), with_number(static_cast<std::size_t>(threads)));
    bool told = false;
    for (;;) {
        while (auto message = job.receive()) {
            if (is(*message, RankMessage::stop)) return;
            if (is(*message, RankMessage::member)) members.add(task_from(std::move(message->bytes)));
        }
        while (const auto record = members.take_record())
            job.send(0, kind_of(RankMessage::record), with_number(record->member, record->bytes));
        if (const std::exception_ptr problem = members.take_problem()) send_problem(job, problem);
        if (stop_signal() != 0 && !std::exchange(told, true))
            job.send(0, kind_of(RankMessage::interrupted), with_number(static_cast<std::size_t>(stop_signal())));
        wait_a_moment();
    }
}

}  // namespace

void work_for_rank_0(const Job& job, const std::function<RankStudies()>& read, const std::string& file, int threads) {
    catch_stop_signals();
    std::exception_ptr problem;
    RankStudies own;
    try {
        own = read();
    } catch (...) {
        problem = std::current_exception();
    }
    const Message first = next_message(job);
    if (is(first, RankMessage::start)) {
        if (!problem && text_hash(own.identity) != first.bytes)
            problem = std::make_exception_ptr(
                Error(ErrorKind::input, Problem{"reads another study, scene or other data than rank 0", file, "", "",
                                                "Give all machines the same files"}));
        if (problem) {
            send_problem(job, problem);
            wait_for_stop(job);
        } else {
            run_members(job, own.studies, threads);
        }
    }
    job.send(0, kind_of(RankMessage::bye));
}

RankPool::RankPool(Job& job) : job_(job) {}

RankPool::~RankPool() {
    for (int rank = 1; rank < job_.size(); ++rank) job_.send(rank, kind_of(RankMessage::stop));
    // A rank may be sending a record, and waits until it is received.
    for (int left = job_.size() - 1; left > 0;) {
        const auto message = job_.receive();
        if (!message) {
            wait_a_moment();
        } else if (message->kind == kind_of(RankMessage::bye)) {
            --left;
        }
    }
}

void RankPool::start(const std::string& identity) {
    for (int rank = 1; rank < job_.size(); ++rank) job_.send(rank, kind_of(RankMessage::start), text_hash(identity));
}

void RankPool::handle(Message& message, const std::function<void(std::size_t, const std::string&)>& keep) {
    switch (static_cast<RankMessage>(message.kind)) {
        case RankMessage::ready:
            free_.insert(free_.end(), take_number(message.bytes), message.from);
            return;
        case RankMessage::record: {
            const std::size_t member = take_number(message.bytes);
            free_.push_back(message.from);
            out_.erase(member);
            keep(member, message.bytes);
            return;
        }
        case RankMessage::problem:
            throw error_from(message.bytes);
        case RankMessage::interrupted:
            interrupted_ = static_cast<int>(take_number(message.bytes));
            return;
        case RankMessage::start:
        case RankMessage::member:
        case RankMessage::stop:
        case RankMessage::bye:
            return;  // of rank 0, or after its `stop`
    }
}

void RankPool::exchange(const std::function<std::optional<MemberTask>()>& take,
                        const std::function<void(std::size_t member, const std::string& record)>& keep) {
    while (auto message = job_.receive()) handle(*message, keep);
    while (!free_.empty()) {
        const auto task = take();
        if (!task) return;
        out_[task->member] = free_.front();
        job_.send(free_.front(), kind_of(RankMessage::member), bytes_of(*task));
        free_.pop_front();
    }
}

}  // namespace frana::app::study
