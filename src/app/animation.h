// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "app/frame_store.h"
#include "app/map_source.h"

namespace frana::app {

/// A size for the film of maps of this size: a film needs no more pixels than a screen shows (1280 across),
/// and coding them takes time and memory.
Size film_size(Size map);

/// Writes the frames of a result as a film (.mp4 or .gif) of the depth, on the map or in perspective, with
/// the colour scale of the maximum depth throughout. Throws Error.
void write_animation(const MapSource& source, const Raster& max_depth, const std::vector<StoredFrame>& frames,
                     bool view_3d, const std::string& path);

}  // namespace frana::app
