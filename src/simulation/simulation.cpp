// SPDX-License-Identifier: Apache-2.0
#include "simulation/simulation.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "core/reached_raster.h"
#include "core/words/words.h"
#include "params/keys/result_rasters.h"
#include "simulation/finite_volume_flow.h"
#include "simulation/flow.h"
#include "simulation/scene.h"
#include "simulation/stepped_run.h"
#include "simulation/structured_flow.h"
#include "simulation/terms.h"

namespace frana {
namespace {

// Measures the time of a model's first steps and its size, with all later material added at once: the trial steps then
// cost as much as the most expensive ones.
void estimate_model(const Scene& scene, const Arrivals::Arrived& rest, std::int64_t released_cells, Model& model,
                    RunEstimate& e) {
    model.add(rest);
    model.nodes().require_ground();  // a read error is found before anything is computed
    e.first_step_seconds = model.stable_step();
    e.bytes_per_particle = static_cast<std::int64_t>(model.bytes_per_particle());
    e.bytes_per_node = static_cast<std::int64_t>(model.bytes_per_node());
    constexpr std::int64_t k_spread = 4;  // nodes only where there is material
    const std::int64_t cells = scene.grid.cell_count();
    const std::int64_t reached = released_cells > 0 ? std::min(cells, k_spread * released_cells) : cells;
    // Partly reached tiles count whole, and so does the border read round them; a scene may have several flows.
    constexpr std::int64_t k_tiles_round = 64;
    e.stored_cells = model.nodes().is_on_demand() || cells > k_largest_plain
                         ? std::min(cells, 2 * reached + k_tiles_round * CellValues::k_side * CellValues::k_side)
                         : cells;
    e.memory_bytes = e.stored_cells * model.rasters_at_once() * static_cast<std::int64_t>(sizeof(double)) +
                     reached * e.bytes_per_node + e.bytes_of_particles(e.particles);
    // Time of the first steps, for as many steps as the end time needs at the first step's length.
    constexpr int k_trial_steps = 3;
    const auto begin = std::chrono::steady_clock::now();
    for (int i = 0; i < k_trial_steps; ++i) model.step(scene.time.end);
    const double per_step =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() / k_trial_steps;
    e.wall_seconds = per_step * scene.time.end / e.first_step_seconds;
}

}  // namespace

std::unique_ptr<Model> make_model(const Scene& scene, const Ground& ground, const ParticleSet& released, int threads) {
    if (scene.structured)
        return std::make_unique<StructuredFlow>(ground, scene.walls, *scene.structured, scene.numerics, released,
                                                threads);
    if (scene.numerics.scheme == Scheme::finite_volume)
        return std::make_unique<FiniteVolumeFlow>(ground, scene.walls, released, scene.material, scene.numerics,
                                                  threads, scene.zones, scene.entrainment);
    auto flow = std::make_unique<Flow>(ground, released, scene.material, scene.numerics, threads, std::nullopt,
                                       scene.zones, scene.entrainment);
    if (scene.walls) flow->add_walls(*scene.walls);
    return flow;
}

Raster Model::max_pressure(const Raster& max_velocity) const {
    Raster pressure = max_velocity;
    pressure.values.change_each_stored(
        [density = density()](std::size_t, double& value) { value = density * value * value / 1000; });
    return pressure;
}

void Model::add_exchange(const ZeroArray<ErodibleBed>& beds, const ExchangeReport& exchanged, RunResult& result) const {
    const auto depths = [&](double ErodibleBed::*depth) {
        return raster_of([&](std::size_t node) {
            const double value = beds[node].*depth;
            return value > 0 ? value : k_no_data;
        });
    };
    result.exchanges = true;
    result.add(RasterName::eroded_depth, depths(&ErodibleBed::eroded));
    result.add(RasterName::deposited_depth, depths(&ErodibleBed::deposited));
    result.volume_eroded = exchanged.eroded;
    result.volume_deposited = exchanged.deposited;
    depths(&ErodibleBed::kept).values.for_each_stored([&](std::size_t, double depth) {
        if (depth > 0) result.volume_detrained += depth * grid().cell_area();
    });
    result.momentum_deposited = density() * std::hypot(exchanged.momentum_x, exchanged.momentum_y);
}

double relative_volume_error(const RunResult& result) {
    const double entered = result.volume_entered + result.volume_eroded;
    if (entered == 0) return 0;
    const double gone = result.volume_deposited + result.volume_infiltrated;
    return std::abs(result.volume_final + result.volume_left + gone - entered) / entered;
}

const char* describe(StopReason reason) {
    switch (reason) {
        case StopReason::end_time:
            return worded("end time reached");
        case StopReason::still:
            return worded("all material at rest");
        case StopReason::settled:
            return worded("run-out, area and deposit have stopped changing");
        case StopReason::momentum:
            return worded("momentum below the given fraction of its peak");
        case StopReason::all_left:
            return worded("all material has left the domain");
        case StopReason::requested:
            return worded("stopped by a signal");
        case StopReason::reached_no_data:
            return worded("the flow reached cells without terrain");
        case StopReason::non_finite:
            return worded("non-finite values appeared");
        case StopReason::impossible_speed:
            return worded("the speed exceeded what the fall allows");
        case StopReason::volume_drift:
            return worded("the volume was no longer conserved");
    }
    return "";
}

RunResult run(const Scene& scene, const RunOptions& options) {
    SteppedRun run(scene, options);
    while (run.continues()) run.step();
    return run.finish();
}

RunEstimate estimate(const Scene& scene, int threads) {
    Release release = make_release(scene);
    Arrivals arrivals(scene, std::exchange(release.later, {}));
    RunEstimate e;
    e.volume = release.volume;
    e.terms = list_terms(scene);
    const std::size_t arriving = arrivals.particles_left();
    const Arrivals::Arrived rest = arrivals.collect(scene.time.end);
    e.inflow = rest.inflow;
    std::int64_t released_cells = 0;
    release.depth.values.for_each_stored([&](std::size_t, double depth) { released_cells += depth > 0; });
    if (scene.structured && scene.structured->rain.falls()) released_cells = 0;  // it reaches all
    const std::unique_ptr<Model> model = make_model(scene, release.bed, release.particles, threads);
    const std::size_t entering = !scene.structured ? arriving : scene.structured->solids ? rest.failed.size() : 0;
    e.particles = model->particle_count() + static_cast<std::int64_t>(entering);
    estimate_model(scene, rest, released_cells, *model, e);
    return e;
}

}  // namespace frana
