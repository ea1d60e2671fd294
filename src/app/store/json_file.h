// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <boost/property_tree/ptree.hpp>
#include <optional>
#include <string>

namespace frana::app {

/// Values as text: number_from_text reads numbers, and "null" is none.
using JsonTree = boost::property_tree::ptree;

/// None where there is no such file for this program, or it is no JSON. Throws Error(environment) where the disk does
/// not give it.
std::optional<JsonTree> read_json_file(const std::string& path);

/// A number by its path ("runout.drop_m"); none where there is none.
std::optional<double> number_in(const JsonTree& tree, const std::string& path);

}  // namespace frana::app
