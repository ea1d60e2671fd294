// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/grid_spec.h"

namespace frana {

/// Points in map coordinates with named numbers: one array per column, each as long as `places`.
struct PointTable {
    struct Column {
        std::string name;  ///< with its unit: "depth_m"
        std::vector<double> values;
    };
    std::vector<Point> places;
    std::vector<Column> columns;

    /// Returns the values of a column; null if no column has that name.
    [[nodiscard]] const std::vector<double>* find(const std::string& name) const {
        for (const Column& column : columns)
            if (column.name == name) return &column.values;
        return nullptr;
    }
    /// Adds a column of zeros to be filled; the reference is valid until the next call.
    std::vector<double>& add(std::string name) {
        columns.push_back({std::move(name), std::vector<double>(places.size())});
        return columns.back().values;
    }
};

}  // namespace frana
