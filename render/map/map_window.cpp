// SPDX-License-Identifier: Apache-2.0
#include "render/map/map_window.h"

#include <algorithm>
#include <optional>

#include "render/canvas/raster_window.h"
#include "render/map/print_scale.h"

namespace frana::render {
namespace {

void include(std::optional<Bounds>& all, const Bounds& one) {
    if (!all) {
        all = one;
        return;
    }
    *all = {std::min(all->west, one.west), std::min(all->south, one.south), std::max(all->east, one.east),
            std::max(all->north, one.north)};
}

/// Moves an interval of fixed length into limits, or to their middle if it is longer.
void keep_within(double& from, double& to, double least, double most) {
    const double length = to - from;
    from = length >= most - least ? (least + most - length) / 2 : std::clamp(from, least, most - length);
    to = from + length;
}

}  // namespace

const GridSpec& map_grid(const MapSpec& spec) {
    return (spec.layer != nullptr ? spec.layer : spec.extent != nullptr ? spec.extent : spec.terrain)->grid;
}

namespace {

/// The flow and the outlines; none without either.
std::optional<Bounds> content(const MapSpec& spec) {
    std::optional<Bounds> shown;
    for (const Raster* raster : {spec.extent, spec.layer}) {
        if (raster == nullptr) continue;
        if (const auto data = data_bounds(*raster)) include(shown, *data);
    }
    for (const Outline& outline : spec.outlines) {
        if (!outline.polygons.empty()) include(shown, bounds(outline.polygons));
    }
    return shown;
}

}  // namespace

Bounds required_window(const MapSpec& spec) {
    if (spec.window) return *spec.window;
    if (const auto shown = content(spec)) return *shown;
    return spec.terrain != nullptr ? spec.terrain->grid.bounds() : map_grid(spec).bounds();
}

Bounds map_window(const MapSpec& spec, int frame_width, int frame_height) {
    const Bounds required = required_window(spec);
    Bounds window = required;
    if (!spec.window && content(spec)) {
        constexpr double k_margin = 0.14, k_least_cells = 20;
        const double side = std::max({window.width(), window.height(), k_least_cells * map_grid(spec).cell_size});
        const double margin = k_margin * side;
        window = {window.west - margin, window.south - margin, window.east + margin, window.north + margin};
    }
    const double aspect = static_cast<double>(frame_width) / frame_height;
    const double width = std::max(window.width(), window.height() * aspect), height = width / aspect;
    const double x = (window.west + window.east) / 2, y = (window.south + window.north) / 2;
    window = {x - width / 2, y - height / 2, x + width / 2, y + height / 2};
    window = window_at_scale(spec.print, required, window, frame_width, frame_height);
    if (!spec.window && spec.terrain != nullptr) {
        const Bounds ground = spec.terrain->grid.bounds();
        keep_within(window.west, window.east, ground.west, ground.east);
        keep_within(window.south, window.north, ground.south, ground.north);
    }
    return window;
}

}  // namespace frana::render
