// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "app/input/prepare.h"
#include "simulation/result.h"

namespace frana::app {

/// Returns the cells of the map that the rasters of a result cover under output.extent: those round everything that was
/// released, reached or surveyed, with a margin. None: all, and so for a run that is not finished, which --resume
/// continues on the whole map.
std::optional<CellWindow> reached_window(const Prepared& prepared, const RunResult& result);

/// A window of all rasters of a result.
RunResult cut_to(const RunResult& result, const CellWindow& window);
/// The same for the terrain; the scene's grid remains the one that was computed on.
Prepared cut_to(const Prepared& prepared, const CellWindow& window);

}  // namespace frana::app
