// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/raster.h"

namespace frana {

/// One row of timeseries.csv.
struct SeriesRow {
    double time = 0;  ///< [s]
    std::int64_t step = 0;
    double dt = 0;              ///< [s]
    double volume = 0;          ///< inside the domain [m3]
    double volume_left = 0;     ///< that has left through open boundaries [m3]
    double max_depth = 0;       ///< [m]
    double max_speed = 0;       ///< along the bed [m/s]
    double front_distance = 0;  ///< farthest particle from the release's centroid, in map view [m]
    double kinetic_energy = 0;  ///< [J]
    double covered_area = 0;    ///< cells deeper than the minimum depth [m2]
};

/// The flow at one instant, as rasters on the working grid (NaN where there is none).
struct Frame {
    int index = 0;
    double time = 0;  ///< [s]
    Raster depth;     ///< vertical [m]
    Raster velocity;  ///< speed along the bed [m/s]
};

struct Progress {
    std::int64_t step = 0;
    double time = 0;  ///< simulated [s]
    double end = 0;   ///< [s]
    std::int64_t particles = 0;
};

struct RunOptions {
    int threads = 1;
    std::function<void(Frame)> on_frame;  ///< called at time 0, at every frame interval and at the end
    std::function<void(const Progress&)> on_progress;  ///< called every step; must be cheap
    std::function<bool()> stop_requested;              ///< polled every step
};

/// Events that must not happen in a good run; all zero then.
struct HardEvents {
    std::int64_t non_finite = 0;       ///< particles with a non-finite state
    std::int64_t depth_clamped = 0;    ///< particles whose area had to be bounded
    std::int64_t speed_clamped = 0;    ///< nodes whose speed had to be bounded
    std::int64_t entered_no_data = 0;  ///< particles found over a cell without terrain

    [[nodiscard]] bool none() const noexcept {
        return non_finite == 0 && depth_clamped == 0 && speed_clamped == 0 && entered_no_data == 0;
    }
};

enum class StopReason { end_time, still, all_left, requested, reached_no_data, non_finite };

/// What a run gives back: rasters on the working grid (NaN where nothing ever flowed), series, counts.
struct RunResult {
    Raster bed;           ///< what was slid over [m]
    Raster release;       ///< vertical thickness released, averaged over each cell [m]
    Raster max_depth;     ///< [m], taken at every step
    Raster max_velocity;  ///< along the bed [m/s], taken at every step
    Raster max_pressure;  ///< density times speed squared [kPa], taken at every step
    Raster arrival_time;  ///< first time deeper than the minimum depth [s]
    Raster final_depth;   ///< [m]
    std::vector<SeriesRow> series;

    std::int64_t steps = 0;
    double simulated_seconds = 0;
    StopReason stop_reason = StopReason::end_time;
    std::int64_t particles_initial = 0, particles_final = 0, particles_peak = 0;
    std::int64_t particle_steps = 0;
    std::int64_t bytes_per_particle = 0, bytes_per_node = 0;  ///< of the engine's fields
    double engine_seconds = 0;  ///< wall time inside the engine, without on_frame
    double volume_initial = 0, volume_final = 0, volume_left = 0;  ///< [m3]
    HardEvents hard_events;
    std::vector<std::string> terms;  ///< physics and numerics really computed
    std::vector<std::string> notes;  ///< for log.txt: choices made, warnings
};

/// What a run of a scene would take, without running it.
struct RunEstimate {
    std::int64_t particles = 0;
    double volume = 0;              ///< released [m3]
    std::int64_t memory_bytes = 0;  ///< engine and rasters
    std::int64_t bytes_per_particle = 0, bytes_per_node = 0;
    double first_step_seconds = 0;  ///< stable step at the start [s]
    double wall_seconds = 0;        ///< rough
    std::vector<std::string> terms;
};

}  // namespace frana
