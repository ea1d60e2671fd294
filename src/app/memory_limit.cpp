// SPDX-License-Identifier: Apache-2.0
#include "app/memory_limit.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "app/command_line.h"
#include "app/number_text.h"
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

// What a run of the least scene takes with its libraries, and what drawing adds; measured.
constexpr std::int64_t k_libraries_bytes = 100'000'000, k_drawing_bytes = 180'000'000;

std::optional<double> bytes_from_text(const std::string& text) {
    static const std::map<std::string, double> k_units{{"", 1},      {"B", 1},      {"kB", 1e3},       {"MB", 1e6},
                                                       {"GB", 1e9},  {"TB", 1e12},  {"KiB", 0x1p10},   {"MiB", 0x1p20},
                                                       {"GiB", 0x1p30}, {"TiB", 0x1p40}};
    const std::size_t end = text.find_last_of("0123456789.");
    if (end == std::string::npos) return std::nullopt;
    const auto number = number_from_text(trimmed(text.substr(0, end + 1)));
    const auto unit = k_units.find(trimmed(text.substr(end + 1)));
    if (!number || !(*number > 0) || unit == k_units.end()) return std::nullopt;
    return *number * unit->second;
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
    double least = static_cast<double>(::sysconf(_SC_PHYS_PAGES)) * static_cast<double>(::sysconf(_SC_PAGESIZE));
    rlimit shell{};
    if (::getrlimit(RLIMIT_AS, &shell) == 0 && shell.rlim_cur != RLIM_INFINITY)
        least = std::min(least, static_cast<double>(shell.rlim_cur));
    return memory_is_limited() ? std::min(least, limit) : least;
}

void refuse_too_much(const SceneReading& reading, const Scene& scene, double released_area) {
    const double spacing = lattice_spacing(scene), particles = released_area / (spacing * spacing);
    const double cells = static_cast<double>(scene.grid.columns) * static_cast<double>(scene.grid.rows);
    const double needed = cells * k_least_cell_bytes + particles * k_least_particle_bytes;
    const std::string cell = shortest_text(scene.grid.cell_size) + " m";
    if (needed > usable_memory()) {
        throw Error(ErrorKind::input,
                    Problem{"a run with " + grouped(cells) + " cells and " + grouped(particles) +
                                " particles takes at least " + bytes_text(needed) + " of memory",
                            reading.where("terrain.cell-size"), cell, bytes_text(usable_memory()) + ", which there are",
                            "Choose larger cells or fewer numerics.particles-per-cell"});
    }
    if (particles > k_most_particles) {
        throw Error(ErrorKind::input,
                    Problem{"the release would take " + grouped(particles) + " particles",
                            reading.where("terrain.cell-size"), cell, "at most " + grouped(k_most_particles),
                            "Choose larger cells or fewer numerics.particles-per-cell"});
    }
}

void refuse_over_limit(std::int64_t needed) {
    if (!memory_is_limited() || static_cast<double>(needed) <= limit) return;
    throw Error(ErrorKind::input,
                Problem{"a run of this scene takes about " + bytes_text(static_cast<double>(needed)) + " of memory",
                        "--memory-limit", bytes_text(limit), "",
                        "Choose larger cells, a part of the DTM with terrain.bounds, smaller pictures or none, or allow "
                        "more"});
}

std::int64_t memory_of_run(const Prepared& prepared, const RunEstimate& expected,
                           const std::optional<TimeEstimate>& trial) {
    const OutputSpec& output = prepared.spec.output;
    const bool draws = output.maps.front() != "off" || output.animation;
    const std::int64_t more = trial ? trial->particles_peak - expected.particles : 0;
    return k_libraries_bytes + (draws ? k_drawing_bytes : 0) + expected.memory_bytes +
           RunEstimate::k_particle_copies * std::max<std::int64_t>(more, 0) * expected.bytes_per_particle;
}

}  // namespace frana::app
