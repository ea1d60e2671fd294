// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/colour.h"

namespace frana::render {

struct MovieFile {
    std::string file;  ///< to be written
    std::string name;  ///< for messages
    bool gif = false;  ///< else MP4
    int width = 0, height = 0;
    double frames_per_second = 0;
};

/// An animation being written. Used by one thread at a time. Throws ModuleFailure.
class MovieEncoder {
  public:
    MovieEncoder() = default;
    virtual ~MovieEncoder() = default;
    MovieEncoder(const MovieEncoder&) = delete;
    MovieEncoder& operator=(const MovieEncoder&) = delete;

    /// Adds a picture to an MP4, shown as long as this many frames: three bytes a pixel, row by row from the top.
    virtual void add(const std::vector<std::uint8_t>& rgb, int frames) = 0;
    /// Adds a picture to a GIF: at most 255 colours and the number of one for each pixel.
    virtual void add(const std::vector<Rgb>& colours, const std::vector<std::uint8_t>& indices, int frames) = 0;
    /// Completes and closes the file.
    virtual void finish() = 0;
};

/// All that frana takes from FFmpeg's libav, as functions of the module `libav`: the files of this folder are linked to
/// it alone, and of frana they use only types that headers define completely. They throw ModuleFailure (call_module).
struct LibavFunctions {
    std::unique_ptr<MovieEncoder> (*encoder)(const MovieFile& movie);
};

}  // namespace frana::render
