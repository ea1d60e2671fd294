// SPDX-License-Identifier: Apache-2.0
#include "analysis/exposure.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace frana {
namespace {

double greatest_in(const Raster& raster, const std::vector<std::size_t>& cells) {
    double greatest = 0;
    for (const std::size_t cell : cells)
        if (const double value = raster.values[cell]; value > greatest) greatest = value;
    return greatest;
}

double least_in(const Raster& raster, const std::vector<std::size_t>& cells) {
    double least = k_no_data;
    for (const std::size_t cell : cells) least = std::fmin(least, raster.values[cell]);
    return least;
}

std::string place_text(const MixedShape& shape, const ExposureRow& row) {
    if (shape.empty()) return "no geometry";
    if (row.place == MapPlace::outside) return "outside the map";
    if (!row.has_ground) return "no elevation";
    return row.place == MapPlace::partly ? "partly outside the map" : k_on_map;
}

}  // namespace

double ExposureRow::number(const std::string& name) const {
    return std::find_if(numbers.begin(), numbers.end(), [&](const auto& one) { return one.first == name; })->second;
}

std::vector<ExposureValues> exposure_values(const std::vector<std::vector<std::size_t>>& cells,
                                            const ExposureRasters& rasters) {
    std::vector<ExposureValues> all;
    for (const std::vector<std::size_t>& own : cells) {
        ExposureValues& values = all.emplace_back();
        values.depth = greatest_in(*rasters.depth, own);
        values.velocity = greatest_in(*rasters.velocity, own);
        values.pressure = greatest_in(*rasters.pressure, own);
        if (rasters.momentum != nullptr) values.momentum = greatest_in(*rasters.momentum, own);
        values.arrival = least_in(*rasters.arrival, own);
        if (rasters.terrain != nullptr && !own.empty())
            values.has_ground = std::any_of(own.begin(), own.end(), [&](std::size_t cell) {
                return !std::isnan(std::as_const(*rasters.terrain).values[cell]);
            });
    }
    return all;
}

ExposureRow exposure_row(const MixedShape& shape, const ExposureValues& values, const Bounds& map) {
    ExposureRow row;
    row.place = shape.empty() ? MapPlace::outside : place_of(shape, map);
    row.has_ground = values.has_ground;
    row.depth = row.is_on_map() ? values.depth : k_no_data;
    const bool reached = row.is_reached();
    const auto add = [&](const char* name, double value) {
        row.numbers.emplace_back(name, row.is_on_map() ? value : k_no_data);
    };
    add("reached", reached ? 1 : 0);
    add("max_depth_m", values.depth);
    add("max_velocity_ms", reached ? values.velocity : 0);
    add("max_pressure_kpa", reached ? values.pressure : 0);
    add("arrival_s", reached ? values.arrival : k_no_data);
    if (!std::isnan(values.momentum)) add("max_momentum_flux_m3s2", reached ? values.momentum : 0);
    row.texts.emplace_back("place", place_text(shape, row));
    return row;
}

}  // namespace frana
