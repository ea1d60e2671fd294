// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "app/input/prepare.h"
#include "app/publish/summary.h"
#include "simulation/result.h"

namespace frana::app {

/// Runs a level's scene to its end, or until a signal stops it.
using RunLevel = std::function<RunResult(const Scene&)>;

/// Cell sizes of the coarser levels [m], coarsest first: 24, 16, 12, 8, 6, 4, 3 and 2 times the scene's own, beginning
/// with the first that has at least nine cells across the release; without a release, with 8 times.
std::vector<double> coarse_cell_sizes(const Prepared& finest);

/// The scene on larger cells over the same ground; its identity for --resume is unchanged. Throws Error(input) if the
/// scene cannot be prepared on them.
Prepared prepare_level(const SceneReading& reading, const Prepared& finest, double cell_size, RunLog& log);

/// A record without levels for a scene with numerics.accuracy.
AccuracyRecord begin_record(const Prepared& finest);

/// Computes one coarser level. Returns nothing if a signal stopped it.
std::optional<AccuracyLevel> compute_level(const SceneReading& reading, const Prepared& finest, double cell_size,
                                           const RunLevel& run);

/// A level from the result of its run.
AccuracyLevel level_of(const RunResult& result, const Prepared& level, const Raster& finest_terrain);

/// Chooses the cell size for a scene with numerics.accuracy: computes coarser levels, coarsest first, until the
/// estimated errors of all reported_values() are within the requested accuracy. Otherwise chooses the scene's own
/// cells: nothing is left unclaimed before these are computed. Skips a level that fails. Writes nothing. Returns
/// nothing if a signal stopped it.
/// @param coarse scheme of the coarser levels; the chosen one is computed by the scene's own
std::optional<AccuracyRecord> choose_cells(const SceneReading& reading, const Prepared& finest, Scheme coarse,
                                           const RunLevel& run, RunLog& log);

}  // namespace frana::app
