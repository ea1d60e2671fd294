// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "core/json.h"

namespace frana::app {

/// None where there is no such file for this program, or it is no JSON. Throws Error(environment) where the disk does
/// not give it.
std::optional<Json> read_json_file(const std::string& path);

/// The value at a pointer ("/runout/drop_m"); none where there is none of this type: double, std::int64_t, bool,
/// std::string.
template <class T>
std::optional<T> value_in(const Json& json, const std::string& pointer);

}  // namespace frana::app
