// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "core/json.h"

namespace frana::app {

/// Returns none if the file does not exist, is not accessible, or is not JSON. Throws Error(environment) for a read
/// error of the disk.
std::optional<Json> read_json_file(const std::string& path);

/// Returns the value at a pointer ("/runout/drop_m"); none if there is none of this type: double, std::int64_t, bool,
/// std::string.
template <class T>
std::optional<T> value_in(const Json& json, const std::string& pointer);

}  // namespace frana::app
