// SPDX-License-Identifier: Apache-2.0
// From the words and units of scene files to the engine's values, as far as they come from no file.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "analysis/friction_table.h"
#include "core/error.h"
#include "params/keys/scene_spec.h"
#include "params/keys/zone_keys.h"
#include "simulation/scene.h"

namespace frana {

inline constexpr double k_mm_per_hour = 3.6e6;  ///< in a metre per second

/// Returns [structured], if that is the scene's model; without properties that vary from place to place.
std::optional<StructuredMaterial> structured_of(const SceneSpec& spec);
/// Sets what the keys give and no file: material, numerics, times, what is recorded.
void set_values(const SceneSpec& spec, Scene& scene);

/// Sets what the numbers of [release] say of an area: how its thickness is measured, when it fails, how fast it starts.
/// The volume of all areas is the scene's (release_volume_of).
void set_uniform_details(const ReleaseSpec& spec, ReleaseArea& area);
std::optional<double> release_volume_of(const ReleaseSpec& spec);

// Rules for values in memory, read from files or given by a user of the library. `where` names their source; what
// breaks a rule is added to `problems`.

/// Two points or more, of numbers in range and times that do not fall [s, m3/s, m/s]; any discharge, and none without
/// speed. Returns whether it is so.
bool check_hydrograph(const std::vector<HydrographPoint>& hydrograph, const Place& where, Problems& problems);
/// A thickness [m] that a landslide can have.
void check_thickness(double thickness, const Place& where, Problems& problems);
/// Names identify rows: each is there once.
void check_names(std::vector<std::string> names, const Place& where, Problems& problems);
/// All places are on the grid.
void check_inside(const Polyline& places, const GridSpec& grid, const std::string& name, const Place& where,
                  Problems& problems);
/// The scene's laws are defined up to this friction coefficient, the zones' greatest.
void check_zone_friction(const SceneSpec& spec, double greatest, const Place& where, Problems& problems);
/// Gives `scene` bed friction by place after its friction table, where [zones] has no value; the scene is complete
/// otherwise. The volume is that of release and inflow, unless a key gives it. Ground of which nothing is read yet
/// stays so.
/// @param forest anything but NaN where forest stands
/// Returns what was chosen; null without a table, or with a problem. Throws as make_release does.
std::shared_ptr<const FrictionByPlace> set_table_friction(const SceneSpec& spec, std::optional<Raster> forest,
                                                          const Place& where, Scene& scene, Problems& problems);
/// Returns the raster of a key's quantity.
std::optional<Raster> MaterialZones::*raster_of(const ZoneKey& key);
/// The scene's laws use the values by place of this key.
void check_zone_use(const ZoneKey& key, const SceneSpec& spec, const Place& where, Problems& problems);

}  // namespace frana
