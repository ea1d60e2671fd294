// SPDX-License-Identifier: Apache-2.0
#include "app/ensemble/rank_worker.h"

#include <exception>
#include <utility>

#include "app/ensemble/member_threads.h"
#include "app/ensemble/rank_messages.h"
#include "app/process/signals.h"
#include "app/text/text_hash.h"

namespace frana::app {
namespace {

ranks::Message next_message(const ranks::Job& job) {
    for (;;) {
        if (auto message = job.receive()) return std::move(*message);
        ranks::wait_a_moment();
    }
}

bool is(const ranks::Message& message, RankMessage kind) {
    return message.kind == kind_of(kind);
}

void wait_for_stop(const ranks::Job& job) {
    while (!is(next_message(job), RankMessage::stop)) continue;
}

void send_problem(const ranks::Job& job, const std::exception_ptr& problem) {
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

void run_members(const ranks::Job& job, const std::vector<StudyInput>& studies, int threads) {
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
        ranks::wait_a_moment();
    }
}

}  // namespace

void work_for_rank_0(const ranks::Job& job, const std::function<RankStudies()>& read, const std::string& file,
                     int threads) {
    catch_stop_signals();
    std::exception_ptr problem;
    RankStudies own;
    try {
        own = read();
    } catch (...) {
        problem = std::current_exception();
    }
    const ranks::Message first = next_message(job);
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

}  // namespace frana::app
