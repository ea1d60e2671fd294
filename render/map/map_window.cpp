// SPDX-License-Identifier: Apache-2.0
#include "render/map/map_window.h"

#include <algorithm>
#include <optional>

#include "render/canvas/raster_window.h"

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

Bounds map_window(const MapSpec& spec, double aspect) {
    std::optional<Bounds> shown = spec.window;
    if (!shown) {
        for (const Raster* raster : {spec.extent, spec.layer}) {
            if (raster == nullptr) continue;
            if (const auto data = data_bounds(*raster)) include(shown, *data);
        }
        for (const Outline& outline : spec.outlines) {
            if (!outline.polygons.empty()) include(shown, bounds(outline.polygons));
        }
        const GridSpec& grid = map_grid(spec);
        if (shown) {
            constexpr double k_margin = 0.14, k_least_cells = 20;
            const double side = std::max({shown->width(), shown->height(), k_least_cells * grid.cell_size});
            const double margin = k_margin * side;
            *shown = {shown->west - margin, shown->south - margin, shown->east + margin, shown->north + margin};
        } else {
            shown = spec.terrain != nullptr ? spec.terrain->grid.bounds() : grid.bounds();
        }
    }
    Bounds window = *shown;
    const double width = std::max(window.width(), window.height() * aspect), height = width / aspect;
    const double x = (window.west + window.east) / 2, y = (window.south + window.north) / 2;
    window = {x - width / 2, y - height / 2, x + width / 2, y + height / 2};
    if (!spec.window && spec.terrain != nullptr) {
        const Bounds ground = spec.terrain->grid.bounds();
        keep_within(window.west, window.east, ground.west, ground.east);
        keep_within(window.south, window.north, ground.south, ground.north);
    }
    return window;
}

}  // namespace frana::render
