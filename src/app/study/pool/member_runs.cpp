// SPDX-License-Identifier: Apache-2.0
#include "app/study/pool/member_runs.h"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <ctime>
#include <exception>
#include <string>
#include <utility>

#include "app/input/check_inputs.h"
#include "app/process/terminal.h"
#include "app/publish/publish_hazard.h"
#include "app/study/plan/study_input.h"
#include "app/text/number_text.h"
#include "app/text/text_file.h"
#include "core/archive.h"
#include "core/error.h"
#include "core/files.h"
#include "params/keys/scene_parameters.h"
#include "simulation/simulation.h"

namespace frana::app::study {
namespace {

/// What a thread has read of the slope of its last member: the draws of a slope follow each other. The slopes of a
/// region have nothing in common but small files, and all of theirs would be too much to keep.
struct SlopeReads {
    const Slope* slope = nullptr;
    std::shared_ptr<RememberedReads> reads{};
};

/// Files that members share come from memory: reading a terrain takes longer than all other preparation.
Prepared prepared_member(const StudyInput& input, const MemberTask& task, SlopeReads& last, Findings found) {
    SceneReading reading = input.scene_with(task.overrides);
    if (input.reading.study.region) {
        if (const Slope& slope = input.slope_of(task.member); std::exchange(last.slope, &slope) != &slope)
            last.reads = std::make_shared<RememberedReads>();
        reading.session.reads = last.reads;
        reading.reads_on_demand = true;
    }
    reading.scene.observed = {};  // read once, for the maps
    reading.scene.output.profiles.reset();
    reading.scene.output.map_context.reset();
    reading.scene.output.exposure.reset();
    reading.scene.exposure = {};
    Prepared prepared = prepare(reading, found);
    if (const auto filled = filled_warning(input.base.ground); filled && input.reading.study.region)
        prepared.scene.warnings.push_back(*filled);  // known of the whole alone
    // Volumes of a frequency differ from that of the scene by intent; thin_volumes() judges their unit.
    if ((input.slopes.empty() ? input.spec().frequency : input.slope_of(task.member).frequency).volumes)
        std::erase_if(prepared.scene.warnings,
                      [](const Warning& warning) { return warning.words.pattern() == k_volume_warning; });
    prepared.scene.time.frame_interval = 0;
    prepared.scene.recording.intensity |= input.base.scene.recording.intensity;  // its exposed features may ask for it
    return prepared;
}

}  // namespace

std::optional<MemberRecord> own_record(const StudyInput& input, const RecordPlace& place, std::size_t member) {
    auto record = read_record(place);
    const bool is_own =
        record && record->member == member && record->key_values == values_text(input.table.overrides(member));
    return is_own ? std::move(record) : std::nullopt;
}

namespace {

/// Whether a member is run again for longer because time.end cut it: not if that is one of its values, if a table gives
/// them (it repeats runs, as a calibration's posterior does), or if more would be released or flow in later.
bool runs_on(const StudyInput& input, const MemberTask& task, const Scene& scene, const RunResult& result) {
    const auto is_end = [](const std::string& value) { return value.starts_with("time.end="); };
    const auto waits = [](const ReleasedArea& area) { return !area.failed; };
    return input.runs_on && input.reading.study.sampling != Sampling::table &&
           result.stop_reason == StopReason::end_time && motion_at_end(result).front && scene.inflows.empty() &&
           std::none_of(task.overrides.begin(), task.overrides.end(), is_end) &&
           std::none_of(result.released.begin(), result.released.end(), waits);
}

/// Runs a member on one thread, as `frana run` computes it; several may run at once. A member that cannot be prepared
/// or ends early has failed, and its record says why. Returns none if `stops` said so before its end. Throws
/// Error(environment).
std::optional<MemberRecord> run_member(const StudyInput& input, const MemberTask& task, SlopeReads& reads,
                                       const std::function<bool()>& stops) {
    RunLog silent(true);
    Warnings found;  // before it failed
    try {
        if (!input.slopes.empty() && !input.slope_of(task.member).problem.empty())
            throw Error(ErrorKind::input, Problem{input.slope_of(task.member).problem, "", "", "", ""});
        Prepared prepared = prepared_member(input, task, reads, {silent, found});
        const Scene& scene = prepared.scene;
        RunOptions options;
        options.stop_requested = stops;
        std::string state;  // before time.end shortened a step
        options.before_end = [&](const SaveState& save) {
            StateWriter writer(state);
            save(writer);
        };
        RunResult result = run(scene, options);
        if (runs_on(input, task, scene, result)) {  // as `frana run` with that time.end
            constexpr double k_longer = 10;
            prepared.scene.time.end = prepared.spec.time.end =
                std::min(k_longer * scene.time.end, find_parameter(scene_parameters(), "time.end")->range->highest);
            options.before_end = nullptr;
            StateReader reader(state);
            if (!state.empty()) options.saved = &reader;
            result = run(scene, options);
        }
        if (result.stop_reason == StopReason::requested) return std::nullopt;
        const OutputSpec& output = input.base.spec.output;
        const auto& fragility = input.base.extra.fragility;
        const RecordExtras extras{
            !output.pressure_thresholds.empty() || input.reading.study.region || input.base.extra.exposure,
            hazard_scheme_of(input.base.spec), input.kept_deposit,
            !output.momentum_flux_thresholds.empty() || (fragility && fragility->uses(HazardQuantity::momentum))};
        MemberRecord record = record_of(task.member, result, scene, output.trace_threshold, extras);
        record.end.warnings = result.warnings;
        record.key_values = values_text(task.overrides);
        return record;
    } catch (const Error& error) {
        if (error.kind() == ErrorKind::environment) throw;
        MemberRecord record = empty_record(task.member, input.base.scene.grid);
        record.failure = describe(error.problems().front());
        record.end.warnings = std::move(found);
        record.key_values = values_text(task.overrides);
        return record;
    }
}

template <class T>
std::optional<T> take_first(std::deque<T>& list) {
    if (list.empty()) return std::nullopt;
    std::optional<T> first(std::move(list.front()));
    list.pop_front();
    return first;
}

}  // namespace

std::optional<double> seconds_of_member(const StudyInput& input, std::size_t member, double most) {
    SlopeReads reads;
    const Stopwatch watch;
    const std::clock_t began = std::clock();
    const auto record = run_member(input, {member, input.table.overrides(member)}, reads, [&] {
        return static_cast<double>(std::clock() - began) > most * CLOCKS_PER_SEC || stop_signal() != 0;
    });
    return record ? std::optional(watch.seconds()) : std::nullopt;
}

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
    SlopeReads reads;
    while (const auto task = next()) {
        try {
            auto record =
                run_member(*studies_[task->study], *task, reads, [this] { return ending_ || stop_signal() != 0; });
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

/// Returns values as bytes.
template <class... T>
std::string packed(T... values) {
    std::string bytes;
    StateWriter writer(bytes);
    writer(values...);
    return bytes;
}

/// The same values again.
template <class... T>
void unpack(const std::string& bytes, T&... values) {
    StateReader reader(bytes);
    try {
        reader(values...);
    } catch (const Error&) {
        throw Error(ErrorKind::environment, Problem{"a message of another rank is damaged", "MPI", "", "",
                                                    "Start the same version of frana on all machines"});
    }
}

/// The kind and the first problem of an error, which says in which rank it happened.
std::string packed_error(const Error& error, const std::string& rank) {
    const Problem& first = error.problems().front();
    return packed(error.kind(), rank + ": " + first.what, first.where.text, first.value, first.limit, first.remedy);
}

Error error_from(const std::string& bytes) {
    ErrorKind kind = ErrorKind::environment;
    Problem problem;
    unpack(bytes, kind, problem.what, problem.where.text, problem.value, problem.limit, problem.remedy);
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
        job.send(0, kind_of(RankMessage::problem), packed_error(error, job.name()));
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

void run_members(const Job& job, const StudyInput& study, int threads) {
    MemberThreads members(study.studies(), threads);
    job.send(0, kind_of(RankMessage::ready), packed(static_cast<std::size_t>(threads)));
    bool told = false, has_spare = false;
    std::optional<Stopwatch> since_first;
    for (;;) {
        while (auto message = job.receive()) {
            if (is(*message, RankMessage::stop)) return;
            if (!is(*message, RankMessage::member)) continue;
            if (!since_first) since_first.emplace();
            MemberTask task;
            unpack(message->bytes, task);
            members.add(std::move(task));
        }
        while (const auto record = members.take_record()) {
            job.send(0, kind_of(RankMessage::record), packed(record->member, record->bytes));
            // Short members: as many wait here, so that no thread waits for a message. Long ones are better shared out.
            constexpr double k_short = 1;  // [s]
            if (!std::exchange(has_spare, true) && since_first->seconds() < k_short)
                job.send(0, kind_of(RankMessage::ready), packed(static_cast<std::size_t>(threads)));
        }
        if (const std::exception_ptr problem = members.take_problem()) send_problem(job, problem);
        if (stop_signal() != 0 && !std::exchange(told, true))
            job.send(0, kind_of(RankMessage::interrupted), packed(stop_signal()));
        wait_a_moment();
    }
}

}  // namespace

void work_for_rank_0(const Job& job, const std::function<StudyInput()>& read, const std::string& file, int threads) {
    catch_stop_signals();
    std::exception_ptr problem;
    StudyInput own;
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
            run_members(job, own, threads);
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
    std::size_t number = 0;
    switch (static_cast<RankMessage>(message.kind)) {
        case RankMessage::ready:
            unpack(message.bytes, number);
            free_.insert(free_.end(), number, message.from);
            return;
        case RankMessage::record: {
            std::string record;
            unpack(message.bytes, number, record);
            free_.push_back(message.from);
            out_.erase(number);
            keep(number, record);
            return;
        }
        case RankMessage::problem:
            throw error_from(message.bytes);
        case RankMessage::interrupted:
            unpack(message.bytes, interrupted_);
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
        job_.send(free_.front(), kind_of(RankMessage::member), packed(*task));
        free_.pop_front();
    }
}

MemberRunner::MemberRunner(const StudyInput& input, const std::string& folder, int threads, bool quiet, RankPool* ranks,
                           std::size_t study)
    : input_(input),
      records_(folder),
      threads_(static_cast<std::size_t>(threads)),
      ranks_(ranks),
      study_(study),
      done_(records_.count()),
      total_(std::max(input.members(), input.table.size())),
      line_(quiet),
      members_(std::vector<const StudyInput*>(study + 1, &input), threads) {}

int MemberRunner::stopped_by() const {
    return stop_signal() != 0 || ranks_ == nullptr ? stop_signal() : ranks_->interrupted();
}

std::optional<MemberTask> MemberRunner::take() {
    while (next_ < end_) {
        const std::size_t member = next_++;
        if (!own_record(input_, records_.place(member), member))
            return MemberTask{member, input_.table.overrides(member), study_};
    }
    return std::nullopt;
}

void MemberRunner::keep(std::size_t member, const std::string& record) {
    records_.append(member, record);
    ++computed_;
    ++done_;
    if (!line_.is_due()) return;
    const double left = line_.seconds() / static_cast<double>(computed_) * static_cast<double>(total_ - done_);
    line_.show("member " + std::to_string(done_) + " of at most " + std::to_string(total_) + "  " +
               duration_text(left) + " left at most");
}

void MemberRunner::run_until_all_are_back() {
    // One more than threads, so that none waits while a record is written.
    const std::size_t most_out = threads_ + 1;
    while (stopped_by() == 0) {
        if (const std::exception_ptr problem = members_.take_problem()) std::rethrow_exception(problem);
        while (const auto record = members_.take_record()) {
            --out_;
            keep(record->member, record->bytes);
        }
        for (; out_ < most_out; ++out_) {
            auto task = take();
            if (!task) break;
            members_.add(std::move(*task));
        }
        if (ranks_ != nullptr)
            ranks_->exchange([this] { return take(); },
                             [this](std::size_t member, const std::string& record) { keep(member, record); });
        if (out_ == 0 && (ranks_ == nullptr || !ranks_->has_members_out())) return;
        constexpr int k_message_wait = 1, k_signal_wait = 100;  // [ms]
        members_.wait(ranks_ != nullptr ? k_message_wait : k_signal_wait);
    }
}

bool MemberRunner::run_until(std::size_t end) {
    end_ = end;
    run_until_all_are_back();
    records_.sync();
    line_.finish();
    return stopped_by() == 0;
}

}  // namespace frana::app::study
