// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/publish/document.h"
#include "core/words/words.h"

namespace frana::app {

/// How a page begins: with its title alone; or with a section that contains the title and the answer, which with a
/// picture fills the first page of paper.
enum class Opening { title, answer, answer_with_picture };

struct PageHead {
    std::string title;
    std::string origin;  ///< a small line below the title: what computed it, from what
    Words words;
    Opening opening = Opening::title;
};

/// Writes report.html of a result's folder: self-contained, for the screen and for paper (A4), block by block, so that
/// memory contains one picture at a time. It gets its name when it is finished; then the pictures that were drawn for
/// the page alone are deleted. Throws Error(environment).
void write_page(const std::string& folder, const PageHead& head, const Document& document);

}  // namespace frana::app
