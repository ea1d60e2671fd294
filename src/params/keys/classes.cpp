// SPDX-License-Identifier: Apache-2.0
#include "params/keys/classes.h"

#include <limits>

namespace frana {

const std::vector<QuantityClasses>& quantity_classes() {
    static const std::vector<QuantityClasses> k_table{
        {"max-depth", "depths and thicknesses", "m", {0.2, 0.5, 1, 2, 5, 10, 20, 50}},
        {"max-velocity", "speeds", "m/s", {1, 2, 5, 10, 20, 30, 50}},
        {"max-pressure", "dynamic pressures", "kPa", {1, 3, 10, 30, 100, 300, 1000}},
        {"arrival-time", "times of arrival", "s", {10, 30, 60, 120, 300, 600, 1800}},
        {"max-flux", "products of depth and speed", "m2/s", {0.5, 1, 2, 5, 10, 20, 50}},
        {"max-head", "energy heads", "m", {0.5, 1, 1.5, 2, 5, 10, 20}},
        {"strain", "strains", "", {0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1}},
        {"error", "estimated errors of the depth", "m", {0.02, 0.05, 0.1, 0.2, 0.5, 1, 2}},
    };
    return k_table;
}

ClassSpec::ClassSpec() {
    for (const QuantityClasses& row : quantity_classes()) bounds.push_back(row.bounds);
}

std::vector<double> fixed_classes(const ClassSpec& chosen, const std::string& quantity) {
    for (std::size_t i = 0; i < quantity_classes().size(); ++i) {
        if (quantity_classes()[i].name != quantity) continue;
        std::vector<double> bounds{0};
        bounds.insert(bounds.end(), chosen.bounds[i].begin(), chosen.bounds[i].end());
        bounds.push_back(std::numeric_limits<double>::infinity());
        return bounds;
    }
    return {};
}

}  // namespace frana
