// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "bench/setup.h"

namespace frana::bench {

/// The flow that is measured: a sheet 3 m deep on a plane of 20 degrees, 4 particles a cell, Voellmy
/// friction, slope correction; `mud`: with in-plane viscosity and yield stress.
Setup speed_sheet(double particles, bool mud);

/// One row of speed.csv.
struct SpeedRow {
    std::string case_name;
    std::int64_t particles = 0;  ///< at the start
    int threads = 1;
    double particle_steps_per_second = 0;
    double bytes_per_particle = 0;  ///< of the particles' own fields
    /// At least each field is read twice and written once a step; what the nodes take is not counted. Over
    /// what memory_bandwidth measured with as many threads; more than 1 where the particles stay in the
    /// caches.
    double fraction_of_memory_bandwidth = 0;
    std::int64_t steps = 0;
    double seconds = 0;
    bool same_bits = true;  ///< as the run with one thread gave
};

struct SpeedResult {
    std::vector<SpeedRow> rows;
    std::vector<std::pair<int, double>> bandwidth;  ///< threads, bytes a second
    std::vector<std::string> notes;                 ///< sizes left out, and why
};

struct SpeedOptions {
    bool quick = false;         ///< up to a million particles, a third of the steps
    std::vector<double> sizes;  ///< numbers of particles; empty: as said at run_speed
    std::int64_t steps = 0;     ///< of each run; 0: as many as take some seconds on one core
    int threads = 1;            ///< the most; each size runs with one and with all
    std::function<void(const std::string&)> report;
};

/// Throughput of the default scheme on two flows, 4 particles a cell:
///   slide  speed_sheet without in-plane stress
///   mud    with it
/// Sizes 1e4, 1e5, 1e6, and 1e7 unless `quick` or memory forbids. Each run's depth is compared, bit for bit,
/// with the one that a single thread gave.
SpeedResult run_speed(const SpeedOptions& options);

std::string speed_csv(const SpeedResult& result);
std::string speed_table(const SpeedResult& result);

}  // namespace frana::bench
