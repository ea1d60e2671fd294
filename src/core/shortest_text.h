// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace frana {

/// Returns the shortest decimal text that reads back as the same double ("0.1", "1e+20"); "nan", "inf", "-inf" for
/// non-finite values.
std::string shortest_text(double value);

}  // namespace frana
