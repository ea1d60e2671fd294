// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace frana {

/// Members keep the order in which they were added. Files that build or read one include <nlohmann/json.hpp>.
using Json = nlohmann::ordered_json;

/// Returns the text of a file, indented by two spaces, with a final newline. Numbers read back as the same double;
/// non-finite numbers become null, as JSON has no value for them; bytes that are not UTF-8 are escaped (valid_utf8).
std::string json_text(Json value);

}  // namespace frana
