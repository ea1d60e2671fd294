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
AnimationSource animation_source(const ResultReader& result, const MapSource& source, const std::string& quantity,
                                 Size size);

/// Returns how many pictures of a film each frame is, in proportion to what moves until the next one; the last is one.
/// @param moved volume that has moved up to each frame, rising
/// @param pictures all together, if anything moves
std::vector<int> pictures_of_frames(const std::vector<double>& moved, int pictures);

/// An animation; 2-D or 3-D.
struct AnimationRequest {
    AnimationSource source;
    bool view_3d = false;
    std::function<bool()> stop_requested = {};  ///< polled before every frame; empty: never
};

/// Writes the frames of a result as an animation at 25 pictures per second, .mp4 or .gif, paced by the motion: the same
/// volume moves to other cells in every second, and frames between which nothing visible moves are left out. Returns
/// false if it was stopped before the end: then there is no animation. Throws Error.
bool write_animation(const AnimationRequest& request, const std::string& path);

}  // namespace frana::app
