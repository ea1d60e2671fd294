// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace frana {

/// Members stay in the order in which they were added. Who makes or reads one includes <nlohmann/json.hpp>.
using Json = nlohmann::ordered_json;

/// The text of a file, two spaces a level and a final line end. Numbers read back as the same double; non-finite
/// numbers become null, as JSON has no word for them; bytes that are not UTF-8 are written out (valid_utf8).
std::string json_text(Json value);

}  // namespace frana
