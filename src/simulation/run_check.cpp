// SPDX-License-Identifier: Apache-2.0
#include "simulation/run_check.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>

#include "analysis/trace.h"
#include "core/geometry.h"
#include "core/reached_raster.h"
#include "params/keys/laws.h"
#include "params/keys/result_rasters.h"
#include "simulation/scene.h"
#include "simulation/structured_laws.h"

namespace frana {

// The place of a problem in a step. Each function searches everything, and is called only after the problem was
// detected.

namespace {

using Kind = RunProblem::Kind;

// Bound of the position of a particle moved by a step; nodes_to_particles leaves non-finite ones where they were.
constexpr double k_finite = 1e9;

Point place(const ParticleSet& particles, std::size_t p) {
    return {particles[Field::x][p], particles[Field::y][p]};
}

std::optional<Point> non_finite_particle(const ParticleSet& particles) {
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const double speed = std::hypot(particles[Field::u][p], particles[Field::v][p]);
        const double depth = particles[Field::volume][p] / particles[Field::area][p];
        const Point at = place(particles, p);
        if (!(speed < k_finite && depth < k_finite)) return at;
    }
    return std::nullopt;
}

std::optional<Point> particle_in_gap(const ParticleSet& particles, const NodeGrid& nodes) {
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const Point at = place(particles, p);
        if (nodes.bounds().contains(at.x, at.y) && nodes.is_gap(nodes.scale().node_of(at.x, at.y))) return at;
    }
    return std::nullopt;
}

// Returns the place of a problem, local metres; none if the step's length itself was non-finite. The step that first
// exceeds the bound of the speed is the run's last: the place is that of the greatest speed so far.
std::optional<Point> place_of(Kind kind, const Model& model) {
    const ParticleSet* const particles = model.particle_set();
    const NodeGrid& nodes = model.nodes();
    std::optional<Point> at;
    if (kind != Kind::impossible_speed) {
        if (particles != nullptr)
            at = kind == Kind::non_finite ? non_finite_particle(*particles) : particle_in_gap(*particles, nodes);
        return at ? at : model.cell_with(kind);
    }
    double greatest = 0;
    const ZeroArray<double>& speeds = model.maxima().speed;
    model.for_each_active_node([&](std::size_t node) {
        if (!(speeds[node] > greatest)) return;
        greatest = speeds[node];
        const auto index = static_cast<std::int64_t>(node);
        at = nodes.middle(index % nodes.stride(), index / nodes.stride());
    });
    for (std::size_t p = 0; particles != nullptr && p < particles->size(); ++p) {
        const double speed = std::hypot((*particles)[Field::u][p], (*particles)[Field::v][p]);
        if (!(speed > greatest)) continue;
        greatest = speed;
        at = place(*particles, p);
    }
    return at;
}

std::string text(double value, int digits) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%.*g", digits, value);
    return buffer;
}

}  // namespace

std::vector<Problem> structured_problems(const StructuredMaterial& material, double cell_size,
                                         const std::function<std::string(const std::string&)>& where) {
    std::vector<Problem> problems;
    if (!material.solids) return problems;
    if (const double length = material.damage_length.value_or(cell_size);
        length < k_least_length * cell_size || length > k_greatest_length * cell_size) {
        problems.push_back({"does not fit the cells", where("structured.damage-length"), text(length, 4) + " m",
                            text(k_least_length * cell_size, 4) + " to " + text(k_greatest_length * cell_size, 4) +
                                " m: half a cell to two cells",
                            "Choose cells between half and twice of it, or another length"});
    }
    double lightest = HUGE_VAL, loosest = HUGE_VAL, densest = 0;
    visit_materials(material, [&](const SolidValues& solid) {
        lightest = std::min(lightest, solid.grain_density);
        if (!(solid.solid_fraction > 0)) return;
        loosest = std::min(loosest, solid.solid_fraction);
        densest = std::max(densest, solid.solid_fraction);
    });
    constexpr double k_least_fraction = 0.1, k_most_fraction = 0.9;  // of grains that dilate
    if (material.pores.dilates() && (loosest < k_least_fraction || densest > k_most_fraction))
        problems.push_back(
            {"makes the solids dilate, which needs grains with pores", where("material.compressibility"),
             "structured.solid-fraction = " + text(densest > k_most_fraction ? densest : loosest, 4),
             "structured.solid-fraction " + text(k_least_fraction, 2) + " to " + text(k_most_fraction, 2),
             "Correct that, or remove the key"});
    if (has_fluid(material) && !(lightest > material.fluid_density)) {
        problems.push_back(
            {"is not denser than the fluid: the solids would float, which the laws of drag and buoyancy do not "
             "describe",
             where("structured.grain-density"), text(lightest, 5) + " kg/m3",
             "more than structured.fluid-density, " + text(material.fluid_density, 5) + " kg/m3",
             "Correct one of them; rock has some 2650"});
    }
    return problems;
}

namespace {

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
    if (scene.structured && scene.structured->rain.falls())
        scene.terrain.values.for_each_stored([&](std::size_t, double z) { start.ground(z); });
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
    double erodible = scene.entrainment.erodible_depth.value_or(0);
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

std::vector<RunProblem> RunCheck::check(const Model& model, const StepStatistics& statistics, double entered) const {
    const double speed = std::max(statistics.max_speed, statistics.fastest);
    const double error = std::abs(statistics.volume + model.volume_left() + model.bed_budget().infiltrated - entered);
    std::vector<RunProblem> run_problems;
    const auto report = [&](Kind kind, std::int64_t count, double value, double limit) {
        RunProblem run_problem{kind, model.steps(), model.time(), {}, count, value, limit};
        const auto local = kind == Kind::volume_drift ? std::nullopt : place_of(kind, model);
        if (local) run_problem.place = grid_.map_from_local(*local);
        run_problems.push_back(run_problem);
    };
    if (statistics.non_finite > 0) report(Kind::non_finite, statistics.non_finite, 0, 0);
    if (gaps_matter_ && statistics.no_data > 0) report(Kind::no_data, statistics.no_data, 0, 0);
    const double bound = greatest_speed(std::min(lowest_, model.nodes().lowest()));
    if (speed > bound) report(Kind::impossible_speed, 0, speed, bound);
    // Non-finite values, and volume missing because of them, were reported before.
    if (statistics.non_finite == 0 && error > k_volume_drift * entered)
        report(Kind::volume_drift, 0, error / entered, k_volume_drift);
    return run_problems;
}

EnergyLineExcess energy_line_excess(const RunResult& result, const Scene& scene, double pressure_factor) {
    const Raster &bed = result.raster(RasterName::bed), &release = result.raster("release"),
                 &depth = result.raster(RasterName::max_depth), &speed = result.raster(RasterName::max_velocity);
    const double gravity = scene.numerics.gravity;
    double fastest = scene.structured ? recoil_speed(*scene.structured) : 0, push = 0;
    for (const ReleaseArea& area : scene.release) fastest = std::max(fastest, area.speed);
    Raster source = reached_raster(scene.grid, k_no_data);
    const auto enters = [&](std::size_t cell, double deep, double fast) {
        if (deep > 0) source.values[cell] = bed.values[cell] + deep + fast * fast / (2 * gravity);
    };
    release.values.for_each_stored([&](std::size_t cell, double deep) { enters(cell, deep, fastest); });
    if (scene.structured && scene.structured->initial_fluid)
        scene.structured->initial_fluid->values.for_each_stored(
            [&](std::size_t cell, double deep) { enters(cell, std::max(deep, release.values[cell]), fastest); });
    for (const Point place : result.inflow_places) {
        const Cell at = cell_of(scene.grid, scene.grid.local_from_map(place));
        const std::size_t cell = bed.index(at.row, at.column);
        enters(cell, depth.values[cell], speed.values[cell]);
    }
    for (const Raster* deep : {&depth, &release})
        if (const double deepest = maximum(*deep); deepest > 0) push = std::max(push, pressure_factor * deepest);
    push += deepest_erosion(scene);
    const double friction = scene.structured ? 0 : friction_coefficient_of(scene.material).value_or(0);
    const std::optional<Raster>& zones = scene.zones.friction_coefficient;
    const double buoyed = 1 - pore_pressure_of(scene.material).greatest();
    const std::vector<std::string> terms = bed_friction_terms(scene.material);
    const bool resists = !scene.structured && std::any_of(terms.begin(), terms.end(), [](const std::string& term) {
        return find_law(LawKind::bed_friction, term).resists_with_friction;
    });
    return energy_line_excess({bed, source, depth, speed,
                               [&](std::size_t cell) {
                                   const double here = zones ? zones->values[cell] : friction;
                                   return resists && here > 0 ? buoyed * here : 0;
                               },
                               gravity, push});
}

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
