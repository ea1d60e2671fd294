// SPDX-License-Identifier: Apache-2.0
#include "app/layers.h"

#include <cmath>

#include "core/colour.h"
#include "core/error.h"

namespace frana::app {

std::vector<Layer> result_layers() {
    return {
        {"max_depth", "Maximum depth", "Maximum flow depth over time, vertical", "m", "depth",
         &RunResult::max_depth},
        {"max_velocity", "Maximum velocity", "Maximum flow speed over time, along the bed", "m/s", "velocity",
         &RunResult::max_velocity},
        {"final_depth", "Final depth", "Flow depth at the end, vertical", "m", "depth",
         &RunResult::final_depth},
        {"arrival_time", "Arrival time", "Time at which the flow first arrived", "s", "time",
         &RunResult::arrival_time},
        {"max_pressure", "Maximum dynamic pressure", "Maximum over time of density times speed squared",
         "kPa", "velocity", &RunResult::max_pressure},
    };
}

Layer layer_named(const std::string& name) {
    std::string known;
    for (const Layer& layer : result_layers()) {
        if (layer.name == name) return layer;
        known += (known.empty() ? "" : ", ") + layer.name;
    }
    throw Error(ErrorKind::input, Problem{"is not a raster of a result", "map", name, known, ""});
}

std::vector<double> layer_classes(double maximum) {
    constexpr int k_classes = 8;  // as many as an eye tells apart in a legend
    return nice_classes(std::isnan(maximum) ? 0 : maximum, k_classes);
}

}  // namespace frana::app
