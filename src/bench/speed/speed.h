// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "bench/set_up/setup.h"

namespace frana::bench {

/// Returns the flow that is measured: a sheet 3 m deep on a plane of 20 degrees, 4 particles per cell, Voellmy
/// friction, slope correction; `mud`: with in-plane viscosity and yield stress.
Setup speed_sheet(double particles, bool mud);

/// Returns a film of 0.2 to 1 m that runs at 25 m/s down rough gullies with cells without elevation and over an edge of
/// 40 m: what real terrain costs and the plane of speed_sheet does not.
Setup speed_gullies(double particles);

/// One row of speed.csv.
struct SpeedRow {
    std::string case_name;
    std::int64_t particles = 0;  ///< at the start
    int threads = 1;
    double particle_steps_per_second = 0;
    double bytes_per_particle = 0;  ///< of the particles' own fields
    /// bytes_moved() per second relative to memory_bandwidth with as many threads; traffic of the nodes, and lines read
    /// before they are written, are not counted. More than 1 if the particles stay in the caches.
    double fraction_of_memory_bandwidth = 0;
    std::int64_t steps = 0;
    double seconds = 0;
    bool same_bits = true;  ///< as of the run with one thread
};

struct SpeedResult {
    std::vector<SpeedRow> rows;
    std::vector<std::pair<int, double>> bandwidth;  ///< threads, bytes per second
    std::vector<std::string> notes;                 ///< sizes omitted, with the reason
    std::string kernels;                            ///< those that the processor runs

    /// Whether all numbers of threads gave the same bits.
    [[nodiscard]] bool right() const;
};

struct SpeedOptions {
    bool quick = false;         ///< up to a million particles, a third of the steps
    std::vector<double> sizes;  ///< numbers of particles; empty: as listed at run_speed
    std::int64_t steps = 0;     ///< of each run; 0: as many as need some seconds on one core
    int threads = 1;            ///< the greatest number; each size runs with one and with all
    std::function<void(const std::string&)> report;
};

/// Measures the throughput of the default scheme on three flows, 4 particles per cell at first:
///   slide    speed_sheet without in-plane stress
///   gullies  speed_gullies
///   mud      speed_sheet with in-plane stress
/// Sizes 1e4, 1e5, 1e6, and 1e7 unless `quick` or memory forbids. Each run's depth is compared, bit for bit, with that
/// of a single thread.
SpeedResult run_speed(const SpeedOptions& options);

std::string speed_csv(const SpeedResult& result);
std::string speed_table(const SpeedResult& result);

/// Returns the bytes of particle fields that a step reads and writes for one particle.
double bytes_moved(bool stress);

/// Returns one run in one line.
std::string speed_line(const SpeedRow& row);

}  // namespace frana::bench
