// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "analysis/runout.h"
#include "app/layers.h"
#include "core/geometry.h"
#include "core/raster.h"
#include "params/value_text.h"
#include "render/map2d.h"
#include "render/view3d.h"

namespace frana::app {

/// Figures that stand on every map of a result.
struct MapFacts {
    std::string model;  ///< as material.model
    std::string scheme;
    double simulated_seconds = 0;
    double volume = 0;        ///< released [m3]
    double volume_left = 0;   ///< that left the computed ground [m3]
    double last_speed = 0;    ///< greatest speed at the end [m/s]
    double covered_area = 0;  ///< [m2]
    double threshold = 0;     ///< depth that counts as covered [m]
    Runout run_out;
};

std::string map_subtitle(const MapFacts& facts);
std::vector<std::string> map_notes(const MapFacts& facts);

/// Whether a flow whose fastest part moves so fast must be called moving [m/s].
inline constexpr double k_moving_speed = 0.1;

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
