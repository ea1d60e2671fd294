// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <vector>

#include "facade/frana.h"

namespace frana::test {

inline constexpr facade::Grid k_small_grid{.west = 600000, .north = 5000120, .cell_size = 4, .rows = 30, .columns = 60};

/// A slope that ends in a plain.
inline std::vector<double> small_slope() {
    std::vector<double> z;
    for (std::int64_t row = 0; row < k_small_grid.rows; ++row)
        for (std::int64_t column = 0; column < k_small_grid.columns; ++column)
            z.push_back(100 + std::max(0.0, 0.5 * (120 - 4.0 * static_cast<double>(column))));
    return z;
}

inline facade::Ring square(double west, double south, double side) {
    return {{west, south}, {west + side, south}, {west + side, south + side}, {west, south + side}};
}

/// 2 m on 1600 m2 of it. Refers to the elevations.
inline facade::Scene small_scene(const std::vector<double>& elevations) {
    facade::Scene scene(k_small_grid, {elevations});
    scene.set("material.friction-coefficient", 0.3);
    scene.set("time.end", 8);
    scene.set("time.frame-interval", 2);
    scene.add_release({.outline = {{square(600020, 5000040, 40)}}, .thickness = 2, .name = "upper"});
    return scene;
}

}  // namespace frana::test
