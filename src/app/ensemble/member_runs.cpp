// SPDX-License-Identifier: Apache-2.0
#include "app/ensemble/member_runs.h"

#include <filesystem>
#include <thread>
#include <utility>
#include <vector>

#include "app/process/signals.h"
#include "app/store/saved_work.h"
#include "simulation/simulation.h"
#include "study/member_record.h"

namespace frana::app {
namespace {

/// The record of a member that has no result.
study::MemberRecord failed_record(std::size_t member, const GridSpec& grid, const Error& error) {
    study::MemberRecord record = study::empty_record(member, grid);
    record.failure = describe(error.problems().front());
    return record;
}

}  // namespace

MemberRunner::MemberRunner(const StudyInput& input, std::string folder, int threads, bool quiet)
    : input_(input),
      folder_(std::move(folder)),
      threads_(threads),
      progress_(records_in(folder_).size(), input.table.size(), quiet) {}

bool MemberRunner::stops() const {
    return stop_signal() != 0 || failed_;
}

void MemberRunner::run_member(std::size_t member) {
    const std::string file = record_file(folder_, member);
    if (std::filesystem::exists(file) && study::read_record(file)) return;
    study::MemberRecord record;
    try {
        Prepared prepared;
        {
            const std::lock_guard lock(reading_);
            RunLog silent(true);
            SceneReading reading = input_.member(member);
            reading.scene.scar = {};  // read once, for the maps: transforming it takes as long as all else
            reading.scene.output.profiles.reset();
            prepared = prepare(reading, silent);
        }
        prepared.scene.time.frame_interval = 0;
        RunOptions options;
        options.stop_requested = [this] { return stops(); };
        const RunResult result = run(prepared.scene, options);
        if (result.stop_reason == StopReason::requested) return;
        record = study::record_of(member, result, prepared.scene, input_.base.spec.output.trace_threshold);
    } catch (const Error& error) {
        if (error.kind() == ErrorKind::environment) throw;
        record = failed_record(member, input_.base.scene.grid, error);
    }
    study::write_record(file, std::move(record));
    ++computed_;
    progress_.add_member();
}

void MemberRunner::work(std::size_t end) {
    try {
        for (std::size_t member = next_++; member < end && !stops(); member = next_++) run_member(member);
    } catch (...) {
        const std::lock_guard lock(reporting_);
        if (!problem_) problem_ = std::current_exception();
        failed_ = true;
    }
}

bool MemberRunner::run_until(std::size_t end) {
    const std::size_t begin = next_;
    std::vector<std::thread> workers;
    for (int i = 1; i < threads_ && static_cast<std::size_t>(i) < end - begin; ++i)
        workers.emplace_back([this, end] { work(end); });
    work(end);
    for (std::thread& worker : workers) worker.join();
    next_ = end;  // each worker took one beyond
    progress_.finish();
    if (problem_) std::rethrow_exception(problem_);
    return stop_signal() == 0;
}

}  // namespace frana::app
