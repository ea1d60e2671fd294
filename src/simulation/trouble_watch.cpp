// SPDX-License-Identifier: Apache-2.0
#include "simulation/trouble_watch.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "simulation/flow.h"
#include "simulation/structured_flow.h"
#include "simulation/structured_laws.h"
#include "simulation/terrain_sample.h"
#include "simulation/trouble_place.h"

namespace frana {
namespace {

using Kind = Trouble::Kind;

// Where material comes from and how deep and fast it may be there.
struct Start {
    double highest = -std::numeric_limits<double>::infinity();  // ground [m]
    double deepest = 0, fastest = 0;

    void ground(double z) {
        if (!std::isnan(z)) highest = std::max(highest, z);
    }
};

Start start_of(const Scene& scene, const Release& release, const Arrivals& arrivals) {
    Start start;
    for (std::size_t i = 0; i < release.depth.values.size(); ++i) {
        if (!(release.depth.values[i] > 0)) continue;
        start.deepest = std::max(start.deepest, release.depth.values[i]);
        start.ground(release.bed.values[i]);
    }
    if (scene.structured && scene.structured->initial_fluid) {  // what fails may fall on it or into it
        const std::vector<double>& lying = scene.structured->initial_fluid->values;
        double deepest = 0;
        for (std::size_t i = 0; i < lying.size(); ++i) {
            if (!(lying[i] > 0)) continue;
            deepest = std::max(deepest, lying[i]);
            start.ground(release.bed.values[i]);
        }
        start.deepest += deepest;
    }
    // Of an area smaller than a cell no cell shows the thickness.
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

double lowest_bed(const Scene& scene, const Raster& bed) {
    double lowest = std::numeric_limits<double>::infinity();
    for (const double z : bed.values) {
        if (!std::isnan(z)) lowest = std::min(lowest, z);
    }
    if (!scene.entrainment.erodes()) return lowest;
    double erodible = scene.entrainment.erodible_depth;
    if (scene.zones.erodible_depth) {
        for (const double depth : scene.zones.erodible_depth->values)
            if (!std::isnan(depth)) erodible = std::max(erodible, depth);
    }
    return lowest - erodible;
}

double bound_of(const Scene& scene, const Release& release, const Arrivals& arrivals, double pressure_factor) {
    const Start start = start_of(scene, release, arrivals);
    const double drop = std::max(0.0, start.highest + start.deepest - lowest_bed(scene, release.bed));
    const auto cells = static_cast<std::size_t>(scene.grid.cell_count());
    const double recoil = scene.structured ? recoil_speed(*scene.structured, cells) : 0;
    return speed_bound(scene.numerics.gravity, drop, pressure_factor * start.deepest, start.fastest + recoil);
}

}  // namespace

double speed_bound(double gravity, double drop, double depth, double speed_at_start) {
    return std::sqrt(2 * gravity * drop) + 2 * std::sqrt(gravity * depth) + speed_at_start;
}

TroubleWatch::TroubleWatch(const Scene& scene, const Release& release, const Arrivals& arrivals, double pressure_factor)
    : grid_(scene.grid),
      gaps_matter_(scene.numerics.nodata == NodataPolicy::stop),
      bound_(bound_of(scene, release, arrivals, pressure_factor)) {}

template <class AnyFlow>
std::vector<Trouble> TroubleWatch::look(const AnyFlow& flow, const StepFigures& figures, double taken) const {
    const double speed = std::max(figures.max_speed, figures.fastest);
    const double error = std::abs(figures.volume + flow.volume_left() - taken);
    std::vector<Trouble> troubles;
    const auto report = [&](Kind kind, std::optional<Point> local, std::int64_t count, double value, double limit) {
        Trouble trouble{kind, flow.steps(), flow.time(), {}, count, value, limit};
        if (local) trouble.place = grid_.map_from_local(*local);
        troubles.push_back(trouble);
    };
    if (figures.non_finite > 0) report(Kind::non_finite, place_of_non_finite(flow), figures.non_finite, 0, 0);
    if (gaps_matter_ && figures.no_data > 0) report(Kind::no_data, place_of_no_data(flow), figures.no_data, 0, 0);
    if (speed > bound_) report(Kind::impossible_speed, place_of_speed(flow), 0, speed, bound_);
    // What is not a number, or is gone from the sums because of it, was reported as such.
    if (figures.non_finite == 0 && error > k_volume_drift * taken)
        report(Kind::volume_drift, {}, 0, error / taken, k_volume_drift);
    return troubles;
}

template std::vector<Trouble> TroubleWatch::look(const Flow&, const StepFigures&, double) const;
template std::vector<Trouble> TroubleWatch::look(const StructuredFlow&, const StepFigures&, double) const;

void add(const Trouble& trouble, HardEvents& events) {
    switch (trouble.kind) {
        case Kind::non_finite:
            events.non_finite += trouble.count;
            break;
        case Kind::impossible_speed:
            ++events.impossible_speed;
            break;
        case Kind::volume_drift:
            ++events.volume_drift;
            break;
        case Kind::no_data:
            events.entered_no_data += trouble.count;
            break;
    }
}

StopReason reason_of(const Trouble& trouble) {
    switch (trouble.kind) {
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

std::string describe(const Trouble& trouble) {
    char where[128], what[256] = "";
    std::snprintf(where, sizeof where, "step %lld, %.6g s", static_cast<long long>(trouble.step), trouble.time);
    std::string text = where;
    if (trouble.place) {
        std::snprintf(where, sizeof where, ", at (%.1f, %.1f)", trouble.place->x, trouble.place->y);
        text += where;
    }
    const auto count = static_cast<long long>(trouble.count);
    switch (trouble.kind) {
        case Kind::non_finite:
            std::snprintf(what, sizeof what, "%lld particles or cells have non-finite values", count);
            break;
        case Kind::impossible_speed:
            std::snprintf(what, sizeof what,
                          "a speed of %.4g m/s is more than the fall allows even without friction (%.4g m/s)",
                          trouble.value, trouble.limit);
            break;
        case Kind::volume_drift:
            std::snprintf(what, sizeof what, "the volume error is %.2g of all volume that came in (limit %.2g)",
                          trouble.value, trouble.limit);
            break;
        case Kind::no_data:
            std::snprintf(what, sizeof what, "the flow reached ground without elevation (%lld particles or cells)",
                          count);
            break;
    }
    return text + ": " + what;
}

}  // namespace frana
