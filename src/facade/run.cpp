// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <deque>
#include <thread>
#include <utility>

#include "facade/inside.h"
#include "simulation/run_check.h"
#include "simulation/stepped_run.h"

namespace frana::facade {

struct Run::Data {
    Grid grid;
    EngineScene prepared;
    Options options;
    RunOptions engine_options;
    std::deque<frana::Frame> frames;
    bool wants_frames = true;
    std::unique_ptr<SteppedRun> run;               ///< null: ended
    std::shared_ptr<const Result::Data> result{};  ///< null: not ended
    double time = 0;

    void step() {
        run->step();
        time = run->progress().time;
        if (options.on_progress) options.on_progress(time);
    }
    void finish() {
        RunResult ended = run->finish();
        run.reset();
        result = result_data(std::move(ended), prepared, grid);
    }
};

namespace {

/// Throws Error(input) for what a run cannot have.
int thread_count(int asked) {
    constexpr int k_most = 1024;
    if (asked == 0) return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    if (asked < 0 || asked > k_most)
        throw frana::Error(ErrorKind::input, frana::Problem{"is out of range", "threads", std::to_string(asked),
                                                            "0 to " + std::to_string(k_most), "0 means all there are"});
    return asked;
}

std::unique_ptr<Run::Data> started(const Scene& scene, Options options, bool wants_frames) {
    return guarded([&] {
        auto data = std::make_unique<Run::Data>();
        data->grid = scene.grid();
        data->prepared = prepare_scene(scene.data());
        data->options = std::move(options);
        data->wants_frames = wants_frames;
        data->engine_options.threads = thread_count(data->options.threads);
        data->engine_options.stop_requested = data->options.stop_requested;
        data->engine_options.on_frame = [to = data.get()](frana::Frame frame) {
            if (to->wants_frames) to->frames.push_back(std::move(frame));
        };
        if (!wants_frames) data->engine_options.on_frame = nullptr;
        data->run = std::make_unique<SteppedRun>(data->prepared.scene, data->engine_options);
        return data;
    });
}

Result result_of(const std::shared_ptr<const Result::Data>& data) {
    Result result(data);
    if (data->result.run_problems.empty()) return result;
    std::vector<Problem> problems;
    std::string text = "the run failed";
    for (const RunProblem& problem : data->result.run_problems) {
        problems.push_back({describe(problem), "", "", "", ""});
        text += "\n" + problems.back().what;
    }
    throw RunFailed(text, std::move(problems), std::move(result));
}

Result end_of(Run::Data& data) {
    data.wants_frames = false;
    data.frames.clear();
    guarded([&] {
        while (data.run && data.run->continues()) data.step();
        if (data.run) data.finish();
    });
    return result_of(data.result);
}

}  // namespace

Run::Run(const Scene& scene, Options options) : data_(started(scene, std::move(options), true)) {}
Run::Run(Run&& other) noexcept = default;
Run& Run::operator=(Run&& other) noexcept = default;
Run::~Run() = default;

std::optional<Frame> Run::next() {
    return guarded([&]() -> std::optional<Frame> {
        while (data_->frames.empty() && data_->run && data_->run->continues()) data_->step();
        if (data_->frames.empty() && data_->run) data_->finish();
        if (data_->frames.empty()) return std::nullopt;
        auto frame = std::make_shared<Frame::Data>(Frame::Data{std::move(data_->frames.front()), data_->grid});
        data_->frames.pop_front();
        return Frame(std::move(frame));
    });
}

double Run::time() const noexcept {
    return data_->time;
}

Result Run::result() {
    return end_of(*data_);
}

Result run(const Scene& scene, Options options) {
    const std::unique_ptr<Run::Data> data = started(scene, std::move(options), false);
    return end_of(*data);
}

}  // namespace frana::facade
