// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/pictures/map_source.h"
#include "app/pictures/result_reader.h"
#include "app/store/frame_store.h"

namespace frana::app {

/// Returns the size of the animation of maps of this size: it needs no more pixels than a screen (1280 across), and
/// encoding them takes time and memory.
Size animation_size(Size map);

/// Input of an animation of one result.
struct AnimationSource {
    MapSource source;
    MapLayer layer;          ///< the greatest values over time: they define the colours and the window
    std::string layer_file;  ///< their file, for messages
    std::vector<StoredFrame> frames;
    std::string quantity;                           ///< "depth", "velocity" or "particles"
    std::vector<std::vector<std::string>> figures;  ///< of the whole flow, of each frame
};

/// Returns the source for a result, with its frames of "depth", "velocity" or "particles". Throws Error(input) if it
/// has none.
AnimationSource animation_source(const ResultReader& result, const MapSource& source, const std::string& quantity);

/// An animation; 2-D or 3-D.
struct AnimationRequest {
    AnimationSource source;
    bool view_3d = false;
    Size size;
    std::function<bool()> stop_requested = {};  ///< polled before every frame; empty: never
};

/// Writes the frames of a result as an animation: .mp4 at 25 frames per second (a frame of the result is shown longer
/// if there are few) or .gif. Returns false if it was stopped before the end: then there is no animation. Throws Error.
bool write_animation(const AnimationRequest& request, const std::string& path);

}  // namespace frana::app
