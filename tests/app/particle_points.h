// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

namespace frana::test {

/// The layer "particles" of a GeoPackage, column by column; x and y are columns too.
struct Points {
    std::vector<std::string> names;  ///< in the file's order, without x and y
    std::map<std::string, std::vector<double>> columns;

    [[nodiscard]] double sum(const std::string& name) const;
    [[nodiscard]] std::size_t size() const { return columns.count("x") == 0 ? 0 : columns.at("x").size(); }
};

/// Fails the test if there is no such layer.
Points read_points(const std::string& path);

}  // namespace frana::test
