// SPDX-License-Identifier: Apache-2.0
#include "app/input/check_exposure.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "analysis/touched_cells.h"
#include "app/text/number_text.h"

namespace frana::app {
namespace {

bool has_ground(const MixedShape& shape, const Raster& terrain) {
    const std::vector<std::size_t> cells = touched_cells(shape, terrain.grid);
    return cells.empty() ||
           std::any_of(cells.begin(), cells.end(), [&](std::size_t cell) { return !std::isnan(terrain.values[cell]); });
}

}  // namespace

void warn_of_unknown_exposure(const gis::ExposedLayer& layer, const Bounds& map, const Raster* terrain, RunLog& log) {
    std::size_t unknown = 0;
    std::string first;
    for (const gis::ExposedFeature& feature : layer.features) {
        const bool is_outside = feature.shape.empty() || place_of(feature.shape, map) == MapPlace::outside;
        if (!is_outside &&
            (terrain == nullptr || terrain->values.is_tiled() || has_ground(feature.shape, std::as_const(*terrain))))
            continue;
        if (unknown++ == 0) first = feature.name;
    }
    if (unknown == 0) return;
    const auto whole = [](std::size_t count) { return numeral(grouped(static_cast<double>(count))); };
    log.warn(
        worded("{1} of {2} exposed features are off the map or on ground without elevation, the first is {3}: the "
               "result will say nothing of them",
               {whole(unknown), whole(layer.features.size()), first}));
}

}  // namespace frana::app
