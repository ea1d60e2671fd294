// SPDX-License-Identifier: Apache-2.0
#include "analysis/friction_table.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>
#include <utility>

namespace frana {
namespace {

constexpr double k_least_square_of_slope = 0.01;  // NAKSIN's bound

/// The same class, with values between those of two classes of terrain.
FrictionPair between(const FrictionPair& a, const FrictionPair& b, double weight_of_b) {
    return {a.coefficient + weight_of_b * (b.coefficient - a.coefficient),
            1 / (1 / a.turbulence + weight_of_b * (1 / b.turbulence - 1 / a.turbulence))};
}

}  // namespace

std::size_t class_between(const std::vector<double>& limits, double value) {
    return static_cast<std::size_t>(std::upper_bound(limits.begin(), limits.end(), value) - limits.begin());
}

std::size_t FrictionChoice::volume_class() const {
    return class_between(table.volumes, volume);
}

std::optional<std::size_t> FrictionChoice::close_class() const {
    for (const double factor : {0.95, 1.05})
        if (const std::size_t other = class_between(table.volumes, factor * volume); other != volume_class())
            return other;
    return std::nullopt;
}

FrictionPair FrictionChoice::at(std::size_t kind, std::size_t band, bool forest) const {
    FrictionPair pair = table.at(period, volume_class(), kind, band);
    if (forest && table.forest) pair = {pair.coefficient + table.forest->more_friction, table.forest->turbulence};
    return {friction_factor * pair.coefficient, turbulence_factor * pair.turbulence};
}

GroundShape ground_shape(const Raster& terrain, std::int64_t row, std::int64_t column, std::int64_t step) {
    const GridSpec& grid = terrain.grid;
    if (row < step || column < step || row + step >= grid.rows || column + step >= grid.columns) return {};
    // Eastwards and northwards: z[j][i] with j from the south.
    double z[3][3];  // NOLINT(modernize-avoid-c-arrays)
    for (std::int64_t j = 0; j < 3; ++j)
        for (std::int64_t i = 0; i < 3; ++i) {
            z[j][i] = terrain.at(row - (j - 1) * step, column + (i - 1) * step);
            if (std::isnan(z[j][i])) return {};
        }
    const double h = static_cast<double>(step) * grid.cell_size;
    double z_x = 0, z_y = 0, z_xx = 0, z_yy = 0;
    for (int k = 0; k < 3; ++k) {
        z_x += (z[k][2] - z[k][0]) / (6 * h);
        z_y += (z[2][k] - z[0][k]) / (6 * h);
        z_xx += (z[k][0] - 2 * z[k][1] + z[k][2]) / (3 * h * h);
        z_yy += (z[0][k] - 2 * z[1][k] + z[2][k]) / (3 * h * h);
    }
    const double z_xy = (z[2][2] - z[2][0] - z[0][2] + z[0][0]) / (4 * h * h);
    const double square = z_x * z_x + z_y * z_y;
    return {std::sqrt(square),
            (z_xx * z_y * z_y - 2 * z_xy * z_x * z_y + z_yy * z_x * z_x) / std::max(k_least_square_of_slope, square)};
}

FrictionByPlace::FrictionByPlace(FrictionChoice choice, Raster terrain, std::optional<Raster> forest)
    : choice_(std::move(choice)),
      terrain_(std::move(terrain)),
      forest_(std::move(forest)),
      step_(std::max<std::int64_t>(1, std::lround(choice_.table.spacing / terrain_.grid.cell_size))) {}

std::optional<FrictionByPlace::Place> FrictionByPlace::at(std::int64_t row, std::int64_t column) const {
    const double elevation = terrain_.at(row, column);
    if (std::isnan(elevation)) return std::nullopt;
    const FrictionTable& table = choice_.table;
    Place place;
    place.band = class_between(table.altitudes, elevation);
    place.forest = forest_ && forest_->has_data(row, column);
    const std::vector<FrictionTable::Terrain>& kinds = table.terrain;
    const GroundShape shape = kinds.size() > 1 ? ground_shape(terrain_, row, column, step_) : GroundShape();
    const std::optional<double>& gentle = kinds[0].slope_below;
    std::size_t lower = gentle && !(shape.slope < std::tan(*gentle * std::numbers::pi / 180)) ? 1 : 0;
    double weight = 0;  // of the next class
    if (lower + 1 < kinds.size() && (lower == 1 || !gentle)) {
        const double curvature = shape.curvature;
        while (lower + 2 < kinds.size() && curvature >= kinds[lower + 1].curvature) ++lower;
        const double from = kinds[lower].curvature, to = kinds[lower + 1].curvature;
        weight = std::clamp((curvature - from) / (to - from), 0.0, 1.0);
    }
    const auto values_of = [&](std::size_t kind) { return choice_.at(kind, place.band, place.forest); };
    place.kind = lower + (weight > 0.5 ? 1 : 0);
    // At a class' own curvature its values stand exactly.
    place.values = weight == 0   ? values_of(lower)
                   : weight == 1 ? values_of(lower + 1)
                                 : between(values_of(lower), values_of(lower + 1), weight);
    return place;
}

std::vector<FrictionArea> friction_areas(const FrictionByPlace& friction, const Raster& mask) {
    std::map<std::tuple<std::size_t, std::size_t, bool>, double> areas;
    const GridSpec &part = mask.grid, &whole = friction.terrain().grid;
    const std::int64_t columns = part.columns, row = std::lround((whole.north - part.north) / whole.cell_size),
                       column = std::lround((part.west - whole.west) / whole.cell_size);
    mask.values.for_each_stored([&](std::size_t cell, double inside) {
        if (!(inside != 0) || std::isnan(inside)) return;
        const auto at = static_cast<std::int64_t>(cell);
        if (const auto place = friction.at(row + at / columns, column + at % columns))
            areas[{place->kind, place->band, place->forest}] += mask.grid.cell_area();
    });
    std::vector<FrictionArea> list;
    for (const auto& [key, area] : areas) list.push_back({std::get<0>(key), std::get<1>(key), std::get<2>(key), area});
    return list;
}

}  // namespace frana
