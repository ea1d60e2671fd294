// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "render/canvas/image.h"

namespace frana::render {

/// Writes a animation frame by frame: MP4 (H.264, yuv420p, index in front so that browsers start at once), or an
/// endlessly repeating GIF when the path ends in ".gif". The file is written aside and takes its name in
/// finish(); without finish() nothing is left behind.
class MovieWriter {
  public:
    /// Width and height as the images will have them; an MP4 of odd size loses its last column or row, since
    /// H.264 needs even ones. Throws Error(environment) when the file cannot be opened or a codec is missing,
    /// Error(input) for another ending or a senseless size or rate.
    MovieWriter(std::string path, int width, int height, double frames_per_second);
    ~MovieWriter();
    MovieWriter(const MovieWriter&) = delete;
    MovieWriter& operator=(const MovieWriter&) = delete;

    /// Adds a picture as so many frames. Throws Error(input) for another size, Error(environment) when writing fails.
    void add(const Image& image, int frames = 1);

    /// Completes the file and gives it its name. Throws Error(environment), also when no frame was added.
    void finish();

  private:
    class Encoder;
    std::unique_ptr<Encoder> encoder_;
};

}  // namespace frana::render
