// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace frana {

/// Encodes bytes in the base64 alphabet (RFC 4648), for data URLs.
std::string base64(std::string_view bytes);

}  // namespace frana
