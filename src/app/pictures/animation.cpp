// SPDX-License-Identifier: Apache-2.0
#include "app/pictures/animation.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <limits>
#include <type_traits>

#include "analysis/trace.h"
#include "app/pictures/result_reader.h"
#include "app/text/number_text.h"
#include "gis/raster/raster_in.h"
#include "render/animation/animation.h"
#include "render/animation/movie.h"
#include "render/canvas/furniture.h"
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
    return "t = " + words.number(text.data()) + " s";
}

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
    spec.attribution = render::foot_line(
        {scenario_line(animation.source), spec.attribution, render::foot_line(block_lines(animation.source.style))});
    if (const std::string words = pace_words(animation, seconds); !words.empty()) spec.side_notes.push_back(words);
    return spec;
}

template <class Animator, class Spec>
bool animation(const AnimationRequest& request, const std::string& path) {
    const std::vector<StoredFrame>& frames = request.source.frames;
    // A GIF stores the duration of each picture; H.264 players need a constant rate.
    const bool gif = path.ends_with(".gif");
    const double pace = std::clamp(static_cast<double>(frames.size()) / k_animation_seconds, 4.0, k_playback),
                 rate = gif ? pace : k_playback;
    const int repeats = gif ? 1 : std::max(1, static_cast<int>(std::lround(k_playback / pace)));
    render::MovieWriter movie(path, request.size.width, request.size.height, rate);
    const double seconds = static_cast<double>(frames.size()) * repeats / rate;
    Animator animator(animation_spec<Spec>(request.source, request.size, seconds));
    for (const StoredFrame& frame : frames) {
        if (request.stop_requested && request.stop_requested()) return false;
        movie.add(draw_frame(animator, frame, request.source), repeats);
    }
    movie.finish();
    return true;
}

}  // namespace

Size animation_size(Size map) {
    constexpr int k_widest = 1280;
    if (map.width <= k_widest) return map;
    return {k_widest, std::max(480, map.height * k_widest / map.width)};
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
        "frames/" +
        (particles != nullptr ? std::string("particles_*.gpkg, ") + particles->attribute : quantity + "_*.tif");
    return animation;
}

bool write_animation(const AnimationRequest& request, const std::string& path) {
    return request.view_3d ? animation<render::ViewAnimator, render::ViewSpec>(request, path)
                           : animation<render::MapAnimator, render::MapSpec>(request, path);
}

}  // namespace frana::app
