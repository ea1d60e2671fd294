// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "render/canvas/image.h"
#include "render/libav/functions.h"

namespace frana::render {

/// Loads the encoders of animations when it is first called. Throws Error(environment) if that is not possible.
const LibavFunctions& libav();

/// Writes an animation frame by frame: MP4 (H.264, yuv420p, index in front so that browsers start at once), or an
/// endlessly repeating GIF if the path ends in ".gif". The file is written aside and renamed in finish(); without
/// finish() no file is left.
class MovieWriter {
  public:
    /// Width and height of the images; an MP4 of odd size loses its last column or row, since H.264 needs even ones.
    /// Throws Error(environment) if the file cannot be opened or a codec is missing, Error(input) for another ending or
    /// an invalid size or rate.
    MovieWriter(std::string path, int width, int height, double frames_per_second);
    ~MovieWriter();
    MovieWriter(const MovieWriter&) = delete;
    MovieWriter& operator=(const MovieWriter&) = delete;

    /// Adds a picture, stored once and shown as long as the given number of frames. Throws Error(input) for another
    /// size, Error(environment) if writing fails.
    void add(const Image& image, int frames = 1);

    /// Completes and renames the file. Throws Error(environment), also if no frame was added.
    void finish();

  private:
    class Encoder;
    std::unique_ptr<Encoder> encoder_;
};

}  // namespace frana::render
