// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace frana {

/// A key that had another name in earlier versions, which scenes may still use, with a warning.
struct FormerName {
    const char* former;
    const char* now;
};

/// In the order of the reference; CHANGELOG.md has the same table (a test compares).
[[nodiscard]] const std::vector<FormerName>& former_names();

/// The present name of a key; `name` itself where it has no former one.
[[nodiscard]] std::string present_name(const std::string& name);

}  // namespace frana
