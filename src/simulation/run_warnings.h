// SPDX-License-Identifier: Apache-2.0
// What a reader of a result must know before relying on it: the same sentences for the program's pages, the members of
// its studies and the library.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "analysis/ground_statistics.h"
#include "core/raster.h"
#include "core/words/warning.h"
#include "mpm/ground_walls.h"
#include "params/keys/scene_spec.h"
#include "simulation/result.h"
#include "simulation/scene.h"

namespace frana {

/// The pattern of a warning of which the least number is the worst.
inline constexpr const char* k_few_particles_warning =
    worded("{1} particles only: area and run-out uncertain; reduce terrain.cell-size");

/// Greatest rise of energy without a warning, of the work of gravity: a mass slides as much farther.
inline constexpr double k_energy_error = 0.05;

/// That of flights.
inline constexpr const char* k_flights_warning = worded("{1} m3 flew over edges, {2} m high: maps omit it");

/// Returns what is wrong with a release that no slope has, or that is too small for its cells.
/// @param scene tells whether a raster gives the thickness
/// @param bed, release vertical thickness on the grid of the bed [m]
/// @param particles at the start; 0: it fails later
Warnings release_warnings(const Scene& scene, const Raster& bed, const Raster& release,
                          const std::vector<ReleasedArea>& areas, std::int64_t particles);

/// Where a key was given, for messages; whether it was given.
using KeyPlace = std::function<std::string(const std::string& key)>;
using KeyTest = std::function<bool(const std::string& key)>;

/// Returns what is legal and dubious of a structured material with solids, or given and without effect.
/// @param thickness the greatest of anything released [m]
Warnings structured_warnings(const StructuredMaterial& material, double thickness, double cell_size,
                             const KeyPlace& where, const KeyTest& is_given);

/// Returns whether maps and values, or outlines and run-out, omit a substantial part of a release.
Warnings thin_release_warnings(const Raster& release, const Scene& scene);

/// Returns "release area 2 'North': 1 200 m3 from 400 m2, at 30 s".
Sentence released_sentence(const ReleasedArea& area, std::size_t index);

/// Returns everything that a run itself tells: how it ended, what its maps do not show.
Warnings run_warnings(const RunResult& result, const Scene& scene);
/// Warns of what a scheme without flight kept on the ground, if it is a substantial part of the flow.
void warn_of_jumps(const RunResult::Jumps& jumps, RunResult& result);
/// Warns of particles at walls of the ground, if a substantial part of the flow came to some and some went over.
/// @param other what computes walls better
void warn_of_walls(const WallContact& walls, const char* other, RunResult& result);

/// A cell of a deposit at rest whose surface stands above those beside it by more than friction carries.
struct Pile {
    double height = 0;  ///< of what friction does not carry [m]
    double depth = 0;   ///< of the cell, vertical [m]
    Point place;        ///< its centre in map coordinates
};
/// The highest. None: nothing stands higher, or the flow may still have moved.
std::optional<Pile> highest_pile(const RunResult& result, const Scene& scene);

/// Returns "412 to 780 m, slope 27 degrees on average, 51 at most".
Sentence ground_sentence(const GroundStatistics& ground);

/// Returns the tangent of the slope up to which the bed's friction holds material everywhere; 0 where places differ,
/// and where no law at the bed resists with it: the structured model's fluid, RAMMS's yield term alone, laws of fluids.
double sure_friction(const SceneSpec& scene);

/// Returns what is doubtful of the ground under a release: nearly vertical or flat, as in nature only where elevations
/// are in another unit than eastings or the layers do not belong together; or nowhere as steep as the slope up to which
/// friction holds it, as elevations that are too low for their eastings are.
/// @param friction tangent of that slope; 0: not known
Warnings release_ground_warnings(const GroundStatistics& ground, double friction);
/// Returns whether the ground under a path is steeper than those of landslides.
Warnings path_ground_warnings(const GroundStatistics& ground);

}  // namespace frana
