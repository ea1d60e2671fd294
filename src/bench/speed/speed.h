// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "bench/set_up/setup.h"
#include "models/voellmy_bingham/stage_times.h"

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
    double bytes_moved = 0;         ///< of particle fields, a particle-step: what the stages read and write
    /// bytes_moved a second over what memory_bandwidth measured with as many threads; what the nodes take and lines
    /// read before they are written are not counted. More than 1 where the particles stay in the caches.
    double fraction_of_memory_bandwidth = 0;
    std::int64_t steps = 0;
    double seconds = 0;
    voellmy_bingham::StageSeconds stages{};
    bool same_bits = true;  ///< as the run with one thread gave
};

/// What a term of the model costs: the slide with it and everything above it in the list.
struct TermRow {
    std::string term;
    double nanoseconds = 0;  ///< a particle-step, one thread
    double bytes_per_particle = 0;
};

struct SpeedResult {
    std::vector<SpeedRow> rows;
    std::vector<TermRow> terms;
    std::vector<std::pair<int, double>> bandwidth;  ///< threads, bytes a second
    std::vector<std::string> notes;                 ///< sizes left out, and why
    std::string kernels;                            ///< which the processor runs
    /// Greatest difference of depth between the fast kernels and the plain ones after ten steps of `slide` and `mud`,
    /// over the greatest depth; zero where the processor runs the plain ones.
    double difference_from_plain = 0;

    /// Whether the fast kernels gave the plain ones' answer and all numbers of threads the same bits.
    [[nodiscard]] bool right() const;
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
/// and of the structured model's solids, with fluid and every term (solid_speed.h), at 1e5 particles at most.
/// Sizes 1e4, 1e5, 1e6, and 1e7 unless `quick` or memory forbids. Each run's depth is compared, bit for bit,
/// with the one that a single thread gave.
SpeedResult run_speed(const SpeedOptions& options);

std::string speed_csv(const SpeedResult& result);
/// case, particles, threads, stage, nanoseconds a particle-step, fraction of the time, bytes a particle-step.
std::string speed_stages_csv(const SpeedResult& result);
/// term, nanoseconds a particle-step, bytes a particle.
std::string speed_terms_csv(const SpeedResult& result);
std::string speed_table(const SpeedResult& result);

/// Bytes of particle fields that a stage reads and writes for one particle; 0 for stages over nodes and for those that
/// do not run at every step.
double bytes_moved(voellmy_bingham::Stage stage, bool stress);

}  // namespace frana::bench
