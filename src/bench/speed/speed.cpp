// SPDX-License-Identifier: Apache-2.0
#include "bench/speed/speed.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>
#include <optional>
#include <set>
#include <vector>

#include "bench/set_up/setup.h"
#include "core/thread_pool.h"
#include "mpm/vector/kernels.h"
#include "particles/particle_set.h"

namespace frana::bench {
namespace {

/// Returns the bytes per second that `threads` threads move between memory and processor: the best of several passes of
/// a[i] = b[i] + s c[i] over arrays far larger than the caches, 24 bytes per element (the "triad" of McCalpin's STREAM,
/// 1995, which does not count that a line is read before it is written).
double memory_bandwidth(int threads) {
    constexpr std::size_t k_elements = 16'000'000;  // three arrays of 128 MB
    constexpr std::size_t k_block = 250'000;
    constexpr int k_passes = 6;
    std::vector<double> a(k_elements, 0), b(k_elements, 1), c(k_elements, 2);
    ThreadPool pool(threads);
    double best = 0;
    for (int pass = 0; pass < k_passes; ++pass) {
        const double s = 1 + pass;
        const auto begin = std::chrono::steady_clock::now();
        pool.for_blocks(k_elements, k_block, [&](std::size_t from, std::size_t to) {
            double* const out = a.data();
            const double *const in = b.data(), *const factor = c.data();
            for (std::size_t i = from; i < to; ++i) out[i] = in[i] + s * factor[i];
        });
        const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        // The sum is used, so that no pass can be optimised away.
        if (a[k_elements / 2] == 1 + 2 * s) best = std::max(best, 3 * sizeof(double) * k_elements / seconds);
    }
    return best;
}

// The same number of steps for each number of threads, so that the final states can be compared.
std::int64_t steps_for(double particles, bool quick) {
    const double particle_steps = quick ? 1e7 : 3e7;  // some seconds on one core
    return std::clamp<std::int64_t>(std::llround(particle_steps / particles), 10, 100);
}

struct Measured {
    SpeedRow row;
    Raster depth;
};

Measured measure(const Setup& setup, const std::string& name, int threads, std::int64_t steps) {
    Flow flow(setup.bed, setup.seeds, setup.material, setup.numerics, threads);
    constexpr int k_warm_up = 2;
    for (int i = 0; i < k_warm_up; ++i) flow.advance(1e9);
    const std::int64_t before = flow.particle_steps();
    const auto begin = std::chrono::steady_clock::now();
    Measured measured;
    SpeedRow& row = measured.row;
    for (std::int64_t i = 0; i < steps; ++i) flow.advance(1e9);
    row.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    row.case_name = name;
    row.particles = static_cast<std::int64_t>(setup.seeds.size());
    row.threads = threads;
    row.steps = steps;
    row.particle_steps_per_second = static_cast<double>(flow.particle_steps() - before) / row.seconds;
    row.bytes_per_particle = static_cast<double>(flow.particles().bytes_per_particle());
    measured.depth = flow.nodal_fields().depth;
    return measured;
}

double free_memory() {
    return static_cast<double>(sysconf(_SC_AVPHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
}

std::vector<double> usual_sizes(bool quick, std::vector<std::string>& notes) {
    std::vector<double> sizes{1e4, 1e5, 1e6};
    // Memory for fields, their copy during sorting, seeds and nodes.
    constexpr double k_large = 1e7, k_bytes_at_most = 600;
    if (quick) {
        notes.emplace_back("1e7 particles left out (--quick)");
    } else if (free_memory() < k_large * k_bytes_at_most) {
        notes.emplace_back("1e7 particles left out: less than 6 GB of memory are free");
    } else {
        sizes.push_back(k_large);
    }
    return sizes;
}

}  // namespace

Setup speed_sheet(double particles, bool mud) {
    constexpr double k_cell_size = 5, k_slope_deg = 20, k_speed = 12;
    const auto side = static_cast<std::int64_t>(std::lround(std::sqrt(particles / 4)));
    // Cells of free ground around the sheet, and before it: room for some 100 steps at less than half a cell each.
    constexpr std::int64_t k_margin = 10, k_path = 50;
    Setup setup;
    const GridSpec grid = plain_grid(side + 2 * k_margin + k_path, side + 2 * k_margin, k_cell_size);
    const double gradient = std::tan(k_slope_deg * k_degree);
    setup.bed = sample_raster(grid, [&](Point p) {
        return (grid.east() - p.x) * gradient + 2 * std::sin(0.02 * p.x) * std::sin(0.03 * p.y);
    });
    const double low = k_margin * k_cell_size, high = low + static_cast<double>(side) * k_cell_size;
    setup.seeds = fill_lattice(grid, 2, 0, [&](Point p) {
        return Seed{p.x > low && p.x < high && p.y > low && p.y < high ? 3.0 : 0, k_speed, 0};
    });
    setup.material = voellmy(12, 500);
    setup.material.density = 2000;
    if (mud) set_bingham(setup.material, 1000, 500);
    setup.numerics = numerics_of(Scheme::standard, SlopeCorrection::normal, Boundary::open);
    return setup;
}

Setup speed_gullies(double particles) {
    constexpr double k_cell_size = 5, k_fall = 0.6, k_film = 0.4, k_speed = 25;
    const auto side = static_cast<std::int64_t>(std::lround(std::sqrt(particles / 4)));
    constexpr std::int64_t k_margin = 10, k_path = 100;
    Setup setup;
    const GridSpec grid = plain_grid(side + 2 * k_margin + k_path, side + 2 * k_margin, k_cell_size);
    const double edge = 0.6 * grid.east();
    const auto is_hole = [](Point p) { return std::hypot(std::fmod(p.x, 400) - 200, std::fmod(p.y, 400) - 200) < 12; };
    setup.bed = sample_raster(grid, [&](Point p) {
        if (is_hole(p)) return std::nan("");
        const double gullies = 8 * std::sin(p.y / 12) + 3 * std::sin(p.x / 25) * std::sin(p.y / 7);
        const double roughness = 0.5 * std::sin(1.7 * p.x) * std::sin(2.3 * p.y);
        return k_fall * (grid.east() - p.x) + gullies + roughness + (p.x < edge + 0.2 * p.y ? 40 : 0);
    });
    const double low = k_margin * k_cell_size, high = low + static_cast<double>(side) * k_cell_size;
    setup.seeds = fill_lattice(grid, 2, 0, [&](Point p) {
        const bool inside = p.x > low && p.x < high && p.y > low && p.y < high && !is_hole(p);
        return Seed{inside ? k_film * (1.5 + std::sin(p.y / 12)) : 0, k_speed, 0};
    });
    setup.material = voellmy(12, 2000);
    setup.material.density = 300;
    setup.numerics = numerics_of(Scheme::standard, SlopeCorrection::normal, Boundary::open);
    return setup;
}

SpeedResult run_speed(const SpeedOptions& options) {
    SpeedResult result;
    result.kernels = vector_kernels() != nullptr ? vector_kernels()->instructions : "plain";
    for (const int threads : std::set<int>{1, options.threads})
        result.bandwidth.emplace_back(threads, memory_bandwidth(threads));
    std::vector<double> sizes = options.sizes;
    if (sizes.empty()) sizes = usual_sizes(options.quick, result.notes);
    for (const std::string name : {"slide", "gullies", "mud"}) {
        const bool mud = name == "mud";
        for (const double size : sizes) {
            const Setup setup = name == "gullies" ? speed_gullies(size) : speed_sheet(size, mud);
            std::optional<Raster> first;
            for (const auto& [threads, bandwidth] : result.bandwidth) {
                const std::int64_t steps = options.steps > 0 ? options.steps : steps_for(size, options.quick);
                Measured measured = measure(setup, name, threads, steps);
                SpeedRow& row = measured.row;
                row.fraction_of_memory_bandwidth = bytes_moved(mud) * row.particle_steps_per_second / bandwidth;
                if (!first) first = measured.depth;
                row.same_bits = first->values == measured.depth.values;
                if (options.report) options.report(speed_line(row));
                result.rows.push_back(row);
            }
        }
    }
    return result;
}

bool SpeedResult::right() const {
    return std::all_of(rows.begin(), rows.end(), [](const SpeedRow& row) { return row.same_bits; });
}

double bytes_moved(bool stress) {
    const std::size_t stresses = stress ? k_stress_fields.size() : 0;
    const std::size_t basic = k_basic_fields.size(), affine = k_affine_fields.size(), shape = k_shape_fields.size();
    const std::size_t to_nodes = basic + affine, pressure = 5 + stresses;  // x, y, volume, area, compression
    // Reads x, y, volume, area, shape; writes all but the volume, compression too.
    const std::size_t to_particles = 4 + shape + (basic - 1) + affine + shape + 1 + stresses;
    return static_cast<double>((to_nodes + pressure + to_particles) * sizeof(double));
}

std::string speed_line(const SpeedRow& row) {
    char line[200];
    std::snprintf(line, sizeof line,
                  "%-6s %9lld particles %3d threads  %8.3g M particle-steps/s  %4.0f bytes  "
                  "%5.1f %% of memory bandwidth  %lld steps in %.2f s%s",
                  row.case_name.c_str(), static_cast<long long>(row.particles), row.threads,
                  row.particle_steps_per_second / 1e6, row.bytes_per_particle, 100 * row.fraction_of_memory_bandwidth,
                  static_cast<long long>(row.steps), row.seconds,
                  row.same_bits ? "" : "  NOT THE SAME BITS AS ONE THREAD");
    return line;
}

std::string speed_csv(const SpeedResult& result) {
    std::string out =
        "case,particles,threads,particle_steps_per_second,bytes_per_particle,"
        "fraction_of_memory_bandwidth\n";
    for (const SpeedRow& row : result.rows) {
        char line[160];
        std::snprintf(line, sizeof line, "%s,%lld,%d,%.6g,%g,%.4g\n", row.case_name.c_str(),
                      static_cast<long long>(row.particles), row.threads, row.particle_steps_per_second,
                      row.bytes_per_particle, row.fraction_of_memory_bandwidth);
        out += line;
    }
    return out;
}

std::string speed_table(const SpeedResult& result) {
    char line[200];
    std::string out = "kernels: " + result.kernels + "\n";
    for (const auto& [threads, bandwidth] : result.bandwidth) {
        std::snprintf(line, sizeof line, "memory bandwidth, %d thread%s: %.1f GB/s\n", threads, threads == 1 ? "" : "s",
                      bandwidth / 1e9);
        out += line;
    }
    for (const SpeedRow& row : result.rows) out += speed_line(row) + "\n";
    for (const std::string& note : result.notes) out += note + "\n";
    return out;
}

}  // namespace frana::bench
