// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/grid_spec.h"

namespace frana {

/// Points in map coordinates with named numbers, an array a column, each as long as `places`.
struct PointTable {
    struct Column {
        std::string name;  ///< with its unit: "depth_m"
        std::vector<double> values;
    };
    std::vector<Point> places;
    std::vector<Column> columns;

    /// The values of a column; null where there is none of that name.
    [[nodiscard]] const std::vector<double>* find(const std::string& name) const {
        for (const Column& column : columns)
            if (column.name == name) return &column.values;
        return nullptr;
    }
    /// A column of zeros, to be filled; valid until the next is added.
    std::vector<double>& add(std::string name) {
        columns.push_back({std::move(name), std::vector<double>(places.size())});
        return columns.back().values;
    }
};

}  // namespace frana
