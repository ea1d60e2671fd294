// SPDX-License-Identifier: Apache-2.0
#include "app/memory_limit.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "app/command_line.h"
#include "app/number_text.h"
#include "app/prepare_inflow.h"
#include "core/error.h"
#include "core/json.h"
#include "params/value_text.h"
#include "simulation/release.h"

namespace frana::app {
namespace {

double limit = 0;  // 0: none

// Particles are numbered with 32 bits, and a flow that spreads splits them.
constexpr double k_most_particles = 1e9;
// The fields that every particle has, and the copy in which they are put into order.
constexpr double k_least_particle_bytes = 2 * 100;
// Terrain, bed, release and five results, two more while files are written.
constexpr double k_least_cell_bytes = 80;

// What a run of the least scene takes with its libraries, and what is added by any picture, by maps of everything, that
// for each cell too, and by a film; measured with GDAL 3.6, VTK 9.1, Mesa 22 on maps of 81 000 to 2 000 000 cells.
constexpr std::int64_t k_libraries_bytes = 147'000'000, k_picture_bytes = 138'000'000,
                       k_all_maps_bytes = 52'000'000, k_all_maps_cell_bytes = 28, k_film_bytes = 60'000'000;

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

}  // namespace

void take_memory_limit(const boost::program_options::variables_map& values) {
    const auto text = text_option(values, "memory-limit");
    if (!text) return;
    const auto bytes = bytes_from_text(*text);
    if (!bytes)
        throw Error(ErrorKind::input, Problem{"is not an amount of memory", "--memory-limit", *text, "",
                                              "Write for example 4GB, 500MB or 2GiB"});
    limit = *bytes;
}

bool memory_is_limited() {
    return limit > 0;
}

double usable_memory() {
    double least =
        static_cast<double>(::sysconf(_SC_PHYS_PAGES)) * static_cast<double>(::sysconf(_SC_PAGESIZE));
    rlimit shell{};
    if (::getrlimit(RLIMIT_AS, &shell) == 0 && shell.rlim_cur != RLIM_INFINITY)
        least = std::min(least, static_cast<double>(shell.rlim_cur));
    return memory_is_limited() ? std::min(least, limit) : least;
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
    if (needed > usable_memory()) {
        throw Error(ErrorKind::input,
                    Problem{"a run with " + grouped(cells) + " cells and " + grouped(particles) +
                                " particles takes at least " + bytes_text(needed) + " of memory",
                            reading.where("terrain.cell-size"), cell,
                            bytes_text(usable_memory()) + ", which there are",
                            "Choose larger cells or fewer numerics.particles-per-cell"});
    }
    if (particles > k_most_particles) {
        throw Error(ErrorKind::input,
                    Problem{"release and inflow would take " + grouped(particles) + " particles",
                            reading.where("terrain.cell-size"), cell, "at most " + grouped(k_most_particles),
                            "Choose larger cells or fewer numerics.particles-per-cell"});
    }
}

void refuse_over_limit(std::int64_t needed) {
    if (!memory_is_limited() || static_cast<double>(needed) <= limit) return;
    throw Error(
        ErrorKind::input,
        Problem{
            "a run of this scene takes about " + bytes_text(static_cast<double>(needed)) + " of memory",
            "--memory-limit", bytes_text(limit), "",
            "Choose larger cells, a part of the DTM with terrain.bounds, smaller pictures or none, or allow "
            "more"});
}

std::int64_t memory_of_run(const Prepared& prepared, const RunEstimate& expected,
                           const std::optional<TimeEstimate>& trial) {
    const OutputSpec& output = prepared.spec.output;
    const bool maps = output.maps.front() != "off",
               film = output.animation && prepared.scene.time.frame_interval > 0;
    std::int64_t bytes = k_libraries_bytes + expected.memory_bytes;
    if (maps || film || prepared.scar) bytes += k_picture_bytes;
    if (output.maps.front() == "on")
        bytes += k_all_maps_bytes + k_all_maps_cell_bytes * prepared.scene.grid.cell_count();
    if (film) bytes += k_film_bytes;
    if (trial && trial->particles_peak > expected.particles)
        bytes += expected.bytes_of_particles(trial->particles_peak - expected.particles);
    return bytes;
}

}  // namespace frana::app
