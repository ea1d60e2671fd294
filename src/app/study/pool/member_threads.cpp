// SPDX-License-Identifier: Apache-2.0
#include "app/study/pool/member_threads.h"
#include "app/study/plan/study_input.h"

#include <chrono>
#include <utility>

#include "app/process/signals.h"
#include "app/publish/publish.h"
#include "app/store/interrupted_run.h"
#include "app/study/plan/region_input.h"
#include "simulation/simulation.h"

namespace frana::app::study {
namespace {

/// Files that members share come from memory: reading a terrain takes longer than all other preparation.
/// The slopes of a region have none in common but small ones, and their terrains together are too much to keep.
/// @param log of its own: its warnings are the member's
Prepared prepared_member(const StudyInput& input, const MemberTask& task, RunLog& log) {
    SceneReading reading = input.scene_with(task.overrides);
    if (input.reading.study.region) reading.session.reads = std::make_shared<RememberedReads>();
    reading.scene.observed = {};  // read once, for the maps
    reading.scene.output.profiles.reset();
    reading.scene.output.exposure.reset();
    if (const auto& region = input.reading.study.region) cut_terrain(*region, reading, log);
    Prepared prepared = prepare(reading, log);
    prepared.scene.time.frame_interval = 0;
    return prepared;
}

}  // namespace

std::optional<MemberRecord> own_record(const StudyInput& input, const std::string& folder, std::size_t member) {
    auto record = read_record(record_file(folder, member), member);
    if (record && record->key_values != values_text(input.table.overrides(member))) record.reset();
    return record;
}

std::optional<MemberRecord> run_member(const StudyInput& input, const MemberTask& task,
                                       const std::function<bool()>& stops) {
    RunLog log(true);
    try {
        if (!input.slopes.empty() && !input.slopes[task.member].problem.empty())
            throw Error(ErrorKind::input, Problem{input.slopes[task.member].problem, "", "", "", ""});
        const Prepared prepared = prepared_member(input, task, log);
        const Scene& scene = prepared.scene;
        RunOptions options;
        options.stop_requested = stops;
        const RunResult result = run(scene, options);
        if (result.stop_reason == StopReason::requested) return std::nullopt;
        RecordExtras extras = record_extras(input.base.spec);
        extras.pressure = extras.pressure || input.reading.study.per_polygon() || input.base.extra.exposure;
        extras.final_depth = input.keeps_final_depth;
        MemberRecord record = record_of(task.member, result, scene, input.base.spec.output.trace_threshold, extras);
        warn_without_pages(prepared, result, log);
        record.end.warnings = log.warnings();
        record.key_values = values_text(task.overrides);
        return record;
    } catch (const Error& error) {
        if (error.kind() == ErrorKind::environment) throw;
        MemberRecord record = empty_record(task.member, input.base.scene.grid);
        record.failure = describe(error.problems().front());
        record.end.warnings = log.warnings();
        record.key_values = values_text(task.overrides);
        return record;
    }
}

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
            std::string bytes = bytes_of(std::move(*record));
            const std::lock_guard lock(mutex_);
            records_.push_back({task->member, std::move(bytes)});
        } catch (...) {
            const std::lock_guard lock(mutex_);
            problem_ = std::current_exception();
        }
        finished_.notify_one();
    }
}

}  // namespace frana::app::study
