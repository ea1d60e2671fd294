// SPDX-License-Identifier: Apache-2.0
#include "app/input/memory_bound.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>

#include "app/text/number_text.h"
#include "core/error.h"
#include "core/text.h"
#include "params/grammar/value_text.h"
#include "simulation/arrivals.h"
#include "simulation/release.h"

namespace frana::app {
namespace {

// Particles have 32-bit numbers, and a spreading flow splits them.
constexpr double k_most_particles = 1e9;
// The fields of every particle, and the few that are copied during sorting.
constexpr double k_least_particle_bytes = 120;

std::optional<double> bytes_from_text(const std::string& text) {
    static const std::map<std::string, double> k_units{
        {"", 1},    {"B", 1},   {"kB", 1e3}, {"MB", 1e6},     {"GB", 1e9},     {"TB", 1e12},    {"k", 1e3},
        {"M", 1e6}, {"G", 1e9}, {"T", 1e12}, {"KiB", 0x1p10}, {"MiB", 0x1p20}, {"GiB", 0x1p30}, {"TiB", 0x1p40}};
    const std::size_t end = text.find_last_of("0123456789.");
    if (end == std::string::npos) return std::nullopt;
    const auto number = number_from_text(trimmed(text.substr(0, end + 1)));
    const auto unit = k_units.find(trimmed(text.substr(end + 1)));
    if (!number || !(*number > 0) || unit == k_units.end()) return std::nullopt;
    return *number * unit->second;
}

}  // namespace

std::string bound_text(const MemoryBound& bound) {
    return bytes_text(bound.bytes) + ", which " + bound.what;
}

double memory_limit_from_text(const std::string& text, RunLog& log) {
    const auto bytes = bytes_from_text(text);
    if (!bytes)
        throw Error(ErrorKind::input, Problem{"is not an amount of memory", "--memory-limit", text, "",
                                              "Write for example 4GB, 500MB or 2GiB"});
    if (const MemoryBound there = machine_memory(); *bytes > there.bytes)
        log.info("--memory-limit " + text + " is more than " + bound_text(there) + ": the lower limit applies");
    return *bytes;
}

MemoryBound usable_memory(const Session& session) {
    const MemoryBound there = machine_memory();
    const double limit = session.memory_limit;
    return limit > 0 && limit <= there.bytes ? MemoryBound{limit, "--memory-limit allows"} : there;
}

void refuse_too_much(const SceneReading& reading, const Scene& scene, double released_area) {
    const double spacing = lattice_spacing(scene),
                 of_inflows = std::accumulate(scene.inflows.begin(), scene.inflows.end(), 0.0,
                                              [&](double sum, const Inflow&inflow) {
                                                  return sum + particles_of(inflow, spacing, scene.time.end);
                                              }),
                 particles = released_area / (spacing * spacing) + of_inflows;
    const double all = static_cast<double>(scene.grid.columns) * static_cast<double>(scene.grid.rows),
                 cells = scene.terrain.values.is_tiled() ? std::min(all, released_area / scene.grid.cell_area()) : all;
    const double needed = cells * k_least_cell_bytes + particles * k_least_particle_bytes;
    const std::string cell = shortest_text(scene.grid.cell_size) + " m";
    if (const MemoryBound bound = usable_memory(reading.session); needed > bound.bytes) {
        throw Error(ErrorKind::input, Problem{"a run with " + grouped(cells) + " cells and " + grouped(particles) +
                                                  " particles needs at least " + bytes_text(needed) + " of memory",
                                              reading.where("terrain.cell-size"), cell, bound_text(bound),
                                              "Choose larger cells or fewer numerics.particles-per-cell"});
    }
    if (particles > k_most_particles) {
        throw Error(ErrorKind::input,
                    Problem{"release and inflow would need " + grouped(particles) + " particles",
                            reading.where("terrain.cell-size"), cell, "at most " + grouped(k_most_particles),
                            "Choose larger cells or fewer numerics.particles-per-cell"});
    }
}

}  // namespace frana::app
