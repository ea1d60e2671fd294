// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/ground_statistics.h"
#include "analysis/hazard.h"
#include "analysis/runout.h"
#include "analysis/separate_flows.h"
#include "core/json.h"
#include "core/words/words.h"
#include "params/keys/result_rasters.h"
#include "params/keys/scene_spec.h"
#include "simulation/result.h"
#include "simulation/scene.h"

namespace frana {

/// Maxima and arrival times of a run, of the flow on the ground and of what flew low over a place: what a house there
/// meets. Refers to the result.
class ReachedPlaces {
  public:
    explicit ReachedPlaces(const RunResult& result);
    /// @param name a raster of the result: max_depth, max_velocity, max_pressure, max_flux, max_head, arrival_time
    [[nodiscard]] const Raster& operator()(const std::string& name) const;

  private:
    const RunResult& result_;
    std::map<std::string, Raster> with_flights_;
};

/// Returns the class of intensity of every cell that a run reached, NaN elsewhere.
Raster intensity_classes(const RunResult& result, const HazardScheme& scheme);

/// A value of a run whose error numerics.accuracy estimates.
struct RunValue {
    std::string key;  ///< "covered_area_m2", "gauge bridge: max_depth_m"
    Sentence title;   ///< "Covered area", "bridge: Maximum depth"
    std::string unit;
    double value = 0;
    double resolution = 0;  ///< error of its measurement, whatever the cell size's convergence
    double negligible = 0;  ///< absolute error that is always acceptable
};

/// Values of run_statistics() selected by is_reported(); then greatest depth and speed for each gauge; greatest
/// discharge and volume for each cross-section. Same order for every run of a scene. All 0 if nothing was deeper than
/// the threshold. The resolution of the run-out is one cell.
/// @param threshold depth from which a cell belongs to the covered area [m]
std::vector<RunValue> reported_values(const RunResult& result, const Scene& scene, double threshold);

/// Whether a key is that of a value which some run may have.
bool is_value_key(const std::string& key);

/// Values by which studies compare runs.
struct RunStatistics {
    PeakValues depth, speed;          ///< of the maxima [m], along the bed [m/s]
    double covered_area = 0;          ///< deeper than the threshold at any time [m2]
    double run_out = 0;               ///< longest of the separate flows, straight, in map view [m]
    double final_depth_fraction = 0;  ///< fraction of the volume inside at the end that final_depth contains
};

/// One of these values, with its texts for tables.
struct RunStatistic {
    const char *key, *title, *unit;  ///< key: as in summary.json
    double (*of)(const RunStatistics&);
};

inline constexpr const char* k_run_out_key = "runout_m";
inline constexpr RunStatistic k_run_statistics[] = {
    {"max_depth_m", "Maximum depth", "m", [](const RunStatistics& f) { return f.depth.greatest; }},
    {"max_depth_p999_m", "99.9th percentile of depth", "m", [](const RunStatistics& f) { return f.depth.p999; }},
    {"max_depth_p99_m", "99th percentile of depth", "m", [](const RunStatistics& f) { return f.depth.p99; }},
    {"max_velocity_ms", "Maximum velocity", "m/s", [](const RunStatistics& f) { return f.speed.greatest; }},
    {"max_velocity_p999_ms", "99.9th percentile of speed", "m/s", [](const RunStatistics& f) { return f.speed.p999; }},
    {"max_velocity_p99_ms", "99th percentile of speed", "m/s", [](const RunStatistics& f) { return f.speed.p99; }},
    {"covered_area_m2", "Covered area", "m2", [](const RunStatistics& f) { return f.covered_area; }},
    {k_run_out_key, "Run-out", "m", [](const RunStatistics& f) { return f.run_out; }},
    {"final_depth_fraction", "Volume in final_depth", "-",
     [](const RunStatistics& f) { return f.final_depth_fraction; }},
};

/// Whether error estimates are reported for this value; the 99 % values add nothing.
constexpr bool is_reported(const RunStatistic& statistic) {
    const std::string_view key = statistic.key;
    return key.find("_p99_") == key.npos && key != "final_depth_fraction";
}

/// @param threshold depth from which a cell belongs to the covered area [m]
RunStatistics run_statistics(const RunResult& result, double threshold);

/// Returns the flows of a result that never met.
SeparateFlows separate_flows(const RunResult& result);

/// A raster of maxima whose high values are reported: in summary.json (keys NAME_UNIT, NAME_p999_UNIT, NAME_p99_UNIT),
/// in the report, and in studies.
struct PeakStatistic {
    const char *name, *key_unit;  ///< "max_depth", "m"
    const char* title;            ///< "Maximum depth"

    /// Its row in the table of rasters.
    [[nodiscard]] const ResultRaster& row() const { return *find_result_raster(name); }
};

inline constexpr std::array<PeakStatistic, 3> k_peak_statistics{{
    {RasterName::max_depth, "m", worded("Maximum depth")},
    {RasterName::max_velocity, "ms", worded("Maximum velocity")},
    {RasterName::max_pressure, "kpa", worded("Maximum dynamic pressure")},
}};

/// One for each value, over the cells of a trace.
using PeakStatistics = std::array<PeakValues, k_peak_statistics.size()>;

inline PeakStatistics peak_statistics(const RunResult& result, const Raster& trace) {
    PeakStatistics high;
    for (std::size_t i = 0; i < high.size(); ++i)
        high[i] = high_values(result.raster(k_peak_statistics[i].name), trace);
    return high;
}

// What summary.json says of a run itself; share/doc/results.md explains every key.

/// Figures of the trace and of the ground under it.
struct TraceFigures {
    double threshold = 0;          ///< output.trace-threshold: depth that counts as covered [m]
    double covered_area_m2 = 0;    ///< greatest depth above the threshold
    std::vector<Runout> run_outs;  ///< of the separate flows, the longest first; at least one
    PeakStatistics high;
    std::optional<GroundStatistics> release_ground, path_ground;  ///< of the DTM under the release and the trace
};

/// Returns the figures of a result and of the terrain, without those of the ground under the release.
/// @param threshold output.trace-threshold [m]
TraceFigures trace_figures(const RunResult& result, const Raster& terrain, double threshold);

/// Returns one word for scripts: "end-time", "still", "all-left", "requested", "reached-no-data", "non-finite".
std::string stop_word(StopReason reason);

/// Fraction of the volume above which more than creeps: a front that rests meanwhile may be pushed on from behind.
inline constexpr double k_creeping_volume = 0.05;

/// How material moved when a run ended.
struct MotionAtEnd {
    bool front = false;    ///< the front still moved: run-out and final depth are not those of the deposit
    bool deposit = false;  ///< run-out and area had stopped changing, some of the deposit still moved
};
/// @param fastest greatest speed of the last step [m/s]
/// @param moving_fraction fraction of the volume that still moved
/// @param front_is_final, deposit_change as in Settling; false, 0: not known
MotionAtEnd motion_at_end(StopReason reason, double fastest, double moving_fraction, bool front_is_final,
                          double deposit_change) noexcept;
MotionAtEnd motion_at_end(const RunResult& result) noexcept;

/// Flow that came to ground without elevation, which should stop the run (NodataPolicy::stop): only a particle that
/// enters it does, while the nodes at its edge, and a rim that resampling makes there, hold the others back.
struct GapContact {
    std::int64_t cells = 0;  ///< that the flow reached and that lack elevation, or one beside them does
    double depth = 0;        ///< greatest in these [m]
};
/// @param policy of scenes that are looked at: ground without elevation holds the flow of others as they asked for
GapContact gap_contact(const RunResult& result, const Scene& scene, NodataPolicy policy = NodataPolicy::stop);

/// Fraction of the volume through the edges of the computed ground from which a run-out is not the full one.
inline constexpr double k_left_ground = 1e-3;
/// Fraction of the volume that left, of what did not fall as rain; with rain, which leaves near the edges of any
/// ground, the least that it can be: what left beyond the volume of the rain, and the solids.
double left_fraction(const RunResult& result) noexcept;
inline bool left_ground(const RunResult& result) noexcept {
    return left_fraction(result) > k_left_ground;
}

/// Whether nobody knows the full reach of the flow: its front still moved at the end, it left the computed ground, came
/// to ground without elevation, or the run failed.
bool is_open(const RunResult& result, const Scene& scene);

/// As `frana check` says it, too.
Json ground_json(const GroundStatistics& ground);

// Each adds some keys, in the order of summary.json.
void add_end(Json& json, const RunResult& result, const SceneSpec& spec);
void add_particles(Json& json, const RunResult& result);
void add_flow(Json& json, const RunResult& result, const SceneSpec& spec);
void add_trace(Json& json, const TraceFigures& trace);
void add_run_problems(Json& json, const RunResult& result);

}  // namespace frana
