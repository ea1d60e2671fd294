// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "app/input/prepare.h"
#include "app/store/accuracy_record.h"
#include "simulation/result.h"

namespace frana::app {

/// How a level's scene is run: to its end, or until a signal stops it.
using RunLevel = std::function<RunResult(const Scene&)>;

/// Cells of the coarser levels [m], coarsest first: 24, 16, 12, 8, 6, 4, 3 and 2 times the scene's own, from the first
/// on that puts nine cells on the release; all up to 8 times where material only flows in.
std::vector<double> coarse_cell_sizes(const Prepared& finest);

/// The scene on larger cells over the same ground; for --resume it is the same scene. Throws Error(input) where the
/// scene cannot be had on them.
Prepared prepare_level(const SceneReading& reading, const Prepared& finest, double cell_size, RunLog& log);

/// A record without levels for a scene with numerics.accuracy.
AccuracyRecord begin_record(const Prepared& finest);

/// One coarser level, computed. None: a signal stopped it.
std::optional<AccuracyLevel> compute_level(const SceneReading& reading, const Prepared& finest, double cell_size,
                                           const RunLevel& run);

/// What a run gave, as a level.
AccuracyLevel level_of(const RunResult& result, const Prepared& level, const Raster& finest_terrain);

/// Decides on which cells a scene with numerics.accuracy is computed: coarser levels, coarsest first, until all values
/// of reported_values() are estimated within what was asked. The scene's own cells are chosen only where halving the
/// remaining errors, as a first-order method would, brings all of them within it, or where there are too few coarser
/// levels for an estimate. A level that fails is left out. Writes nothing. None: a signal stopped it.
std::optional<AccuracyRecord> choose_cells(const SceneReading& reading, const Prepared& finest, const RunLevel& run,
                                           RunLog& log);

}  // namespace frana::app
