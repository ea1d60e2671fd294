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

/// A size for the animation of maps of this size: a animation needs no more pixels than a screen shows (1280 across),
/// and coding them takes time and memory.
Size animation_size(Size map);

/// What a animation shows of one result.
struct AnimationSource {
    MapSource source;
    MapLayer layer;          ///< the greatest values over time: they fix the colours and the window
    std::string layer_file;  ///< where they are, for messages
    std::vector<StoredFrame> frames;
    std::string quantity;  ///< "depth", "velocity" or "particles"
};

/// Of a result, with its frames of "depth", "velocity" or "particles". Throws Error(input) where it has none.
AnimationSource animation_source(const ResultReader& result, const MapSource& source, const std::string& quantity);

/// Frame by frame what a animation shows; 2-D or 3-D, of one result or of two beside each other (with the colours, the
/// window and the camera of both, and of the second the frame nearest in time to the first's).
struct AnimationRequest {
    AnimationSource first;
    std::optional<AnimationSource> second;
    bool view_3d = false;
    bool fly = false;                           ///< 3-D: the camera glides from the flow's top to its front
    Size size;                                  ///< of the whole picture
    std::function<bool()> stop_requested = {};  ///< asked before every frame; empty: never
};

/// The files that a animation of so many frames becomes.
std::vector<std::string> animation_files(const std::string& path, std::size_t frames);
/// Whether a file of this name is one of those in a folder of pictures.
bool is_animation_picture(const std::string& name);

/// Writes the frames of a result as a animation: .mp4 at 25 frames a second (a frame of the result is shown longer
/// where there are few), .gif, or, where `path` ends in '/', PNG files frame_0000.png ... in that folder, which must
/// exist. False where it was stopped on the way: then there is no animation. Throws Error.
bool write_animation(const AnimationRequest& request, const std::string& path);

}  // namespace frana::app
