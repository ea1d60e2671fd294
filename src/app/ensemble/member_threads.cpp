// SPDX-License-Identifier: Apache-2.0
#include "app/ensemble/member_threads.h"

#include <chrono>
#include <utility>

#include "app/process/signals.h"

namespace frana::app {
namespace {

template <class T>
std::optional<T> take_first(std::deque<T>& list) {
    if (list.empty()) return std::nullopt;
    std::optional<T> first(std::move(list.front()));
    list.pop_front();
    return first;
}

}  // namespace

MemberThreads::MemberThreads(std::vector<const StudyInput*> studies, int count) : studies_(std::move(studies)) {
    try {
        for (int i = 0; i < count; ++i) threads_.emplace_back([this] { work(); });
    } catch (...) {  // no thread could be created
        end();
        throw;
    }
}

MemberThreads::~MemberThreads() {
    end();
}

void MemberThreads::end() {
    {
        const std::lock_guard lock(mutex_);
        ending_ = true;
    }
    added_.notify_all();
    for (std::thread& thread : threads_) thread.join();
}

void MemberThreads::add(MemberTask task) {
    {
        const std::lock_guard lock(mutex_);
        waiting_.push_back(std::move(task));
    }
    added_.notify_one();
}

std::optional<MemberThreads::Record> MemberThreads::take_record() {
    const std::lock_guard lock(mutex_);
    return take_first(records_);
}

std::exception_ptr MemberThreads::take_problem() {
    const std::lock_guard lock(mutex_);
    return std::exchange(problem_, nullptr);
}

void MemberThreads::wait(int milliseconds) {
    std::unique_lock lock(mutex_);
    finished_.wait_for(lock, std::chrono::milliseconds(milliseconds),
                       [this] { return problem_ != nullptr || !records_.empty(); });
}

std::optional<MemberTask> MemberThreads::next() {
    std::unique_lock lock(mutex_);
    added_.wait(lock, [this] { return ending_ || !waiting_.empty(); });
    return ending_ ? std::nullopt : take_first(waiting_);
}

void MemberThreads::work() {
    while (const auto task = next()) {
        try {
            auto record = run_member(*studies_[task->study], *task, [this] { return ending_ || stop_signal() != 0; });
            if (!record) return;
            std::string bytes = study::bytes_of(std::move(*record));
            const std::lock_guard lock(mutex_);
            records_.push_back({task->member, std::move(bytes)});
        } catch (...) {
            const std::lock_guard lock(mutex_);
            problem_ = std::current_exception();
        }
        finished_.notify_one();
    }
}

}  // namespace frana::app
