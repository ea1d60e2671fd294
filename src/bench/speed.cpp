// SPDX-License-Identifier: Apache-2.0
#include "bench/speed.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>

#include "bench/memory_bandwidth.h"
#include "bench/setup.h"

namespace frana::bench {
namespace {

// As many steps for each number of threads, so that the ends can be compared.
std::int64_t steps_for(double particles, bool quick) {
    const double particle_steps = quick ? 3e6 : 1e7;  // some seconds on one core
    return std::clamp<std::int64_t>(std::llround(particle_steps / particles), 5, 300);
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
    for (std::int64_t i = 0; i < steps; ++i) flow.advance(1e9);
    Measured measured;
    SpeedRow& row = measured.row;
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

std::string line_of(const SpeedRow& row) {
    char line[200];
    std::snprintf(line, sizeof line,
                  "%-6s %9lld particles %3d threads  %8.3g M particle-steps/s  %4.0f bytes  "
                  "%5.1f %% of memory bandwidth  %lld steps in %.2f s%s",
                  row.case_name.c_str(), static_cast<long long>(row.particles), row.threads,
                  row.particle_steps_per_second / 1e6, row.bytes_per_particle,
                  100 * row.fraction_of_memory_bandwidth, static_cast<long long>(row.steps), row.seconds,
                  row.same_bits ? "" : "  NOT THE SAME BITS AS ONE THREAD");
    return line;
}

std::vector<double> usual_sizes(bool quick, std::vector<std::string>& notes) {
    std::vector<double> sizes{1e4, 1e5, 1e6};
    // Fields, their copy while sorting, seeds and nodes.
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
    constexpr double k_cell_size = 5, k_slope_deg = 20;
    const auto side = static_cast<std::int64_t>(std::lround(std::sqrt(particles / 4)));
    constexpr std::int64_t k_margin = 10;  // cells of free ground round the sheet
    Setup setup;
    const GridSpec grid = plain_grid(side + 2 * k_margin, side + 2 * k_margin, k_cell_size);
    const double gradient = std::tan(k_slope_deg * k_degree);
    setup.bed = sample_raster(grid, [&](Point p) {
        return (grid.east() - p.x) * gradient + 2 * std::sin(0.02 * p.x) * std::sin(0.03 * p.y);
    });
    const double low = k_margin * k_cell_size, high = low + static_cast<double>(side) * k_cell_size;
    setup.seeds = fill_lattice(grid, 2, 0, [&](Point p) {
        return Seed{p.x > low && p.x < high && p.y > low && p.y < high ? 3.0 : 0};
    });
    setup.material = dry_friction(12);
    setup.material.density = 2000;
    setup.material.turbulence = 500;
    if (mud) {
        setup.material.viscosity = 1000;
        setup.material.yield_stress = 500;
    }
    setup.numerics = numerics_of(Scheme::standard, SlopeCorrection::normal, Boundary::open);
    return setup;
}

SpeedResult run_speed(const SpeedOptions& options) {
    SpeedResult result;
    for (const int threads : std::set<int>{1, options.threads})
        result.bandwidth.emplace_back(threads, memory_bandwidth(threads));
    std::vector<double> sizes = options.sizes;
    if (sizes.empty()) sizes = usual_sizes(options.quick, result.notes);
    for (const bool mud : {false, true}) {
        for (const double size : sizes) {
            const Setup setup = speed_sheet(size, mud);
            std::optional<Raster> first;
            for (const auto& [threads, bandwidth] : result.bandwidth) {
                const std::int64_t steps = options.steps > 0 ? options.steps : steps_for(size, options.quick);
                Measured measured = measure(setup, mud ? "mud" : "slide", threads, steps);
                SpeedRow& row = measured.row;
                constexpr double k_times_moved = 3;  // read twice, written once
                row.fraction_of_memory_bandwidth =
                    k_times_moved * row.bytes_per_particle * row.particle_steps_per_second / bandwidth;
                if (!first) first = measured.depth;
                row.same_bits = first->values == measured.depth.values;
                if (options.report) options.report(line_of(row));
                result.rows.push_back(row);
            }
        }
    }
    return result;
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
    std::string out;
    for (const auto& [threads, bandwidth] : result.bandwidth) {
        char line[96];
        std::snprintf(line, sizeof line, "memory bandwidth, %d thread%s: %.1f GB/s\n", threads,
                      threads == 1 ? "" : "s", bandwidth / 1e9);
        out += line;
    }
    for (const SpeedRow& row : result.rows) out += line_of(row) + "\n";
    for (const std::string& note : result.notes) out += note + "\n";
    return out;
}

}  // namespace frana::bench
