// SPDX-License-Identifier: Apache-2.0
#include "app/animation.h"

#include <algorithm>
#include <cstdio>

#include "gis/raster_in.h"
#include "render/animation.h"
#include "render/movie.h"

namespace frana::app {
namespace {

/// About eight seconds of film, at a pace that neither stutters nor flies.
double frames_per_second(std::size_t frames) {
    return std::clamp(static_cast<double>(frames) / 8, 4.0, 25.0);
}

std::string time_text(double seconds) {
    char text[40];
    std::snprintf(text, sizeof text, "t = %.1f s", seconds);
    return text;
}

template <class Animator, class Spec>
void film(Spec spec, const std::vector<StoredFrame>& frames, const std::string& path) {
    spec.subtitle = time_text(0);
    spec.legend_title = "Depth";
    Animator animator(spec);
    render::MovieWriter movie(path, spec.width, spec.height, frames_per_second(frames.size()));
    for (const StoredFrame& frame : frames)
        movie.add(animator.frame(gis::read_result_raster(frame.depth_file), time_text(frame.time)));
    movie.finish();
}

}  // namespace

Size film_size(Size map) {
    constexpr int k_widest = 1280;
    if (map.width <= k_widest) return map;
    return {k_widest, std::max(480, map.height * k_widest / map.width)};
}

void write_animation(const MapSource& source, const Raster& max_depth, const std::vector<StoredFrame>& frames,
                     bool view_3d, const std::string& path) {
    Layer layer = layer_named("max_depth");
    layer.title = "Flow depth";
    if (view_3d)
        film<render::ViewAnimator>(view_spec(source, layer, max_depth), frames, path);
    else
        film<render::MapAnimator>(map_spec(source, layer, max_depth), frames, path);
}

}  // namespace frana::app
