// SPDX-License-Identifier: Apache-2.0
#include "app/map_source.h"

#include "analysis/trace.h"
#include "app/number_text.h"
#include "app/version.h"

namespace frana::app {
namespace {

// Release and scar must be told apart from each other and from every palette: black dashes, bright cyan.
constexpr Rgb k_release_colour{20, 20, 20};
constexpr Rgb k_scar_colour{0, 160, 220};

std::vector<render::Outline> outlines_of(const MapSource& source) {
    std::vector<render::Outline> outlines;
    if (!source.release.empty()) outlines.push_back({"Release", source.release, k_release_colour, 2.5, true});
    if (!source.scar.empty()) outlines.push_back({"Surveyed scar", source.scar, k_scar_colour, 3, false});
    return outlines;
}

/// Map and view have the same furniture.
template <class Spec>
Spec furnished(const MapSource& source, const Layer& layer, const Raster& values) {
    Spec spec;
    spec.title = source.title + ": " + layer.title;
    spec.subtitle = source.subtitle;
    spec.legend_title = layer.title;
    spec.unit = layer.unit;
    spec.attribution = std::string("Simulated with ") + k_program + " " + k_version;
    spec.palette = layer.palette;
    spec.classes = layer_classes(layer, maximum(values));
    spec.terrain = &source.terrain;
    spec.layer = &values;
    spec.outlines = outlines_of(source);
    spec.side_notes = source.notes;
    spec.convergence_deg = source.convergence_deg;
    spec.crs_label = source.crs_label;
    spec.width = source.size.width;
    spec.height = source.size.height;
    return spec;
}

}  // namespace

std::string map_subtitle(const MapFacts& facts) {
    const std::string model =
        facts.model == "structured" ? "Structured model" : "Voellmy-Bingham, scheme " + facts.scheme;
    return model + ", " + figure(facts.simulated_seconds, 3) + " s simulated";
}

std::vector<std::string> map_notes(const MapFacts& facts) {
    std::vector<std::string> notes{
        "Volume " + grouped(facts.volume) + " m³",
        "Covered " + grouped(facts.covered_area) + " m²",
        "(deeper than " + figure(facts.threshold, 3) + " m)",
        "Run-out " + grouped(facts.run_out.horizontal_m) + " m",
        "Drop " + grouped(facts.run_out.drop_m) + " m",
        "Angle of reach " + figure(facts.run_out.reach_angle_deg, 3) + "°",
    };
    // A map that is not the whole story says so itself: it travels without its log.
    if (facts.last_speed > k_moving_speed) notes.emplace_back("Still moving at the end");
    if (facts.volume_left > 0) notes.push_back(grouped(facts.volume_left) + " m³ left the map");
    return notes;
}

render::MapSpec map_spec(const MapSource& source, const Layer& layer, const Raster& values) {
    return furnished<render::MapSpec>(source, layer, values);
}

render::ViewSpec view_spec(const MapSource& source, const Layer& layer, const Raster& values) {
    return furnished<render::ViewSpec>(source, layer, values);
}

void draw_layer(const MapSource& source, const Layer& layer, const Raster& values, bool view_3d,
                const std::string& path) {
    const render::Image image = view_3d ? render::draw_view(view_spec(source, layer, values))
                                        : render::draw_map(map_spec(source, layer, values));
    render::write_png(path, image);
}

}  // namespace frana::app
