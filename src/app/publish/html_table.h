// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace frana::app {

/// A table of a page. Cells are text, escaped here; the head is repeated on each printed page.
class HtmlTable {
  public:
    explicit HtmlTable(const std::vector<std::string>& heads = {});

    /// @param kind a class of the style; empty: none
    HtmlTable& row(const std::vector<std::string>& cells, const std::string& kind = {});
    /// A name, a number aligned to the right, its unit, and perhaps more.
    HtmlTable& number(const std::string& name, const std::string& value, const std::string& unit,
                      const std::vector<std::string>& more = {});
    /// The same with more cells as HTML.
    HtmlTable& number_with(const std::string& name, const std::string& value, const std::string& unit,
                           const std::string& cells);
    /// Rows as HTML.
    HtmlTable& raw(const std::string& html);

    [[nodiscard]] std::string html(const std::string& kind = {}) const;

  private:
    std::string head_, rows_;
};

/// Returns a paragraph in small letters; the text is escaped here.
std::string small_print(const std::string& text);

}  // namespace frana::app
