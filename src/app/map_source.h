// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/geometry.h"
#include "core/raster.h"
#include "params/value_text.h"
#include "render/map2d.h"
#include "render/view3d.h"

#include "app/layers.h"

namespace frana::app {

/// What all maps of one result share. Made from a run or from a result directory alone.
struct MapSource {
    std::string title;               ///< the scene's name
    std::string subtitle;            ///< model, scheme, simulated time
    std::vector<std::string> notes;  ///< figures beside the map
    std::string crs_label;
    double convergence_deg = 0;
    Raster terrain;
    MultiPolygon release;
    MultiPolygon scar;  ///< empty: none
    Size size{1600, 1200};
};

/// A map of one layer. The spec borrows the terrain of `source` and `values`.
render::MapSpec map_spec(const MapSource& source, const Layer& layer, const Raster& values);
/// The same in perspective.
render::ViewSpec view_spec(const MapSource& source, const Layer& layer, const Raster& values);

/// Draws the map NAME ("max_depth") or the view NAME_3d to a PNG. Throws Error.
void draw_layer(const MapSource& source, const Layer& layer, const Raster& values, bool view_3d,
                const std::string& path);

}  // namespace frana::app
