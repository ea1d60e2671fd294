// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "analysis/energy_line.h"
#include "core/archive.h"
#include "core/geometry.h"
#include "core/point_table.h"
#include "core/raster.h"
#include "core/words/warning.h"

namespace frana {

/// One row of timeseries.csv.
struct SeriesRow {
    double time = 0;  ///< [s]
    std::int64_t step = 0;
    double dt = 0;                ///< [s]
    double volume = 0;            ///< inside the domain [m3]
    double volume_left = 0;       ///< left through open boundaries so far [m3]
    double volume_entered = 0;    ///< released and flowed in so far [m3]
    double volume_inflow = 0;     ///< of which flowed in through lines [m3]
    double volume_eroded = 0;     ///< eroded from the bed so far [m3]
    double volume_deposited = 0;  ///< deposited on the bed so far [m3]
    double max_depth = 0;         ///< [m]
    double max_speed = 0;         ///< along the bed [m/s]
    double front_distance = 0;    ///< farthest particle from the nearest of the FrontOrigins, in map view [m]
    double kinetic_energy = 0;    ///< [J]
    double covered_area = 0;      ///< cells deeper than the minimum depth [m2]
};

template <class Archive>
void serialise(Archive& archive, SeriesRow& row) {
    auto& [time, step, dt, volume, left, entered, inflow, eroded, deposited, depth, speed, front, energy, area] = row;
    archive(time, step, dt, volume, left, entered, inflow, eroded, deposited, depth, speed, front, energy, area);
}

/// A raster by its name in result_rasters() (params/keys/result_rasters.h), which is that of its file.
struct NamedRaster {
    std::string name;  ///< "max_depth"
    Raster values;
};

/// The flow at one instant, as rasters on the working grid (NaN where there is none).
struct Frame {
    int index = 0;
    double time = 0;                ///< [s]
    Raster depth;                   ///< vertical [m]
    Raster velocity;                ///< speed along the bed [m/s]
    std::vector<NamedRaster> more;  ///< further rasters of the model
    PointTable particles;           ///< only with RunOptions::particles_in_frames
};

struct Progress {
    std::int64_t step = 0;
    double time = 0;  ///< simulated [s]
    double end = 0;   ///< [s]
    std::int64_t particles = 0;
    bool last = false;  ///< for after_step: no step follows
};

/// An event that must not occur in a good run; it ends the run at the step at which it occurs.
struct RunProblem {
    enum class Kind { non_finite, impossible_speed, volume_drift, no_data } kind;
    std::int64_t step = 0;
    double time = 0;               ///< [s]
    std::optional<Point> place{};  ///< map coordinates; none: of the flow as a whole
    std::int64_t count = 0;        ///< particles or cells; 0: does not apply
    double value = 0, limit = 0;   ///< speed [m/s], or error of the volume as a fraction of all that entered
};

/// Writes the present state of a run.
using SaveState = std::function<void(StateWriter&)>;

struct RunOptions {
    int threads = 1;
    std::function<void(Frame)> on_frame;  ///< called at time 0, at every frame and at the end
    bool particles_in_frames = false;
    std::function<void(const Progress&)> on_progress;   ///< called every step; must be fast
    std::function<bool()> stop_requested;               ///< polled every step
    std::function<void(const RunProblem&)> on_problem;  ///< called at the step at which it occurs, which is the last
    /// Called after every step, including the last; must be fast unless it saves. It does not affect the run.
    std::function<void(const Progress&, const SaveState&)> after_step;
    /// Called between two steps, at most once, before time.end first shortens a step: up to here a run with any later
    /// end is the same, and may resume from this state.
    std::function<void(const SaveState&)> before_end;
    StateReader* saved = nullptr;  ///< a state of the same scene to resume from; none: from the start
};

/// Counts of events that must not occur in a good run; all zero then.
struct HardEvents {
    std::int64_t non_finite = 0;        ///< particles with a non-finite state
    std::int64_t depth_clamped = 0;     ///< particles whose area had to be bounded
    std::int64_t entered_no_data = 0;   ///< particles found over a cell without terrain
    std::int64_t impossible_speed = 0;  ///< steps with a speed above the bound given by the fall
    std::int64_t volume_drift = 0;      ///< steps after which the volume did not add up

    [[nodiscard]] bool none() const noexcept {
        return non_finite == 0 && depth_clamped == 0 && entered_no_data == 0 && impossible_speed == 0 &&
               volume_drift == 0;
    }
};

template <class Archive>
void serialise(Archive& archive, HardEvents& events) {
    auto& [non_finite, depth_clamped, entered_no_data, impossible_speed, volume_drift] = events;
    archive(non_finite, depth_clamped, entered_no_data, impossible_speed, volume_drift);
}

/// Changes of the main results over a last window of time.
struct Settling {
    double window = 0;  ///< [s]
    double runout = 0;  ///< increase of the distance to the farthest cell of the trace [m]
    double area = 0;    ///< relative growth of the trace
    /// Whether run-out and area changed by no more than time.stop-change allows: only the deposit may still move.
    bool front_is_final = false;
    double deposit = 0;        ///< fraction of all volume that changed cell
    double deposit_error = 0;  ///< the same if the deposit were shifted by a cell: the error of the cells
};

enum class StopReason {
    end_time,
    still,
    settled,
    momentum,
    all_left,
    requested,
    reached_no_data,
    non_finite,
    impossible_speed,
    volume_drift,
};

/// Returns whether a run that stopped for this reason before its end time has nothing more to compute.
[[nodiscard]] constexpr bool ends_finally(StopReason reason) noexcept {
    return reason == StopReason::still || reason == StopReason::settled || reason == StopReason::momentum ||
           reason == StopReason::all_left;
}

/// Returns whether the flow may still have moved when a run ended for this reason.
[[nodiscard]] constexpr bool ends_in_motion(StopReason reason) noexcept {
    return reason == StopReason::end_time || reason == StopReason::momentum || reason == StopReason::requested;
}

/// The actual release of one area.
struct ReleasedArea {
    std::string name;    ///< as ReleaseArea::name
    double start = 0;    ///< [s]
    double volume = 0;   ///< [m3]
    double area = 0;     ///< in map view, where there is thickness [m2]
    double scaled = 1;   ///< factor by which its thickness was scaled to match a volume
    bool failed = true;  ///< false: its start is after the run's end
};

/// One row of gauges.csv.
struct GaugeRow {
    double time = 0;        ///< [s]
    std::size_t gauge = 0;  ///< index in Recording::gauges
    double depth = 0;       ///< vertical [m]
    double speed = 0;       ///< along the bed [m/s]
};

template <class Archive>
void serialise(Archive& archive, GaugeRow& row) {
    auto& [time, gauge, depth, speed] = row;
    archive(time, gauge, depth, speed);
}

/// One row of sections.csv.
struct SectionRow {
    double time = 0;          ///< [s]
    std::size_t section = 0;  ///< index in Recording::sections
    double discharge = 0;     ///< positive to the right of the line's direction [m3/s]
    double volume = 0;        ///< total so far, same sign [m3]
    double wetted_width = 0;  ///< length of the line that is deeper than the minimum depth [m]
    double max_depth = 0;     ///< on the line [m]
    double max_speed = 0;     ///< on the line, along the bed [m/s]
};

template <class Archive>
void serialise(Archive& archive, SectionRow& row) {
    auto& [time, section, discharge, volume, width, depth, speed] = row;
    archive(time, section, discharge, volume, width, depth, speed);
}

/// Volumes of the phases of a structured flow [m3].
struct PhaseVolumes {
    double solids = 0;    ///< grains alone
    double confined = 0;  ///< fluid inside the structure
    double free = 0;      ///< fluid outside it

    [[nodiscard]] double sum() const noexcept { return solids + confined + free; }
};

template <class Archive>
void serialise(Archive& archive, PhaseVolumes& volumes) {
    auto& [solids, confined, free] = volumes;
    archive(solids, confined, free);
}

/// Budget of the phases: the volumes that entered equal those inside, those that left, and the change from confined to
/// free.
struct PhaseBudget {
    PhaseVolumes entered, inside, left;
    double released = 0;       ///< confined fluid that became free [m3]
    double cohesion_left = 0;  ///< of the solids inside, mean by volume, relative to the initial value; 0 without
                               ///< cohesion
    double rms_apart =
        0;  ///< between the velocities of both phases where both are, weighted by fluid, at the end [m/s]
};

/// The result of a run: rasters on the working grid (NaN where nothing ever flowed), series, counts.
struct RunResult {
    /// All that the run made: the table of rasters describes each. Maxima are updated at every step.
    std::vector<NamedRaster> rasters;
    /// Returns null if the run made none of this name.
    [[nodiscard]] const Raster* find_raster(const std::string& name) const noexcept;
    /// Returns one that every run makes: bed, release, max_depth, max_velocity, max_pressure, arrival_time,
    /// final_depth. Throws std::out_of_range for another that this run did not make.
    [[nodiscard]] const Raster& raster(const std::string& name) const;
    /// Of what flew over places no higher than numerics.flight-clearance: the same names and units as the maxima on the
    /// ground. Empty: nothing flew.
    std::vector<NamedRaster> low_flights;
    void add(std::string name, Raster values) { rasters.push_back({std::move(name), std::move(values)}); }

    std::vector<Point> inflow_places;  ///< where material flows in, map coordinates
    /// Depths of rasters and frames, and depth times speed, are measured normal to the bed, not vertically.
    bool depth_is_normal = false;
    std::vector<SeriesRow> series;
    std::vector<GaugeRow> gauges;
    std::vector<SectionRow> sections;

    std::int64_t steps = 0;
    double simulated_seconds = 0;
    StopReason stop_reason = StopReason::end_time;
    std::optional<Settling> settling;  ///< over the last complete window
    std::int64_t particles_initial = 0, particles_final = 0, particles_peak = 0;
    std::int64_t particle_steps = 0;
    std::int64_t bytes_per_particle = 0, bytes_per_node = 0;       ///< of the engine's fields
    double engine_seconds = 0;                                     ///< wall time inside the engine, without on_frame
    double volume_initial = 0, volume_final = 0, volume_left = 0;  ///< [m3]
    double volume_entered = 0;                                     ///< total: initial, released later, flowed in, rain
    double volume_inflow = 0;                                      ///< of which flowed in through lines [m3]
    double volume_rained = 0;                                      ///< of which fell as rain [m3]
    double volume_infiltrated = 0;                                 ///< into the ground [m3]
    double volume_shown = 0;                                       ///< of the vertical depths of final_depth [m3]
    std::optional<PhaseBudget> phases;   ///< of solids and fluid in the structured model; none without solids
    std::vector<ReleasedArea> released;  ///< in the order of Scene::release
    bool exchanges = false;              ///< whether the scene erodes or deposits; the next lines are 0 otherwise
    double volume_eroded = 0, volume_deposited = 0;  ///< [m3]
    double volume_detrained = 0;                     ///< of the deposited, held by forest [m3]
    double momentum_deposited = 0;                   ///< of the deposits, magnitude of the sum [kg m/s]
    double thin_fraction = 0;          ///< greatest fraction of the volume thinner than the minimum depth at any time
    double moving_fraction_limit = 0;  ///< of the volume, faster than the scene's moving speed after the last step
    std::int64_t unsupported = 0;      ///< node-steps at which the motion over a convex bed lifted off
    /// Statistics of particles that flew over edges.
    struct Jumps {
        double volume = 0;   ///< sum over all jumps [m3]
        double highest = 0;  ///< above the ground [m]
        double longest = 0;  ///< in map view [m]
        double mean = 0;     ///< length in map view, by volume [m]
        Point from, to;      ///< of the longest, in map coordinates
    };
    std::optional<Jumps> jumps;  ///< none if nothing flew
    /// Greatest rise of energy not explained by gravity and dissipation (EnergyWatch); none if unknown.
    std::optional<double> energy_error;
    EnergyLineExcess energy_line;  ///< by places
    HardEvents hard_events;
    std::vector<RunProblem> run_problems;  ///< of the run's last step
    std::vector<std::string> terms;        ///< physics and numerics of the run
    std::vector<std::string> notes;        ///< for log.txt: choices made
    /// The run's, the worst first, then the scene's: every page, table and tag is made of these values.
    Warnings warnings;
};

/// Expected resources of a run of a scene.
struct RunEstimate {
    std::int64_t particles = 0;
    double volume = 0;              ///< released [m3]
    double inflow = 0;              ///< through lines until the end [m3]
    std::int64_t memory_bytes = 0;  ///< engine and rasters, with the particles of the start
    /// Cells of the map stored in each raster: all of them or, for terrain read on demand, approximately those reached
    /// by a flow of usual spreading.
    std::int64_t stored_cells = 0;
    std::int64_t bytes_per_particle = 0, bytes_per_node = 0;
    /// Memory of their fields, including the few that exist twice during sorting.
    [[nodiscard]] std::int64_t bytes_of_particles(std::int64_t count) const noexcept {
        return count * bytes_per_particle * 13 / 10;
    }
    double first_step_seconds = 0;  ///< stable step at the start [s]
    double wall_seconds = 0;        ///< rough
    std::vector<std::string> terms;
};

}  // namespace frana
