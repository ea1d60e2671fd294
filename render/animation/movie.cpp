// SPDX-License-Identifier: Apache-2.0
#include "render/animation/movie.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <utility>

#include "core/error.h"
#include "core/files.h"
#include "core/module.h"
#include "render/animation/gif_palette.h"

namespace frana::render {

const LibavFunctions& libav() {
    static const auto& functions = module_table<LibavFunctions>("libav");
    return functions;
}

namespace {

bool is_gif(const std::string& path) {
    std::string ending = std::filesystem::path(path).extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
    if (ending == ".mp4" || ending == ".gif") return ending == ".gif";
    throw Error(ErrorKind::input, Problem{"unknown kind of animation", path, ending, ".mp4 or .gif", ""});
}

}  // namespace

class MovieWriter::Encoder {
  public:
    Encoder(std::string path, int width, int height, double frames_per_second)
        : file_(std::move(path)), movie_{file_.partial_path(), file_.path(), is_gif(file_.path()), width, height,
                                         frames_per_second} {
        if (width < 2 || height < 2 || !(frames_per_second > 0) || frames_per_second > 1000) {
            throw Error(ErrorKind::input,
                        Problem{"an animation's size or rate is out of range", file_.path(),
                                std::to_string(width) + " x " + std::to_string(height) + " at " +
                                    std::to_string(frames_per_second) + " frames per second",
                                "at least 2 x 2 pixels, over 0 and up to 1000 frames per second", ""});
        }
        encoder_ = call_module([&] { return libav().encoder(movie_); });
    }

    void add(const Image& image, int frames) {
        if (image.width != movie_.width || image.height != movie_.height) {
            throw Error(ErrorKind::input,
                        Problem{"an animation's pictures must all have its size", file_.path(),
                                std::to_string(image.width) + " x " + std::to_string(image.height),
                                std::to_string(movie_.width) + " x " + std::to_string(movie_.height), ""});
        }
        if (movie_.gif) {
            const IndexedImage reduced = reduce_colours(image);
            call_module([&] { encoder_->add(reduced.colours, reduced.indices, frames); });
        } else {
            call_module([&] { encoder_->add(image.rgb, frames); });
        }
    }

    void finish() {
        call_module([&] { encoder_->finish(); });
        file_.rename_into_place();
    }

  private:
    FileAside file_;
    MovieFile movie_;
    std::unique_ptr<MovieEncoder> encoder_;
};

MovieWriter::MovieWriter(std::string path, int width, int height, double frames_per_second)
    : encoder_(std::make_unique<Encoder>(std::move(path), width, height, frames_per_second)) {}
MovieWriter::~MovieWriter() = default;

void MovieWriter::add(const Image& image, int frames) {
    encoder_->add(image, frames);
}

void MovieWriter::finish() {
    encoder_->finish();
}

}  // namespace frana::render
