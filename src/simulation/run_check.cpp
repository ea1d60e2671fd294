// SPDX-License-Identifier: Apache-2.0
#include "simulation/run_check.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "simulation/flow.h"
#include "simulation/problem_place.h"
#include "simulation/structured_flow.h"
#include "simulation/structured_laws.h"
#include "simulation/terrain_sample.h"

namespace frana {
namespace {

using Kind = RunProblem::Kind;

// Where material enters and its depth and speed there.
struct StartValues {
    double highest = -std::numeric_limits<double>::infinity();  // ground [m]
    double deepest = 0, fastest = 0;

    void ground(double z) {
        if (!std::isnan(z)) highest = std::max(highest, z);
    }
};

StartValues start_of(const Scene& scene, const Release& release, const Arrivals& arrivals) {
    StartValues start;
    const Raster& bed = release.bed;
    release.depth.values.for_each_stored([&](std::size_t cell, double depth) {
        if (!(depth > 0)) return;
        start.deepest = std::max(start.deepest, depth);
        start.ground(bed.values[cell]);
    });
    if (scene.structured && scene.structured->initial_fluid) {  // released material may fall on it or into it
        double deepest = 0;
        scene.structured->initial_fluid->values.for_each_stored([&](std::size_t cell, double depth) {
            if (!(depth > 0)) return;
            deepest = std::max(deepest, depth);
            start.ground(bed.values[cell]);
        });
        start.deepest += deepest;
    }
    // Areas smaller than a cell do not appear with their thickness in any cell.
    for (const ReleasedArea& area : release.areas)
        if (area.area > 0) start.deepest = std::max(start.deepest, area.volume / area.area);
    for (const ReleaseArea& area : scene.release) start.fastest = std::max(start.fastest, area.speed);
    for (const InflowSource& source : arrivals.sources()) {
        const InflowSource::Extremes extremes = source.extremes();
        start.deepest = std::max(start.deepest, extremes.depth);
        start.fastest = std::max(start.fastest, extremes.speed);
        for (const Point place : source.places()) {
            const Cell cell = cell_of(scene.grid, place);
            start.ground(scene.terrain.at(cell.row, cell.column));
        }
    }
    return start;
}

double lowest_bed(const Raster& bed) {
    double lowest = std::numeric_limits<double>::infinity();
    bed.values.for_each_stored([&](std::size_t, double z) {
        if (!std::isnan(z)) lowest = std::min(lowest, z);
    });
    return lowest;
}

double deepest_erosion(const Scene& scene) {
    if (!scene.entrainment.erodes()) return 0;
    double erodible = scene.entrainment.erodible_depth;
    constexpr double k_most = 1000;  // [m], what zones may say
    if (scene.zones.erodible_depth && scene.zones.erodible_depth->values.is_tiled()) return k_most;  // not read yet
    if (scene.zones.erodible_depth) {
        scene.zones.erodible_depth->values.for_each_stored([&](std::size_t, double depth) {
            if (!std::isnan(depth)) erodible = std::max(erodible, depth);
        });
    }
    return erodible;
}

}  // namespace

double speed_bound(double gravity, double drop, double depth, double speed_at_start) {
    return std::sqrt(2 * gravity * drop) + 2 * std::sqrt(gravity * depth) + speed_at_start;
}

RunCheck::RunCheck(const Scene& scene, const Release& release, const Arrivals& arrivals, double pressure_factor)
    : grid_(scene.grid),
      gaps_matter_(scene.numerics.nodata == NodataPolicy::stop),
      gravity_(scene.numerics.gravity),
      lowest_(lowest_bed(release.bed)),
      erodible_(deepest_erosion(scene)) {
    const StartValues start = start_of(scene, release, arrivals);
    top_ = start.highest + start.deepest;
    depth_ = pressure_factor * start.deepest;
    at_start_ = start.fastest + (scene.structured ? recoil_speed(*scene.structured) : 0);
}

double RunCheck::greatest_speed(double lowest) const noexcept {
    return speed_bound(gravity_, std::max(0.0, top_ - (lowest - erodible_)), depth_, at_start_);
}

template <class AnyFlow>
std::vector<RunProblem> RunCheck::check(const AnyFlow& flow, const StepStatistics& statistics, double entered) const {
    const double speed = std::max(statistics.max_speed, statistics.fastest);
    const double error = std::abs(statistics.volume + flow.volume_left() - entered);
    std::vector<RunProblem> run_problems;
    const auto report = [&](Kind kind, std::optional<Point> local, std::int64_t count, double value, double limit) {
        RunProblem run_problem{kind, flow.steps(), flow.time(), {}, count, value, limit};
        if (local) run_problem.place = grid_.map_from_local(*local);
        run_problems.push_back(run_problem);
    };
    if (statistics.non_finite > 0) report(Kind::non_finite, place_of_non_finite(flow), statistics.non_finite, 0, 0);
    if (gaps_matter_ && statistics.no_data > 0) report(Kind::no_data, place_of_no_data(flow), statistics.no_data, 0, 0);
    const double bound = greatest_speed(std::min(lowest_, flow.nodes().lowest()));
    if (speed > bound) report(Kind::impossible_speed, place_of_speed(flow), 0, speed, bound);
    // Non-finite values, and volume missing because of them, were reported before.
    if (statistics.non_finite == 0 && error > k_volume_drift * entered)
        report(Kind::volume_drift, {}, 0, error / entered, k_volume_drift);
    return run_problems;
}

template std::vector<RunProblem> RunCheck::check(const Flow&, const StepStatistics&, double) const;
template std::vector<RunProblem> RunCheck::check(const StructuredFlow&, const StepStatistics&, double) const;

void add(const RunProblem& run_problem, HardEvents& events) {
    switch (run_problem.kind) {
        case Kind::non_finite:
            events.non_finite += run_problem.count;
            break;
        case Kind::impossible_speed:
            ++events.impossible_speed;
            break;
        case Kind::volume_drift:
            ++events.volume_drift;
            break;
        case Kind::no_data:
            events.entered_no_data += run_problem.count;
            break;
    }
}

StopReason reason_of(const RunProblem& run_problem) {
    switch (run_problem.kind) {
        case Kind::impossible_speed:
            return StopReason::impossible_speed;
        case Kind::volume_drift:
            return StopReason::volume_drift;
        case Kind::no_data:
            return StopReason::reached_no_data;
        case Kind::non_finite:
            break;
    }
    return StopReason::non_finite;
}

std::string describe(const RunProblem& run_problem) {
    char where[128], what[256] = "";
    std::snprintf(where, sizeof where, "step %lld, %.6g s", static_cast<long long>(run_problem.step), run_problem.time);
    std::string text = where;
    if (run_problem.place) {
        std::snprintf(where, sizeof where, ", at (%.1f, %.1f)", run_problem.place->x, run_problem.place->y);
        text += where;
    }
    const auto count = static_cast<long long>(run_problem.count);
    switch (run_problem.kind) {
        case Kind::non_finite:
            std::snprintf(what, sizeof what, "%lld particles or cells have non-finite values", count);
            break;
        case Kind::impossible_speed:
            std::snprintf(what, sizeof what,
                          "a speed of %.4g m/s is more than the fall allows even without friction (%.4g m/s)",
                          run_problem.value, run_problem.limit);
            break;
        case Kind::volume_drift:
            std::snprintf(what, sizeof what, "the volume error is %.2g of all volume that came in (limit %.2g)",
                          run_problem.value, run_problem.limit);
            break;
        case Kind::no_data:
            std::snprintf(what, sizeof what, "the flow reached ground without elevation (%lld particles or cells)",
                          count);
            break;
    }
    return text + ": " + what;
}

}  // namespace frana
