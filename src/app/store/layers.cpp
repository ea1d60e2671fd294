// SPDX-License-Identifier: Apache-2.0
#include "app/store/layers.h"

#include <cmath>

#include "core/colour.h"
#include "core/error.h"

namespace frana::app {

namespace {

// As many as an eye tells apart in a legend.
constexpr int k_classes = 8;

/// The greatest of some factors (rising, the first 1) times a power of ten that is less than a value; with a
/// grain of tolerance, so that 0.3 is not less than 3 tenths.
double round_below(double value, std::initializer_list<double> factors) {
    const double limit = value * (1 - 1e-9);
    const double decade = std::pow(10.0, std::floor(std::log10(limit)));
    double best = decade;
    for (const double factor : factors)
        if (factor * decade < limit) best = factor * decade;
    return best;
}

/// The least of some round numbers that is not less than a value.
double round_above(double value) {
    const double decade = std::pow(10.0, std::floor(std::log10(value)));
    for (const double factor : {1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0})
        if (factor * decade >= value * (1 - 1e-9)) return factor * decade;
    return 10 * decade;
}

/// From a round number above the maximum downwards: 40, 30, 20, 10, then 5, 2, 1, 0.5 ... and at last 0.
std::vector<double> progressive_classes(double maximum) {
    const double top = round_above(maximum);
    const double decade = std::pow(10.0, std::floor(std::log10(top * (1 + 1e-9))));
    std::vector<double> bounds{top};
    while (bounds.size() < k_classes) {
        const double last = bounds.back();
        bounds.push_back(last > decade * (1 + 1e-9) ? round_below(last, {1, 2, 3, 5})
                                                    : round_below(last, {1, 2, 5}));
    }
    bounds.push_back(0);
    return {bounds.rbegin(), bounds.rend()};
}

}  // namespace

std::vector<Layer> result_layers() {
    return {
        {"max_depth", "Maximum depth", "Maximum flow depth over time, vertical", "m", "depth", true,
         &RunResult::max_depth},
        {"max_velocity", "Maximum velocity", "Maximum flow speed over time, along the bed", "m/s", "velocity",
         false, &RunResult::max_velocity},
        {"final_depth", "Final depth", "Flow depth at the end, vertical", "m", "depth", true,
         &RunResult::final_depth},
        {"arrival_time", "Arrival time", "Time at which the flow first arrived", "s", "time", false,
         &RunResult::arrival_time},
        {"max_pressure", "Maximum dynamic pressure", "Maximum over time of density times speed squared",
         "kPa", "velocity", true, &RunResult::max_pressure},
    };
}

std::vector<Layer> all_layers() {
    std::vector<Layer> layers = result_layers();
    const auto add = [&](const char* name, const char* title, const char* description, const char* unit,
                         const char* palette, bool progressive, Raster RunResult::* values = nullptr) {
        layers.push_back({name, title, description, unit, palette, progressive, values});
    };
    add("eroded_depth", "Eroded depth", "Depth eroded from the bed, vertical", "m", "depth", true,
        &RunResult::eroded_depth);
    add("deposited_depth", "Deposited depth", "Depth deposited on the bed, vertical", "m", "depth", true,
        &RunResult::deposited_depth);
    add("jump_height", "Height of jumps", "Greatest height above the ground at which material flew over the cell", "m", "depth",
        true, &RunResult::jump_height);
    add("fluid_depth", "Depth of free fluid", "Depth of the free fluid, vertical", "m", "depth", true);
    add("solid_depth", "Depth of solids", "Depth of solids without their fluid, vertical", "m", "depth", true);
    add("solid_fraction", "Solid fraction", "Share of solids in everything that lies in the cell", "-", "depth", false);
    add("cohesion_ratio", "Cohesion left", "Cohesion over initial cohesion, mean of the solids", "-", "depth", false);
    add("strain", "Strain", "Greatest strain in the plane since the start, mean of the solids", "-", "depth", true);
    add("fluid_velocity", "Velocity of the fluid", "Speed of the free fluid, along the bed", "m/s", "velocity", false);
    add("solid_velocity", "Velocity of the solids", "Speed of solids and confined fluid, along the bed", "m/s",
        "velocity", false);
    add("released_water", "Released fluid", "Confined fluid that the structure has set free here", "m", "depth", true);
    return layers;
}

const Raster* find_layer(const RunResult& result, const Layer& layer) {
    if (layer.values != nullptr) {
        const Raster& raster = result.*layer.values;
        return raster.values.empty() ? nullptr : &raster;
    }
    for (const NamedRaster& raster : result.more)
        if (raster.name == layer.name) return &raster.values;
    return nullptr;
}

Layer layer_named(const std::string& name) {
    std::string known;
    for (const Layer& layer : all_layers()) {
        if (layer.name == name) return layer;
        known += (known.empty() ? "" : ", ") + layer.name;
    }
    throw Error(ErrorKind::input, Problem{"is not a raster of a result", "map", name, known, ""});
}

std::vector<double> layer_classes(const Layer& layer, double maximum) {
    if (!(maximum > 0)) return nice_classes(0, k_classes);
    return layer.progressive ? progressive_classes(maximum) : nice_classes(maximum, k_classes);
}

}  // namespace frana::app
