// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace frana {

/// The reference of all keys, generated from their declarations.
std::string reference_ini();       ///< a scene file with every key commented out at its default
std::string reference_json();      ///< an array of objects: name, type, unit, default, limits, meaning
std::string reference_markdown();  ///< one table per section

}  // namespace frana
