// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace frana {

/// A key that had another name in earlier versions. Scenes may still use that name, with a warning unless it stays.
struct FormerName {
    const char* former;
    const char* now;
    bool stays = false;  ///< a second name that will not be refused
};

/// In the order of the reference; CHANGELOG.md contains the table of those that do not stay (a test compares).
[[nodiscard]] const std::vector<FormerName>& former_names();

/// Returns the entry of a name; null if it is no former name.
[[nodiscard]] const FormerName* former_name(const std::string& name);

/// Returns the present name of a key; `name` itself if it is no former name.
[[nodiscard]] std::string present_name(const std::string& name);

}  // namespace frana
