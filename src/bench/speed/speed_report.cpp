// SPDX-License-Identifier: Apache-2.0
#include "bench/speed/speed_report.h"

#include <algorithm>
#include <cstdio>

#include "particles/particle_set.h"

namespace frana::bench {

using voellmy_bingham::k_stage_names;
using voellmy_bingham::k_stages;
using voellmy_bingham::Stage;

namespace {

// Rounding errors grow in ten steps, but not to this: only another formula does.
constexpr double k_same_answer = 1e-10;

// Time of a stage in the whole run; sort and resample are averaged over all steps.
double nanoseconds_of(const SpeedRow& row, std::size_t stage) {
    double all = 0;
    for (const double seconds : row.stages) all += seconds;
    return all > 0 ? 1e9 / row.particle_steps_per_second * row.stages[stage] / all : 0;
}

double fraction_of(const SpeedRow& row, std::size_t stage) {
    return nanoseconds_of(row, stage) * row.particle_steps_per_second * 1e-9;
}

}  // namespace

bool SpeedResult::right() const {
    return difference_from_plain < k_same_answer &&
           std::all_of(rows.begin(), rows.end(), [](const SpeedRow& row) { return row.same_bits; });
}

double bytes_moved(Stage stage, bool stress) {
    const std::size_t stresses = stress ? k_stress_fields.size() : 0;
    const std::size_t basic = k_basic_fields.size(), affine = k_affine_fields.size(), shape = k_shape_fields.size();
    std::size_t fields = 0;
    switch (stage) {
        case Stage::particles_to_nodes:
            fields = basic + affine;
            break;
        case Stage::pressure:
            fields = 5 + stresses;  // x, y, volume, area, compression
            break;
        case Stage::nodes_to_particles:  // reads x, y, volume, area, shape; writes all but the volume, compression too
            fields = 4 + shape + (basic - 1) + affine + shape + 1 + stresses;
            break;
        default:
            break;
    }
    return static_cast<double>(fields * sizeof(double));
}

std::string speed_line(const SpeedRow& row) {
    char line[200], fraction[16] = "    -";  // not counted for every case
    if (row.fraction_of_memory_bandwidth > 0)
        std::snprintf(fraction, sizeof fraction, "%5.1f", 100 * row.fraction_of_memory_bandwidth);
    std::snprintf(line, sizeof line,
                  "%-6s %9lld particles %3d threads  %8.3g M particle-steps/s  %4.0f bytes  "
                  "%s %% of memory bandwidth  %lld steps in %.2f s%s",
                  row.case_name.c_str(), static_cast<long long>(row.particles), row.threads,
                  row.particle_steps_per_second / 1e6, row.bytes_per_particle, fraction,
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

std::string speed_stages_csv(const SpeedResult& result) {
    std::string out = "case,particles,threads,stage,nanoseconds_per_particle_step,fraction,bytes_moved\n";
    for (const SpeedRow& row : result.rows) {
        for (std::size_t s = 0; s < k_stages && row.bytes_moved > 0; ++s) {
            char line[160];
            std::snprintf(line, sizeof line, "%s,%lld,%d,%s,%.4g,%.4f,%g\n", row.case_name.c_str(),
                          static_cast<long long>(row.particles), row.threads, k_stage_names[s], nanoseconds_of(row, s),
                          fraction_of(row, s), bytes_moved(static_cast<Stage>(s), row.case_name == "mud"));
            out += line;
        }
    }
    return out;
}

std::string speed_terms_csv(const SpeedResult& result) {
    std::string out = "term,nanoseconds_per_particle_step,bytes_per_particle\n";
    for (const TermRow& row : result.terms) {
        char line[160];
        std::snprintf(line, sizeof line, "\"%s\",%.4g,%g\n", row.term.c_str(), row.nanoseconds, row.bytes_per_particle);
        out += line;
    }
    return out;
}

std::string speed_table(const SpeedResult& result) {
    char line[200];
    std::snprintf(line, sizeof line, "kernels: %s; greatest difference from the plain ones after ten steps: %.1e%s\n",
                  result.kernels.c_str(), result.difference_from_plain,
                  result.difference_from_plain < k_same_answer ? "" : "  NOT THE SAME ANSWER");
    std::string out = line;
    for (const auto& [threads, bandwidth] : result.bandwidth) {
        std::snprintf(line, sizeof line, "memory bandwidth, %d thread%s: %.1f GB/s\n", threads, threads == 1 ? "" : "s",
                      bandwidth / 1e9);
        out += line;
    }
    for (const SpeedRow& row : result.rows) out += speed_line(row) + "\n";

    out += "\nnanoseconds per particle-step, by stage (bytes of particle fields moved in the last column)\n";
    for (const SpeedRow& row : result.rows) {
        if (row.bytes_moved == 0) continue;  // its stages are not timed
        std::snprintf(line, sizeof line, "%-6s %9lld particles %3d threads ", row.case_name.c_str(),
                      static_cast<long long>(row.particles), row.threads);
        out += line;
        for (std::size_t s = 0; s < k_stages; ++s) {
            std::snprintf(line, sizeof line, " %s %.1f (%.0f %%)%s", k_stage_names[s], nanoseconds_of(row, s),
                          100 * fraction_of(row, s), s + 1 < k_stages ? "," : "");
            out += line;
        }
        std::snprintf(line, sizeof line, "; %.0f bytes\n", row.bytes_moved);
        out += line;
    }

    out += "\ncost of each term: the slide with it and all above it, one thread\n";
    double before = 0;
    for (const TermRow& row : result.terms) {
        std::snprintf(line, sizeof line, "%-52s %7.1f ns %+7.1f  %4.0f bytes per particle\n", row.term.c_str(),
                      row.nanoseconds, row.nanoseconds - before, row.bytes_per_particle);
        before = row.nanoseconds;
        out += line;
    }
    for (const std::string& note : result.notes) out += note + "\n";
    return out;
}

}  // namespace frana::bench
