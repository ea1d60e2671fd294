// SPDX-License-Identifier: Apache-2.0
#include "simulation/stepped_run.h"

#include <cmath>
#include <optional>
#include <utility>

#include "simulation/flow.h"
#include "simulation/flow_run.h"
#include "simulation/structured_flow.h"
#include "simulation/terrain_sample.h"

namespace frana {

class SteppedRun::OfModel {
  public:
    virtual ~OfModel() = default;
    [[nodiscard]] virtual bool continues() const = 0;
    virtual void step() = 0;
    [[nodiscard]] virtual Progress progress() const = 0;
    virtual RunResult finish() = 0;
};

namespace {

// A run's elevations are relative to its start, independent of later failures.
Ground ground_of(const Scene& scene, const Raster& bed, const ParticleSet& first, Point otherwise) {
    const Point origin = first.size() > 0 ? Point{first[Field::x][0], first[Field::y][0]} : otherwise;
    const Cell cell = cell_of(scene.grid, origin);
    const double z = scene.terrain.at(cell.row, cell.column);
    return std::isnan(z) ? Ground(bed) : Ground(bed, z);
}

/// What a run starts from.
struct RunStart {
    Stopwatch engine;
    Release release;
    Arrivals arrivals;
    Ground ground;

    explicit RunStart(const Scene& scene)
        : engine(started()),
          release(make_release(scene)),
          arrivals(scene, std::exchange(release.later, {})),
          ground(ground_of(scene, release.bed_at_start, release.particles, origin_of(release, arrivals))) {}

    static Stopwatch started() {
        Stopwatch watch;
        watch.start();
        return watch;
    }
};

Flow flow_of(const Scene& scene, int threads, RunStart& start, const Flow*) {
    return {start.ground,   std::exchange(start.release.particles, ParticleSet()),
            scene.material, scene.numerics,
            threads,        std::nullopt,
            scene.zones,    scene.entrainment};
}

void add_walls(const Scene& scene, Flow& flow) {
    if (scene.walls) flow.add_walls(*scene.walls);
}

StructuredFlow flow_of(const Scene& scene, int threads, RunStart& start, const StructuredFlow*) {
    return {start.ground,
            scene.walls,
            *scene.structured,
            scene.numerics,
            std::exchange(start.release.particles, ParticleSet()),
            threads};
}

void add_walls(const Scene&, StructuredFlow&) {}  // it has them from the start

template <class AnyFlow>
class RunOfFlow final : public SteppedRun::OfModel {
  public:
    RunOfFlow(const Scene& scene, const RunOptions& options)
        : options_(options),
          start_(scene),
          flow_(flow_of(scene, options.threads, start_, static_cast<const AnyFlow*>(nullptr))) {
        add_walls(scene, flow_);
        run_.emplace(scene, options, start_.release, start_.arrivals, flow_, start_.engine);
        flow_.nodes().require_ground();  // a read error is found before anything is computed
        if (options.saved != nullptr) {
            (*options.saved)(*run_);
        } else {
            run_->begin();
        }
    }
    [[nodiscard]] bool continues() const override { return run_->continues(); }
    [[nodiscard]] Progress progress() const override { return run_->progress(); }
    void step() override {
        run_->step();
        if (options_.after_step) options_.after_step(run_->progress(), [&](StateWriter& writer) { writer(*run_); });
    }
    RunResult finish() override {
        flow_.nodes().require_ground();  // after the last state was saved
        return run_->finish();
    }

  private:
    const RunOptions& options_;
    RunStart start_;
    AnyFlow flow_;
    std::optional<FlowRun<AnyFlow>> run_;
};

}  // namespace

SteppedRun::SteppedRun(const Scene& scene, const RunOptions& options) {
    if (scene.structured)
        run_ = std::make_unique<RunOfFlow<StructuredFlow>>(scene, options);
    else
        run_ = std::make_unique<RunOfFlow<Flow>>(scene, options);
}

SteppedRun::~SteppedRun() = default;

bool SteppedRun::continues() const {
    return run_->continues();
}

void SteppedRun::step() {
    run_->step();
}

Progress SteppedRun::progress() const {
    return run_->progress();
}

RunResult SteppedRun::finish() {
    return run_->finish();
}

}  // namespace frana
