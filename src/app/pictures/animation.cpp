// SPDX-License-Identifier: Apache-2.0
#include "app/pictures/animation.h"

#include <fnmatch.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>
#include <type_traits>

#include "analysis/trace.h"
#include "app/pictures/result_reader.h"
#include "app/text/number_text.h"
#include "gis/raster/raster_in.h"
#include "render/animation/animation.h"
#include "render/animation/movie.h"
#include "render/canvas/image.h"

namespace frana::app {
namespace {

constexpr double k_animation_seconds = 8;  // approximate length: neither jerky nor too fast
constexpr double k_playback = 25;          // frames per second

/// Returns the number of decimals that distinguish frames, at least one.
int time_decimals(const std::vector<StoredFrame>& frames) {
    double gap = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < frames.size(); ++i) gap = std::min(gap, frames[i].time - frames[i - 1].time);
    return gap > 0 && gap < 1 ? std::min(6, 1 + static_cast<int>(std::ceil(-std::log10(gap)))) : 1;
}

std::string time_text(double seconds, int decimals, const Words& words) {
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), "%.*f", decimals, seconds);
    return words("t = {1} s", {words.number(text.data())});
}

std::string picture_name(std::size_t frame) {
    std::array<char, 32> name{};
    std::snprintf(name.data(), name.size(), "frame_%04zu.png", frame);
    return name.data();
}

/// An animation file, or a folder of pictures.
class AnimationOut {
  public:
    AnimationOut(const std::string& path, Size size, std::size_t frames) : path_(path) {
        if (path.ends_with('/')) return;
        // A GIF stores the duration of each picture; H.264 players need a constant rate.
        const bool gif = path.ends_with(".gif");
        const double pace = std::clamp(static_cast<double>(frames) / k_animation_seconds, 4.0, k_playback);
        repeats_ = gif ? 1 : std::max(1, static_cast<int>(std::lround(k_playback / pace)));
        movie_ = std::make_unique<render::MovieWriter>(path, size.width, size.height, gif ? pace : k_playback);
        seconds_ = static_cast<double>(frames) * repeats_ / (gif ? pace : k_playback);
    }
    [[nodiscard]] double seconds() const noexcept { return seconds_; }  ///< of playback; 0: a folder
    void add(const render::Image& image) {
        if (!movie_) {
            render::write_png(path_ + picture_name(count_++), image);
            return;
        }
        movie_->add(image, repeats_);
    }
    void finish() {
        if (movie_) movie_->finish();
    }

  private:
    std::string path_;
    std::unique_ptr<render::MovieWriter> movie_;
    int repeats_ = 1;
    std::size_t count_ = 0;
    double seconds_ = 0;
};

std::string lower_case_first(std::string words) {
    if (!words.empty()) words[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(words[0])));
    return words;
}

/// Draws a frame's particles or raster. `frame` is one of the source's.
template <class Animator>
render::Image draw_frame(Animator& animator, const StoredFrame& frame, const AnimationSource& of) {
    std::string subtitle = time_text(frame.time, time_decimals(of.frames), of.source.style.words);
    const bool has_small_nouns = of.source.style.words.language() != Language::german;
    for (const std::string& one : of.figures[static_cast<std::size_t>(&frame - of.frames.data())])
        subtitle += '\n' + (has_small_nouns ? lower_case_first(one) : one);
    if (const ParticleQuantity* const of_particles = find_particle_quantity(of.quantity))
        return animator.frame(read_particle_dots(frame.particle_file, *of_particles), subtitle);
    const std::string file = frame.raster_file(of.quantity);
    const Raster values = gis::read_result_raster(file);
    require_cells(values.grid, file, of.layer.values.grid, of.layer_file);
    return animator.frame(values, subtitle);
}

/// Returns the frame nearest to a time: those of two runs differ by up to a step although the same times were
/// requested.
const StoredFrame& frame_at(const std::vector<StoredFrame>& frames, double time) {
    return *std::min_element(frames.begin(), frames.end(), [&](const StoredFrame& a, const StoredFrame& b) {
        return std::abs(a.time - time) < std::abs(b.time - time);
    });
}

std::string pace_words(const AnimationSource& animation, double seconds) {
    const double simulated = animation.frames.back().time - animation.frames.front().time;
    if (!(seconds > 0) || !(simulated > 0)) return {};
    const Words& words = animation.source.style.words;
    return words("1 s of playback: {1} s", {words.number(number_text(simulated / seconds, 2))});
}

/// Returns a picture of the animation's layer at its size, with its pace: a MapSpec or a ViewSpec.
template <class Spec>
Spec animation_spec(const AnimationSource& animation, Size size, double seconds) {
    Spec spec;
    if constexpr (std::is_same_v<Spec, render::MapSpec>)
        spec = unprinted(map_spec(animation.source, animation.layer));
    else
        spec = view_spec(animation.source, animation.layer);
    spec.width = size.width;
    spec.height = size.height;
    // In place of the title block: the films' pages have no room beside the title.
    spec.attribution =
        foot_line({scenario_line(animation.source), spec.attribution, foot_line(block_lines(animation.source.style))});
    if (const std::string words = pace_words(animation, seconds); !words.empty()) spec.side_notes.push_back(words);
    return spec;
}

/// Gives two results a common scale and terrain.
void use_common_scale(render::MapSpec& a, render::MapSpec& b, const MapLayer& greater) {
    a.classes = b.classes = greater.classes;
    const auto left = render::data_bounds(*a.layer), right = render::data_bounds(*b.layer);
    if (!left || !right) return;
    Bounds both{std::min(left->west, right->west), std::min(left->south, right->south),
                std::max(left->east, right->east), std::max(left->north, right->north)};
    const double margin = 0.14 * std::max(both.width(), both.height());
    both = {both.west - margin, both.south - margin, both.east + margin, both.north + margin};
    a.window = b.window = both;
}

void use_common_scale(render::ViewSpec& a, render::ViewSpec& b, const MapLayer& greater) {
    a.classes = b.classes = greater.classes;
    render::ViewLayout layout;
    render::draw_view(a, &layout);
    a.camera = b.camera = layout.camera;
}

void beside(render::Image& page, const render::Image& part, int left) {
    for (int row = 0; row < part.height; ++row)
        std::copy_n(part.pixel(0, row), 3 * static_cast<std::size_t>(part.width), page.pixel(left, row));
}

template <class Animator, class Spec>
bool animation(const AnimationRequest& request, const std::string& path) {
    const std::vector<StoredFrame>& frames = request.first.frames;
    AnimationOut out(path, request.size, frames.size());
    const Size half{request.second ? request.size.width / 2 : request.size.width, request.size.height};
    Spec left = animation_spec<Spec>(request.first, half, out.seconds());
    std::optional<Animator> right;
    if (request.second) {
        Spec other =
            animation_spec<Spec>(*request.second, {request.size.width - half.width, half.height}, out.seconds());
        const bool first_greater = maximum(request.first.layer.values) >= maximum(request.second->layer.values);
        use_common_scale(left, other, first_greater ? request.first.layer : request.second->layer);
        right.emplace(other);
    }
    Animator animator(left);
    [[maybe_unused]] double along = 0;  // from the flight's start to its end
    for (const StoredFrame& frame : frames) {
        if (request.stop_requested && request.stop_requested()) return false;
        if constexpr (std::is_same_v<Animator, render::ViewAnimator>) {
            if (request.fly) animator.fly(along);
            along += 1 / static_cast<double>(std::max<std::size_t>(1, frames.size() - 1));
        }
        const render::Image picture = draw_frame(animator, frame, request.first);
        if (!right) {
            out.add(picture);
            continue;
        }
        render::Image page(request.size.width, request.size.height);
        beside(page, picture, 0);
        const StoredFrame& other = frame_at(request.second->frames, frame.time);
        beside(page, draw_frame(*right, other, *request.second), half.width);
        out.add(page);
    }
    out.finish();
    return true;
}

}  // namespace

Size animation_size(Size map) {
    constexpr int k_widest = 1280;
    if (map.width <= k_widest) return map;
    return {k_widest, std::max(480, map.height * k_widest / map.width)};
}

std::vector<std::string> animation_files(const std::string& path, std::size_t frames) {
    if (!path.ends_with('/')) return {path};
    std::vector<std::string> files;
    for (std::size_t i = 0; i < frames; ++i) files.push_back(path + picture_name(i));
    return files;
}

bool is_animation_picture(const std::string& name) {
    return ::fnmatch("frame_*.png", name.c_str(), 0) == 0;
}

AnimationSource animation_source(const ResultReader& result, const MapSource& source, const std::string& quantity) {
    const ParticleQuantity* const particles = find_particle_quantity(quantity);
    const std::string colours = particles != nullptr ? particles->colours : quantity;
    const std::string greatest = "max_" + colours + ".tif";
    AnimationSource animation{
        source,
        result.greatest(colours),
        result.has(greatest) ? result.path(greatest) : result.frames().front().raster_file(colours),
        result.frames(),
        quantity,
        {}};
    std::vector<double> times;
    for (const StoredFrame& frame : animation.frames) times.push_back(frame.time);
    animation.figures = result.figures_at(times);
    animation.source.notes.clear();  // those of the end
    if (particles != nullptr) {
        animation.layer.title = source.style.words(particles->title);
        open_above(animation.layer);
    } else if (quantity == "depth" || quantity == "velocity") {
        const bool is_depth = quantity == "depth";
        std::string& legend = animation.layer.legend_title;  // "Maximum depth, vertical"
        const std::string direction =
            !legend.starts_with(animation.layer.title) ? "" : legend.substr(animation.layer.title.size());
        animation.layer.title = source.style.words(is_depth ? worded("Flow depth") : worded("Flow velocity"));
        legend = animation.layer.title + direction;
    }
    animation.layer.source =
        "frames/" + (particles != nullptr ? std::string("particles_*.gpkg, ") + particles->attribute
                                          : source.style.words("{1}, band {2}", {quantity + "_*.tif", "1"}));
    return animation;
}

bool write_animation(const AnimationRequest& request, const std::string& path) {
    return request.view_3d ? animation<render::ViewAnimator, render::ViewSpec>(request, path)
                           : animation<render::MapAnimator, render::MapSpec>(request, path);
}

}  // namespace frana::app
