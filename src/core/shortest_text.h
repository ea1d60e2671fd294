// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace frana {

/// The shortest decimal text that reads back as the same double ("0.1", "1e+20"); "nan", "inf", "-inf"
/// otherwise.
std::string shortest_text(double value);

}  // namespace frana
