// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "core/grid_spec.h"
#include "study/member_record.h"

namespace frana::study {

/// Calls visit(feature, values) for every feature, in order; values has one number for each member: the greatest value
/// in any of the feature's cells (arrival: the least), 0 (arrival: infinity) where the member reached none. Memory is
/// bounded by a budget, whatever the number of members and features. Throws Error(environment) for a record that cannot
/// be read.
/// @param records files of the members
/// @param cells of each feature, on the grid
void for_each_feature(const std::vector<std::string>& records, Quantity quantity, const GridSpec& grid,
                      const std::vector<std::vector<std::size_t>>& cells,
                      const std::function<void(std::size_t feature, std::span<const float> values)>& visit);

}  // namespace frana::study
