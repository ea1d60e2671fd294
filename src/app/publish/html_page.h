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

/// Returns blocks, the text of a span or a cell as HTML.
std::string html_of(const Document& document);
std::string html_of(const Span& span);
std::string html_of(const Cell& cell);

/// New content of a part of a page: page_part.
struct PagePart {
    std::string name, html;
    bool optional = false;  ///< a page may be without it
};

/// Replaces parts of report.html of a result, which gets its name when it is complete, and its mark in the manifest.
/// Returns false if there is a report that was changed since, or of an older frana without these parts, which stays as
/// it is. Throws Error(environment).
/// @param parts in the language of the page
bool renew_page(const std::string& folder, const std::function<std::vector<PagePart>(const Words&)>& parts);

/// Returns a part of a page that another command can replace: HTML between two comments with its name.
std::string page_part(const std::string& name, const std::string& html);
/// Returns the page with that part replaced; none if it has no such part.
std::optional<std::string> with_part(const std::string& page, const std::string& name, const std::string& html);
/// Returns the language that a page of frana is written in.
Words words_of_page(const std::string& page);

}  // namespace frana::app
