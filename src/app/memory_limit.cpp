// SPDX-License-Identifier: Apache-2.0
#include "app/memory_limit.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "app/command_line.h"
#include "app/memory_forecast.h"
#include "app/number_text.h"
#include "app/prepare_inflow.h"
#include "core/error.h"
#include "core/json.h"
#include "params/value_text.h"
#include "simulation/release.h"
#include "simulation/simulation.h"

namespace frana::app {
namespace {

double limit = 0;  // 0: none

// Particles are numbered with 32 bits, and a flow that spreads splits them.
constexpr double k_most_particles = 1e9;
// The fields that every particle has, and those few of which there is a copy while they are put into order.
constexpr double k_least_particle_bytes = 120;
// Terrain, bed, release, maxima and results; see memory_forecast.cpp for what a whole run takes.
constexpr double k_least_cell_bytes = 120;

std::optional<double> bytes_from_text(const std::string& text) {
    static const std::map<std::string, double> k_units{
        {"", 1},      {"B", 1},        {"kB", 1e3},     {"MB", 1e6},     {"GB", 1e9},
        {"TB", 1e12}, {"KiB", 0x1p10}, {"MiB", 0x1p20}, {"GiB", 0x1p30}, {"TiB", 0x1p40}};
    const std::size_t end = text.find_last_of("0123456789.");
    if (end == std::string::npos) return std::nullopt;
    const auto number = number_from_text(trimmed(text.substr(0, end + 1)));
    const auto unit = k_units.find(trimmed(text.substr(end + 1)));
    if (!number || !(*number > 0) || unit == k_units.end()) return std::nullopt;
    return *number * unit->second;
}

// Rows of particles that a hydrograph brings until the scene's end, times their number in a row.
double particles_of(const Inflow& inflow, double spacing, double end) {
    double way = 0;
    for (std::size_t i = 0; i + 1 < inflow.hydrograph.size(); ++i) {
        const HydrographPoint &a = inflow.hydrograph[i], &b = inflow.hydrograph[i + 1];
        const double from = std::min(a.time, end), to = std::min(b.time, end);
        way += std::max(a.speed, b.speed) * (to - from);
    }
    return way / spacing * (length_of(inflow.line) / spacing + 1);
}

// "23.5 GB, which the machine has free"
std::string bound_text(const MemoryBound& bound) {
    return bytes_text(bound.bytes) + ", which " + bound.what;
}

}  // namespace

void take_memory_limit(const boost::program_options::variables_map& values, RunLog& log) {
    const auto text = text_option(values, "memory-limit");
    if (!text) return;
    const auto bytes = bytes_from_text(*text);
    if (!bytes)
        throw Error(ErrorKind::input, Problem{"is not an amount of memory", "--memory-limit", *text, "",
                                              "Write for example 4GB, 500MB or 2GiB"});
    limit = *bytes;
    if (const MemoryBound there = machine_memory(); limit > there.bytes)
        log.tell("--memory-limit " + *text + " is more than " + bound_text(there) + ": that is what counts");
}

MemoryBound usable_memory() {
    const MemoryBound there = machine_memory();
    return limit > 0 && limit <= there.bytes ? MemoryBound{limit, "--memory-limit allows"} : there;
}

void refuse_too_much(const SceneReading& reading, const Scene& scene, double released_area) {
    const double spacing = lattice_spacing(scene),
                 of_inflows = std::accumulate(scene.inflows.begin(), scene.inflows.end(), 0.0,
                                              [&](double sum, const Inflow&inflow) {
                                                  return sum + particles_of(inflow, spacing, scene.time.end);
                                              }),
                 particles = released_area / (spacing * spacing) + of_inflows;
    const double cells = static_cast<double>(scene.grid.columns) * static_cast<double>(scene.grid.rows);
    const double needed = cells * k_least_cell_bytes + particles * k_least_particle_bytes;
    const std::string cell = shortest_text(scene.grid.cell_size) + " m";
    if (const MemoryBound bound = usable_memory(); needed > bound.bytes) {
        throw Error(ErrorKind::input,
                    Problem{"a run with " + grouped(cells) + " cells and " + grouped(particles) +
                                " particles takes at least " + bytes_text(needed) + " of memory",
                            reading.where("terrain.cell-size"), cell, bound_text(bound),
                            "Choose larger cells or fewer numerics.particles-per-cell"});
    }
    if (particles > k_most_particles) {
        throw Error(ErrorKind::input,
                    Problem{"release and inflow would take " + grouped(particles) + " particles",
                            reading.where("terrain.cell-size"), cell, "at most " + grouped(k_most_particles),
                            "Choose larger cells or fewer numerics.particles-per-cell"});
    }
}

void refuse_run_of(std::int64_t needed, const SceneReading& reading, const Prepared& prepared) {
    const MemoryBound bound = usable_memory();
    if (static_cast<double>(needed) <= bound.bytes) return;
    throw Error(
        ErrorKind::input,
        Problem{"a run of this scene takes about " + bytes_text(static_cast<double>(needed)) + " of memory",
                reading.where("terrain.cell-size"), shortest_text(prepared.scene.grid.cell_size) + " m",
                bound_text(bound),
                "Choose a larger terrain.cell-size, a part of the DTM with terrain.bounds, a smaller "
                "output.map-size or no pictures, or give the run more memory"});
}

void refuse_run_beyond_memory(const SceneReading& reading, const Prepared& prepared, std::int64_t held,
                              const RunEstimate& expected, int threads) {
    if (static_cast<double>(most_memory_of_run(prepared, held, expected)) <= usable_memory().bytes) return;
    refuse_run_of(
        memory_of_run(prepared, held, expected, estimate_time(reading, prepared, expected, threads)), reading,
        prepared);
}

void refuse_pictures_of(std::int64_t needed, const std::string& where, const std::string& size) {
    const MemoryBound bound = usable_memory();
    const double all = static_cast<double>(needed + resident_memory());
    if (all <= bound.bytes) return;
    throw Error(ErrorKind::input, Problem{"drawing takes about " + bytes_text(all) + " of memory", where,
                                          size, bound_text(bound), "Choose a smaller size"});
}

}  // namespace frana::app
