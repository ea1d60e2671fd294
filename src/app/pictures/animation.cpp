// SPDX-License-Identifier: Apache-2.0
#include "app/pictures/animation.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <limits>
#include <type_traits>

#include "app/pictures/result_reader.h"
#include "gis/raster/raster_in.h"
#include "render/animation/animation.h"
#include "render/animation/movie.h"
#include "render/canvas/furniture.h"
#include "render/canvas/image.h"

namespace frana::app {
namespace {

constexpr int k_playback = 25;         // pictures per second
constexpr int k_most_pictures = 200;   // of a film: eight seconds, neither jerky nor too fast
constexpr int k_most_for_a_frame = 6;  // of few frames: a quarter of a second each, on average

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

Raster read_frame(const AnimationSource& of, const StoredFrame& frame) {
    const std::string file = frame.raster_file(of.quantity);
    Raster values = gis::read_result_raster(file);
    require_cells(values.grid, file, of.layer.values.grid, of.layer_file);
    return values;
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
    return animator.frame(read_frame(of, frame), subtitle);
}

/// How many pictures of the film each frame is. The film's time is the volume that moves to other cells, so that a rest
/// takes no time and the film ends with the motion.
std::vector<int> pace_of(const AnimationSource& of) {
    std::vector<double> moved;
    for (const StoredFrame& frame : of.frames) moved.push_back(frame.moved);
    return pictures_of_frames(moved, std::min(k_most_pictures, k_most_for_a_frame * static_cast<int>(moved.size())));
}

/// Returns a picture of the animation's layer: a MapSpec or a ViewSpec.
template <class Spec>
Spec animation_spec(const AnimationSource& animation) {
    Spec spec;
    if constexpr (std::is_same_v<Spec, render::MapSpec>)
        spec = unprinted(map_spec(animation.source, animation.layer));
    else
        spec = view_spec(animation.source, animation.layer);
    // In place of the title block: the films' pages have no room beside the title.
    spec.attribution = render::foot_line(
        {scenario_line(animation.source), spec.attribution, render::foot_line(block_lines(animation.source.style))});
    return spec;
}

template <class Animator, class Spec>
bool animation(const AnimationRequest& request, const std::string& path) {
    const std::vector<StoredFrame>& frames = request.source.frames;
    std::vector<int> pictures = pace_of(request.source);
    if (path.ends_with(".gif")) pictures.back() += k_playback;  // before it begins again
    const Spec spec = animation_spec<Spec>(request.source);
    render::MovieWriter movie(path, spec.width, spec.height, k_playback);
    Animator animator(spec);
    for (std::size_t i = 0; i < frames.size(); ++i) {
        if (request.stop_requested && request.stop_requested()) return false;
        if (pictures[i] > 0) movie.add(draw_frame(animator, frames[i], request.source), pictures[i]);
    }
    movie.finish();
    return true;
}

}  // namespace

std::vector<int> pictures_of_frames(const std::vector<double>& moved, int pictures) {
    std::vector<int> counts(moved.size());
    const auto place = [&](std::size_t frame) {
        return moved.back() > 0 ? static_cast<int>(std::lround(moved[frame] / moved.back() * (pictures - 1))) : 0;
    };
    for (std::size_t i = 0; i + 1 < moved.size(); ++i) counts[i] = place(i + 1) - place(i);
    counts.back() = 1;
    return counts;
}

Size animation_size(Size map) {
    constexpr int k_widest = 1280;
    if (map.width <= k_widest) return map;
    return {k_widest, std::max(480, map.height * k_widest / map.width), 0, "", map.turns};
}

AnimationSource animation_source(const ResultReader& result, const MapSource& source, const std::string& quantity,
                                 Size size) {
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
    animation.source.style.size = size;
    animation.source.longitude_latitude = longitude_latitude(animation.layer.values.grid.crs_wkt);  // of its own thread
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
