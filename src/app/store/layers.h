// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/raster.h"
#include "simulation/result.h"

namespace frana::app {

/// A raster of the result: its file NAME.tif, its texts, and how it is drawn. The one list that files, styles
/// and maps are made from.
struct Layer {
    std::string name;         ///< "max_depth"
    std::string title;        ///< "Maximum depth"
    std::string description;  ///< for the band: "Maximum flow depth over time, vertical"
    std::string unit;         ///< "m"
    std::string palette;
    bool progressive;  ///< classes 1, 2, 5, 10, ... rather than equal ones: for what is small over most of
                       ///< the area
    Raster RunResult::*values;  ///< null: a raster of RunResult::more
};

/// Those that every result has.
std::vector<Layer> result_layers();
/// And those that only some results have: of RunResult itself, or of RunResult::more.
std::vector<Layer> all_layers();

/// The layer's raster in a result; null where the result has none.
const Raster* find_layer(const RunResult& result, const Layer& layer);

/// The layer of a name; throws Error(input) naming the known ones.
Layer layer_named(const std::string& name);

/// Class bounds of a layer's legend, the same in the GIS style and on the maps. `maximum` may be NaN (empty
/// layer).
std::vector<double> layer_classes(const Layer& layer, double maximum);

}  // namespace frana::app
