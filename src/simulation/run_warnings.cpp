// SPDX-License-Identifier: Apache-2.0
#include "simulation/run_warnings.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "analysis/ground_statistics.h"
#include "analysis/trace.h"
#include "core/text.h"
#include "core/words/number_text.h"
#include "models/structured/solid/solid_laws.h"
#include "params/keys/laws.h"
#include "params/keys/result_rasters.h"
#include "params/keys/zone_keys.h"
#include "simulation/run_summary.h"
#include "simulation/structured_laws.h"

namespace frana {
namespace {

constexpr double k_shown_fraction = 0.05;  // relative difference of a raster's volume from the flow's without a warning
constexpr double k_jumping = 0.05;         // of all volume, over all jumps
// Of all volume, that may meet walls of the ground and pass them without a warning.
constexpr double k_walled = 0.05, k_over_walls = 0.01;
constexpr double k_pile = 0.05;          // of the deepest deposit, that a pile may stand too high without a warning
constexpr double k_thin_fraction = 0.1;  // of the volume that may be thinner than visible without a warning
constexpr double k_high_step = 30;       // of the surface of a release between two cells, without a warning [m]
constexpr double k_steep_step = 1.75;    // and its slope: 60 degrees
constexpr double k_stout = 0.5;          // mean thickness of a release, of its width
constexpr std::int64_t k_few_particles = 300;
// Cells across the flow: in a gully of 2 to 3 its speed is 15 to 60 % too low (Run.TellsOfAFlowOfFewCells).
constexpr double k_narrow = 3;
// Mean slopes [degrees]. Landslides start on some 10 to 50 degrees; those on less are dams, tailings and quick clay.
constexpr double k_flat_release = 2, k_steep_release = 55;
// Granular flows and mudflows run out over 5 to 35 degrees. Feet read as metres turn 30 degrees into 62.
constexpr double k_steep_path = 45;

Sentence place_of(Point place) {
    return worded("E {1}, N {2}", {numeral(grouped(place.x)), numeral(grouped(place.y))});
}

Sentence percent(double fraction) {
    return numeral(number_text(100 * fraction, 2));
}

/// Warns of ground without elevation that the flow came to: it may have gone farther.
void warn_of_gaps(const RunResult& result, const Scene& scene, Warnings& warnings) {
    if (const GapContact wall = gap_contact(result, scene, NodataPolicy::wall); wall.cells > 0)
        warnings.push_back({worded("terrain.nodata-policy = wall holds flow {1} m deep, {2} cells",
                                   {numeral(number_text(wall.depth, 3)), numeral(std::to_string(wall.cells))}),
                            false});
    const GapContact gap = gap_contact(result, scene);
    if (gap.cells == 0 || result.stop_reason == StopReason::reached_no_data) return;
    warnings.push_back({worded("no-data in {1} cells held the flow ({2} m): set terrain.nodata-policy",
                               {numeral(std::to_string(gap.cells)), numeral(number_text(gap.depth, 3))}),
                        true});
}

/// What stopped a run while its flow may have moved, and what lets it run on.
std::pair<std::string, Sentence> stop_and_remedy(StopReason reason) {
    const auto lower = [](const char* key) { return std::pair(std::string(key), worded("lower {1}", {key})); };
    switch (reason) {
        case StopReason::momentum:
            return lower("time.stop-momentum");
        case StopReason::settled:
            return lower("time.stop-change");
        case StopReason::requested:
            return {"signal", worded("use --resume")};
        default:
            return {"time.end", worded("raise time.end")};
    }
}

/// At the end: the moving volume.
void warn_of_motion(const RunResult& result, Warnings& warnings) {
    if (!motion_at_end(result).front) return;
    const auto [stop, remedy] = stop_and_remedy(result.stop_reason);
    const bool front_rests = result.settling && result.settling->front_is_final;
    warnings.push_back({worded(front_rests ? worded("the deposit still moves when {2} ends the run ({1} %): {3}")
                                           : worded("the flow still moves when {2} ends the run ({1} %): {3}"),
                               {percent(result.moving_fraction_limit), stop, remedy}),
                        true});
}

/// Warns of flow not shown on maps.
void warn_of_thin_flow(const RunResult& result, const Scene& scene, Warnings& warnings) {
    if (result.thin_fraction < k_thin_fraction) return;
    const double minimum = scene.numerics.minimum_depth;
    warnings.push_back({worded("{1} % of flow thinner than {2} = {3} m: lower it",
                               {percent(result.thin_fraction), "numerics.minimum-depth", shortest_text(minimum)}),
                        true});
}

/// Warns of flow on maps that is not in outlines and run-out.
void warn_of_empty_trace(const RunResult& result, const Scene& scene, Warnings& warnings) {
    const double threshold = scene.time.trace_threshold, deepest = maximum(result.raster(RasterName::max_depth));
    if (!(deepest > 0) || deepest > threshold) return;
    warnings.push_back({worded("flow nowhere deeper than output.trace-threshold = {1} m ({2} m): lower it",
                               {shortest_text(threshold), numeral(number_text(deepest, 3))}),
                        true});
}

void warn_of_energy(const RunResult& result, Warnings& warnings) {
    if (!result.energy_error || *result.energy_error <= k_energy_error) return;
    warnings.push_back(
        {worded("energy error {1} %: speeds and run-out may be too great", {percent(*result.energy_error)}), false});
}

void warn_of_energy_line(const RunResult& result, Warnings& warnings) {
    const EnergyLineExcess& excess = result.energy_line;
    if (excess.of_fall <= k_line_error) return;
    const double volume = std::min(excess.volume, result.volume_entered);  // cells are covered one after the other
    warnings.push_back(
        {worded("flow {1} m above its energy line at {2} (≤ {3} m3)",
                {numeral(number_text(excess.height, 3)), place_of(excess.place), numeral(grouped(volume))}),
         false, excess.place});
}

/// Crowded particles at rest feel the pressure of a shallower flow: a pile of them may stand too high.
void warn_of_piles(const RunResult& result, const Scene& scene, Warnings& warnings) {
    const std::optional<Pile> pile = highest_pile(result, scene);
    if (!pile || pile->height <= k_pile * maximum(result.raster(RasterName::final_depth))) return;
    warnings.push_back(
        {worded("deposit {2} m, uncertain by {1} m at {3}: use smaller cells",
                {numeral(number_text(pile->height, 2)), numeral(number_text(pile->depth, 3)), place_of(pile->place)}),
         false, pile->place});
}

/// Width of the flow, in cells, where it was faster than half of its greatest speed: the median of the least of four
/// directions through each cell.
double fast_width(const RunResult& result, double threshold) {
    constexpr std::int64_t k_enough = 8;
    const Raster &depth = result.raster(RasterName::max_depth), &speed = result.raster(RasterName::max_velocity);
    const GridSpec& grid = depth.grid;
    const double fast = 0.5 * maximum(speed);
    std::vector<double> widths;
    depth.values.for_each_stored([&](std::size_t cell, double here) {
        if (!(here > threshold) || !(speed.values[cell] > fast)) return;
        const auto row = static_cast<std::int64_t>(cell) / grid.columns,
                   column = static_cast<std::int64_t>(cell) % grid.columns;
        const auto covered = [&](std::int64_t r, std::int64_t c) {
            return r >= 0 && c >= 0 && r < grid.rows && c < grid.columns && depth.at(r, c) > threshold;
        };
        double least = k_enough;
        for (const auto& [r, c] : {std::pair{0, 1}, {1, 0}, {1, 1}, {1, -1}}) {
            std::int64_t count = 1;
            for (const std::int64_t side : {-1, 1})
                for (std::int64_t n = 1; n < k_enough && covered(row + side * n * r, column + side * n * c); ++n)
                    ++count;
            least = std::min(least, static_cast<double>(count) * std::hypot(r, c));
        }
        widths.push_back(least);
    });
    return widths.empty() ? static_cast<double>(k_enough) : percentile(std::move(widths), 0.5);
}

void warn_of_narrow_flow(const RunResult& result, const Scene& scene, Warnings& warnings) {
    if (result.steps == 0) return;
    const double width = fast_width(result, scene.time.trace_threshold);
    if (width > k_narrow) return;
    warnings.push_back({worded("flow {1} cells wide, speeds uncertain by a third: use smaller cells",
                               {numeral(number_text(width, 2))}),
                        false});
}

/// The greatest step of a release's surface that the bed below does not have.
struct SurfaceStep {
    double height = 0;  ///< [m]
    Point place;        ///< of the higher cell
};

SurfaceStep greatest_step(const Raster& bed, const Raster& release) {
    SurfaceStep greatest;
    const GridSpec& grid = release.grid;
    release.values.for_each_stored([&](std::size_t cell, double thickness) {
        if (!(thickness > 0)) return;
        const auto row = static_cast<std::int64_t>(cell) / grid.columns,
                   column = static_cast<std::int64_t>(cell) % grid.columns;
        for (const auto& [r, c] :
             {std::pair{row - 1, column}, {row + 1, column}, {row, column - 1}, {row, column + 1}}) {
            if (r < 0 || c < 0 || r >= grid.rows || c >= grid.columns) continue;
            const double beside = release.at(r, c), fall = bed.values[cell] - bed.at(r, c);
            const double height = thickness - (beside > 0 ? beside : 0) + std::min(fall, 0.0);
            if (height > greatest.height) greatest = {height, grid.cell_centre(row, column)};
        }
    });
    return greatest;
}

/// The release must equal the volume of the raster that gives its thickness inside the perimeter.
void warn_of_file_volume(const Scene& scene, const std::vector<ReleasedArea>& areas, Warnings& warnings) {
    constexpr double k_scaled = 1.25, k_different = 0.01;
    constexpr double k_of_this_mass = 0.5;  // inside: less, and the raster has the thickness of all ground
    const FileVolume& file = *scene.file_volume;
    if (!(file.inside > 0)) return;
    double released = 0;
    for (const ReleasedArea& area : areas) {
        released += area.volume;
        if (area.scaled > k_scaled || area.scaled < 1 / k_scaled)
            warnings.push_back(worded("thickness scaled by {1} to its file's volume: check nodata",
                                      {numeral(number_text(area.scaled, 3))}));
    }
    const double difference = released / file.inside - 1, part = file.inside / file.all;
    if (part > k_of_this_mass && part < 1 - k_different)
        warnings.push_back(worded("thickness raster {1} m3, perimeter {2} m3: {3} % not released",
                                  {numeral(grouped(file.all)), numeral(grouped(file.inside)), percent(1 - part)}));
    if (std::abs(difference) > k_different)
        warnings.push_back(worded("release {2} m3, its raster {1} m3 ({3} %)",
                                  {numeral(grouped(file.inside)), numeral(grouped(released)), percent(difference)}));
}

/// Extremes over all materials of a scene.
struct Extremes {
    double cohesion = 0;      ///< [Pa]
    double strain = 0;        ///< elastic, at the uniaxial strength [-]
    double steepest_bed = 0;  ///< greatest bed friction, as an angle [degrees]
    double bed_over_own = 0;  ///< by how much it exceeds the material's own at most [degrees]
    double least_solid_fraction = 1;

    explicit Extremes(const StructuredMaterial& m) {
        const auto degrees = [](double tangent) { return std::atan(tangent) * 180 / std::numbers::pi; };
        visit_materials(m, [&](const SolidValues& solid) {
            cohesion = std::max(cohesion, solid.cohesion);
            steepest_bed = std::max(steepest_bed, degrees(solid.bed_friction));
            bed_over_own = std::max(bed_over_own, degrees(solid.bed_friction) - degrees(solid.friction));
            least_solid_fraction = std::min(least_solid_fraction, solid.solid_fraction);
            if (solid.cohesion > 0 && solid.friction >= 0)
                strain = std::max(
                    strain, structured::DruckerPrager::of(solid.friction, solid.cohesion).uniaxial() / m.young_modulus);
        });
    }
};

void warn_of_keys_without_effect(const StructuredMaterial& m, const Extremes& e, const KeyPlace& where,
                                 const KeyTest& is_given, Warnings& warnings) {
    const std::string confined = "structured.confined-fraction";
    if (!is_given(confined) || !(m.confined_fraction > 0)) return;
    if (e.cohesion == 0 || e.least_solid_fraction == 1)
        warnings.push_back(
            worded("{1} has no effect without {2}",
                   {where(confined), e.cohesion == 0 ? "structured.cohesion" : "structured.solid-fraction < 1"}));
}

}  // namespace

Warnings structured_warnings(const StructuredMaterial& m, double thickness, double cell_size, const KeyPlace& where,
                             const KeyTest& is_given) {
    Warnings warnings;
    const Extremes e(m);
    warn_of_keys_without_effect(m, e, where, is_given, warnings);
    if (e.bed_over_own > 1e-6)
        warnings.push_back(worded(
            "structured.bed-friction-angle {1} degrees over the internal: the material would shear within itself",
            {numeral(number_text(e.bed_over_own, 3))}));
    if (e.strain > m.critical_strain)
        warnings.push_back(worded("elastic strain {1} over structured.critical-strain = {2}: breaks before it yields",
                                  {numeral(number_text(e.strain, 2)), number_text(m.critical_strain, 2)}));
    // share/doc/structured.md, "Edges and cells".
    constexpr double k_edge = 0.81;
    const double least = k_edge * std::tan(e.steepest_bed * std::numbers::pi / 180) * cell_size;
    if (thickness > 0 && thickness < least)
        warnings.push_back(worded("release edges stand ({1} of {2} m): use cells of {3} m",
                                  {numeral(number_text(thickness, 3)), numeral(number_text(least, 3)),
                                   number_text(0.5 * thickness / least * cell_size, 2)}));
    const double shortest = k_least_length * cell_size, longest = k_greatest_default * cell_size;
    if (const double wanted = k_of_thickness * thickness;
        thickness > 0 && e.cohesion > 0 && !m.damage_length && (wanted < shortest || wanted > longest))
        warnings.push_back(worded("structured.damage-length is not given ({1} to {2} m): set it",
                                  {numeral(number_text(shortest, 3)), numeral(number_text(longest, 3))}));
    return warnings;
}

Warnings thin_release_warnings(const Raster& release, const Scene& scene) {
    Warnings warnings;
    const auto warn = [&](const char* key, double depth) {
        double thin = 0, all = 0;
        release.values.for_each_stored([&](std::size_t, double metres) {
            if (!(metres > 0)) return;
            all += metres;
            if (metres < depth) thin += metres;
        });
        const double fraction = all > 0 ? thin / all : 0;
        if (fraction <= k_thin_fraction) return;
        warnings.push_back(
            {worded("{1} % of flow thinner than {2} = {3} m: lower it", {percent(fraction), key, shortest_text(depth)}),
             true});
    };
    warn("numerics.minimum-depth", scene.numerics.minimum_depth);
    if (scene.time.trace_threshold > scene.numerics.minimum_depth)
        warn("output.trace-threshold", scene.time.trace_threshold);
    return warnings;
}

double sure_friction(const SceneSpec& scene) {
    bool by_place = scene.terrain.friction_zones || scene.friction_table.name;
    for (const ZoneKey& key : zone_keys()) by_place = by_place || (key.what == "friction" && scene.zones.*key.source);
    const std::vector<const Law*> laws = laws_of(scene);
    const bool resists =
        std::any_of(laws.begin(), laws.end(), [](const Law* law) { return law->resists_with_friction; });
    if (by_place || !resists) return 0;
    return friction_coefficient_of(scene.material).value_or(0) * (1 - pore_pressure_of(scene.material).greatest());
}

Warnings release_warnings(const Scene& scene, const Raster& bed, const Raster& release,
                          const std::vector<ReleasedArea>& areas, std::int64_t particles) {
    Warnings warnings;
    if (scene.file_volume) warn_of_file_volume(scene, areas, warnings);
    const bool still = std::any_of(scene.release.begin(), scene.release.end(),
                                   [](const ReleaseArea& area) { return area.level.has_value(); });
    const SurfaceStep step = still ? SurfaceStep{} : greatest_step(bed, release);
    if (step.height > std::max(k_high_step, k_steep_step * release.grid.cell_size))
        warnings.push_back(worded("release step of {1} m at {2}: check its thickness",
                                  {numeral(number_text(step.height, 3)), place_of(step.place)}));
    for (const ReleasedArea& area : areas) {
        const double width = std::sqrt(area.area), thickness = area.area > 0 ? area.volume / area.area : 0;
        if (thickness <= k_stout * width) continue;
        warnings.push_back(worded("release {1} m thick, {2} m2: too thick for depth-averaging",
                                  {numeral(number_text(thickness, 3)), numeral(grouped(area.area))}));
    }
    if (particles > 0 && particles < k_few_particles)
        warnings.push_back(worded(k_few_particles_warning, {numeral(std::to_string(particles))}));
    return warnings;
}

Sentence released_sentence(const ReleasedArea& area, std::size_t index) {
    return worded("release {1}: {2} m3, {3} m2, at {4} s",
                  {std::to_string(index + 1) + (area.name.empty() ? "" : " '" + area.name + "'"),
                   numeral(grouped(area.volume)), numeral(grouped(area.area)), numeral(shortest_text(area.start))});
}

Warnings run_warnings(const RunResult& result, const Scene& scene) {
    Warnings warnings;
    for (std::size_t i = 0; i < result.released.size(); ++i)
        if (!result.released[i].failed)
            warnings.push_back(
                {worded("not released before the end: {1}", {released_sentence(result.released[i], i)}), true});
    if (result.stop_reason == StopReason::reached_no_data) {
        warnings.push_back({worded("the run ended at ground without elevation: use a larger DTM"), true});
    }
    HardEvents others = result.hard_events;
    if (result.stop_reason == StopReason::reached_no_data) others.entered_no_data = 0;
    if (!others.none()) warnings.push_back({worded("numerical errors, result unreliable: see summary.json"), true});
    warn_of_gaps(result, scene, warnings);
    warn_of_motion(result, warnings);
    if (!result.released.empty() && result.stop_reason != StopReason::requested &&
        !(maximum(result.raster(RasterName::max_velocity)) > 0))
        warnings.push_back({worded("nothing moved: check material, release and DTM"), true});
    warnings += thin_release_warnings(result.raster("release"), scene);
    warn_of_thin_flow(result, scene, warnings);
    warn_of_empty_trace(result, scene, warnings);
    warnings += release_warnings(scene, result.raster(RasterName::bed), result.raster("release"), result.released,
                                 result.particles_initial);
    warn_of_energy(result, warnings);
    warn_of_energy_line(result, warnings);
    warn_of_narrow_flow(result, scene, warnings);
    warn_of_piles(result, scene, warnings);
    const double shown = result.volume_shown;
    // What is thinner than what is shown has a sentence of its own, and smaller cells would not help.
    const double hidden = result.thin_fraction < k_thin_fraction ? 0 : result.thin_fraction;
    const double unseen = (k_shown_fraction + hidden) * result.volume_final + result.volume_rained;  // a film of rain
    if (std::abs(shown - result.volume_final) > unseen) {
        warnings.push_back(worded("final_depth.tif has {1} m3, the flow {2} m3: use smaller cells",
                                  {numeral(grouped(shown)), numeral(grouped(result.volume_final))}));
    }
    if (left_ground(result)) {
        warnings.push_back(
            {worded("{1} m3 ({2} %) left the computed ground: use a larger DTM",
                    {numeral(grouped(result.volume_left)), percent(result.volume_left / result.volume_entered)}),
             true});
    }
    const Raster trace = trace_mask(result.raster(RasterName::max_depth), scene.time.trace_threshold);
    if (const auto path = ground_where(scene.terrain, trace, 0)) warnings += path_ground_warnings(*path);
    if (result.jumps && result.jumps->highest > scene.numerics.flight_clearance)
        warnings.push_back(worded(k_flights_warning, {numeral(grouped(result.jumps->volume)),
                                                      numeral(number_text(result.jumps->highest, 3))}));
    return warnings;
}

void warn_of_jumps(const RunResult::Jumps& jumps, RunResult& result) {
    if (jumps.volume < k_jumping * result.volume_entered) return;
    result.warnings.push_back(
        {worded("{1} m3 ({2} %) would fly at {3}: set numerics.scheme = default",
                {numeral(grouped(jumps.volume)), percent(jumps.volume / result.volume_entered), place_of(jumps.from)}),
         true, jumps.from});
}

void warn_of_walls(const WallContact& walls, const char* other, RunResult& result) {
    if (walls.met < k_walled * result.volume_entered || walls.passed < k_over_walls * result.volume_entered) return;
    result.warnings.push_back(
        worded("particles at walls, ≤ {1} m3 passed: compare with {2}", {numeral(grouped(walls.passed)), other}));
}

namespace {
/// Whether a yield stress or cohesion at the bed holds a pile besides friction.
bool holds_without_friction(const Material& material) {
    const std::vector<std::string> terms = bed_friction_terms(material);
    return std::any_of(terms.begin(), terms.end(), [](const std::string& term) {
        const Law& law = find_law(LawKind::bed_friction, term);
        return law.reads_key("material.yield-stress") || law.reads_key("material.cohesion");
    });
}

}  // namespace

std::optional<Pile> highest_pile(const RunResult& result, const Scene& scene) {
    const bool at_rest = result.stop_reason == StopReason::still || result.stop_reason == StopReason::settled;
    if (!at_rest || scene.structured || !result.hard_events.none() || holds_without_friction(scene.material))
        return std::nullopt;
    const Raster &bed = result.raster(RasterName::bed), &shown = result.raster(RasterName::final_depth);
    const Raster vertical = result.depth_is_normal ? vertical_depth(shown, bed) : Raster();
    const Raster& depth = result.depth_is_normal ? vertical : shown;
    const GridSpec& grid = depth.grid;
    const auto inside = [&](std::int64_t row, std::int64_t column) {
        return row >= 0 && column >= 0 && row < grid.rows && column < grid.columns;
    };
    const std::optional<Raster>& zones = scene.zones.friction_coefficient;
    std::optional<Pile> highest;
    depth.values.for_each_stored([&](std::size_t cell, double deep) {
        if (!(deep > 0)) return;
        const auto row = static_cast<std::int64_t>(cell) / grid.columns,
                   column = static_cast<std::int64_t>(cell) % grid.columns;
        const double friction = zones ? zones->values[cell] : friction_coefficient_of(scene.material).value_or(0);
        double height = deep;
        bool stands_free = false;
        // Between two that face each other the slope of the ground cancels.
        for (const auto& [r, c] : {std::pair{0, 1}, {1, 0}, {1, 1}, {1, -1}}) {
            if (!inside(row - r, column - c) || !inside(row + r, column + c)) continue;
            const double before = depth.at(row - r, column - c), after = depth.at(row + r, column + c);
            if (!(before > 0) || !(after > 0)) {
                // Against a wall or where there is no ground a deposit leans.
                if (std::isnan(bed.at(row - r, column - c)) || std::isnan(bed.at(row + r, column + c))) return;
                continue;
            }
            const double beside = (before + bed.at(row - r, column - c) + after + bed.at(row + r, column + c)) / 2;
            stands_free = true;
            height = std::min(height, deep + bed.values[cell] - beside - friction * std::hypot(r, c) * grid.cell_size);
        }
        if (stands_free && height > 0 && (!highest || height > highest->height))
            highest = {height, deep, grid.cell_centre(row, column)};
    });
    return highest;
}

Sentence ground_sentence(const GroundStatistics& ground) {
    return worded("{1} to {2} m, slope {3} degrees on average, {4} at most",
                  {numeral(number_text(ground.lowest, 5)), numeral(number_text(ground.highest, 5)),
                   numeral(number_text(ground.mean_slope_deg, 2)), numeral(number_text(ground.steepest_slope_deg, 2))});
}

Warnings release_ground_warnings(const GroundStatistics& ground, double friction) {
    const auto degrees = [](double angle) { return numeral(number_text(angle, 2)); };
    if (ground.mean_slope_deg > k_steep_release || ground.mean_slope_deg < k_flat_release)
        return {worded("mean slope of the release {1}°: check CRS and terrain.vertical-unit",
                       {degrees(ground.mean_slope_deg)})};
    const double angle = std::atan(friction) * 180 / std::numbers::pi;
    if (!(friction > 0) || ground.steepest_slope_deg >= angle) return {};
    return {worded("release slope {1}° under its friction {2}°: check terrain.vertical-unit",
                   {degrees(ground.steepest_slope_deg), numeral(number_text(angle, 3))})};
}

Warnings path_ground_warnings(const GroundStatistics& ground) {
    if (!(ground.mean_slope_deg > k_steep_path)) return {};
    return {worded("mean slope of the path {1}°: check terrain.vertical-unit",
                   {numeral(number_text(ground.mean_slope_deg, 2))})};
}

}  // namespace frana
