// SPDX-License-Identifier: Apache-2.0
#include "app/pictures/particle_dots.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/error.h"
#include "gis/vector/particles_in.h"

namespace frana::app {

const ParticleQuantity* find_particle_quantity(const std::string& name) {
    static constexpr ParticleQuantity k_all[] = {
        {"particles", "speed_ms", "velocity", worded("Speed of particles")},
        {"particle_cohesion", "cohesion_ratio", "cohesion_ratio", worded("Cohesion left of particles")}};
    const auto* const found =
        std::find_if(std::begin(k_all), std::end(k_all), [&](const ParticleQuantity& q) { return name == q.name; });
    return found == std::end(k_all) ? nullptr : found;
}

render::Dots read_particle_dots(const std::string& path, const ParticleQuantity& quantity) {
    if (!std::filesystem::exists(path)) {
        throw Error(ErrorKind::input,
                    Problem{"the result has no particles at this time", path, "", "",
                            "Run the scene with particles-gpkg among output.formats and output.frames = on"});
    }
    const gis::ValuedPoints points =
        gis::read_valued_points(path, {quantity.attribute, "depth_m", "volume_m3"}, "particles");
    const auto &values = points.columns[0], &depths = points.columns[1], &volumes = points.columns[2];
    render::Dots dots;
    double area = 0;
    for (std::size_t i = 0; i < points.places.size(); ++i) {
        dots.dots.push_back({points.places[i], depths[i], values[i]});
        if (depths[i] > 0) area += volumes[i] / depths[i];
    }
    std::stable_sort(dots.dots.begin(), dots.dots.end(),
                     [](const render::Dot& a, const render::Dot& b) { return a.value < b.value; });
    constexpr double k_apart = 0.85;  // of the distance between particles: they remain separate
    if (!dots.dots.empty()) dots.width_m = k_apart * std::sqrt(area / static_cast<double>(dots.dots.size()));
    return dots;
}

}  // namespace frana::app
