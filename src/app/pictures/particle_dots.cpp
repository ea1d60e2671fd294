// SPDX-License-Identifier: Apache-2.0
#include "app/pictures/particle_dots.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/error.h"
#include "gis/vector/particles_in.h"

namespace frana::app {

render::Dots read_particle_dots(const std::string& path) {
    if (!std::filesystem::exists(path)) {
        throw Error(ErrorKind::input,
                    Problem{"the result has no particles at this time", path, "", "",
                            "Run the scene with particles-gpkg among output.formats and output.frames = on"});
    }
    const gis::ValuedPoints points = gis::read_valued_points(path, {"speed_ms", "depth_m", "volume_m3"}, "particles");
    const auto &speeds = points.columns[0], &depths = points.columns[1], &volumes = points.columns[2];
    render::Dots dots;
    double area = 0;
    for (std::size_t i = 0; i < points.places.size(); ++i) {
        dots.dots.push_back({points.places[i], depths[i], speeds[i]});
        if (depths[i] > 0) area += volumes[i] / depths[i];
    }
    std::stable_sort(dots.dots.begin(), dots.dots.end(),
                     [](const render::Dot& a, const render::Dot& b) { return a.value < b.value; });
    constexpr double k_apart = 0.85;  // of the distance between particles: they remain separate
    if (!dots.dots.empty()) dots.width_m = k_apart * std::sqrt(area / static_cast<double>(dots.dots.size()));
    return dots;
}

}  // namespace frana::app
