// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/words/words.h"

namespace frana::app {

/// New content of a part of a page: page_part.
struct PagePart {
    std::string name, html;
    bool optional = false;  ///< a page may be without it
};

/// Replaces parts of report.html of a result, which gets its name when it is complete, and its mark in the manifest. A
/// page that was changed since is kept under another name. Returns false if there is a report of an older frana,
/// without these parts, which stays as it is. Throws Error(environment).
/// @param parts in the language of the page
bool renew_page(const std::string& folder, const std::function<std::vector<PagePart>(const Words&)>& parts);

}  // namespace frana::app
