// SPDX-License-Identifier: Apache-2.0
#include "render/animation/movie.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <span>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/files.h"
#include "core/module.h"
#include "render/canvas/image.h"

namespace frana::render {

/// A picture reduced to at most 255 colours: the limit of a GIF frame besides the transparent one.
struct IndexedImage {
    std::vector<Rgb> colours;
    std::vector<std::uint8_t> indices;  ///< one per pixel
};

namespace {

constexpr std::size_t k_most_colours = 255;
constexpr unsigned k_bits = 5;  ///< kept of each channel while counting: cells of 8 levels are indistinguishable
constexpr std::size_t k_cells = std::size_t{1} << (3 * k_bits);

/// Pixels of similar colour, and the sum of their colours.
struct Cell {
    std::uint64_t count = 0;
    std::array<std::uint64_t, 3> sum{};
    std::uint16_t key = 0;

    [[nodiscard]] double mean(std::size_t channel) const {
        return static_cast<double>(sum[channel]) / static_cast<double>(count);
    }
};

std::uint16_t key_of(const std::uint8_t* p) {
    constexpr unsigned k_drop = 8 - k_bits;
    return static_cast<std::uint16_t>((unsigned{p[0]} >> k_drop) << (2 * k_bits) |
                                      (unsigned{p[1]} >> k_drop) << k_bits | unsigned{p[2]} >> k_drop);
}

/// A part of the colour cells and the error of representing them by one colour.
struct Box {
    std::span<Cell> cells;
    std::size_t widest = 0;
    double error = 0;
};

Box measured(std::span<Cell> cells) {
    Box box{cells, 0, 0};
    if (cells.size() < 2) return box;
    double worst = -1;
    for (std::size_t channel = 0; channel < 3; ++channel) {
        double weight = 0, sum = 0, squares = 0;
        for (const Cell& cell : cells) {
            const auto count = static_cast<double>(cell.count);
            weight += count;
            sum += count * cell.mean(channel);
            squares += count * cell.mean(channel) * cell.mean(channel);
        }
        const double variance = squares - sum * sum / weight;
        box.error += variance;
        if (variance > worst) {
            worst = variance;
            box.widest = channel;
        }
    }
    return box;
}

/// Chooses colours by dividing the picture's range of colours at medians; a picture of few colours keeps them exactly.
IndexedImage reduce_colours(const Image& image) {
    std::vector<Cell> all(k_cells);
    const std::size_t n_pixels = image.rgb.size() / 3;
    for (std::size_t i = 0; i < n_pixels; ++i) {
        const std::uint8_t* p = image.rgb.data() + 3 * i;
        Cell& cell = all[key_of(p)];
        ++cell.count;
        for (std::size_t channel = 0; channel < 3; ++channel) cell.sum[channel] += p[channel];
    }
    std::vector<Cell> used;
    for (std::size_t key = 0; key < k_cells; ++key) {
        if (all[key].count == 0) continue;
        used.push_back(all[key]);
        used.back().key = static_cast<std::uint16_t>(key);
    }
    std::vector<Box> boxes;
    if (!used.empty()) boxes.push_back(measured(used));
    while (boxes.size() < k_most_colours) {
        const auto worst =
            std::max_element(boxes.begin(), boxes.end(), [](const Box& a, const Box& b) { return a.error < b.error; });
        if (worst == boxes.end() || worst->cells.size() < 2 || worst->error <= 0) break;
        const std::span<Cell> cells = worst->cells;
        const std::size_t channel = worst->widest;
        std::sort(cells.begin(), cells.end(), [channel](const Cell& a, const Cell& b) {
            return a.mean(channel) != b.mean(channel) ? a.mean(channel) < b.mean(channel) : a.key < b.key;
        });
        std::uint64_t total = 0, half = 0;
        for (const Cell& cell : cells) total += cell.count;
        std::size_t cut = 0;
        while (cut + 1 < cells.size() && (cut == 0 || half + cells[cut].count <= total / 2)) half += cells[cut++].count;
        *worst = measured(cells.first(cut));
        boxes.push_back(measured(cells.subspan(cut)));
    }

    IndexedImage result;
    std::vector<std::uint8_t> index_of(k_cells);
    for (const Box& box : boxes) {
        Cell sum;
        for (const Cell& cell : box.cells) {
            sum.count += cell.count;
            for (std::size_t channel = 0; channel < 3; ++channel) sum.sum[channel] += cell.sum[channel];
            index_of[cell.key] = static_cast<std::uint8_t>(result.colours.size());
        }
        result.colours.push_back({static_cast<std::uint8_t>(std::lround(sum.mean(0))),
                                  static_cast<std::uint8_t>(std::lround(sum.mean(1))),
                                  static_cast<std::uint8_t>(std::lround(sum.mean(2)))});
    }
    result.indices.resize(n_pixels);
    for (std::size_t i = 0; i < n_pixels; ++i) result.indices[i] = index_of[key_of(image.rgb.data() + 3 * i)];
    return result;
}

}  // namespace

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
