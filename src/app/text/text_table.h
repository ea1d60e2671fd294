// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace frana::app {

/// Returns a text of the user as one cell of a CSV file: valid UTF-8, quoted if it contains a comma, a quote or a line
/// end.
/// A spreadsheet interprets a text that begins with = + - @, a tab or a line end as a formula: such a text gets an
/// apostrophe before it, and one that begins with an apostrophe another.
std::string csv_cell(const std::string& text);

/// Returns a line of the file: such cells, and numbers as they are.
std::string csv_line(const std::vector<std::string>& texts);

/// Returns the text from which csv_cell wrote a cell, without its quotes.
std::string text_of_cell(const std::string& cell);

/// Returns the columns that a UTF-8 text takes on a terminal: wide letters (Chinese) two, combining accents none. A
/// byte that is not UTF-8 counts one.
std::size_t display_width(std::string_view text);

/// Returns the number of bytes of the longest beginning that takes at most so many columns; at least one character.
std::size_t bytes_within(std::string_view text, std::size_t columns);

/// Wraps at spaces so that no line is wider; a wider word is broken. A newline in the text starts another line.
std::vector<std::string> wrapped(const std::string& text, std::size_t columns);

/// Pads with spaces to so many columns, on the left if `right`.
std::string padded(const std::string& text, std::size_t columns, bool right = false);

/// Whether a name comes before another where the numbers in both count as numbers: T30, T100, T300.
bool precedes(const std::string& one, const std::string& other);

/// A cell of a table.
struct Cell {
    Cell(std::string words) : text(std::move(words)) {}
    Cell(const char* words) : text(words) {}
    Cell(std::string words, std::string of_kind) : text(std::move(words)), kind(std::move(of_kind)) {}

    std::string text;
    // Of a page alone:
    std::string kind{};    ///< "n": a number, "u": its unit, "soft"
    std::string swatch{};  ///< colour before the text, "#rrggbb"
};

/// A table, built once and written as a CSV file, as text for a terminal, or as a part of a page (html_page.h).
class Table {
  public:
    /// A column on a terminal.
    struct Layout {
        std::size_t widest;  ///< columns of the terminal
        bool right = false;  ///< aligned there, as numbers are
    };
    /// @param kind of a page's table
    explicit Table(std::vector<std::string> heads = {}, std::string kind = {})
        : heads_(std::move(heads)), kind_(std::move(kind)) {}

    /// @param kind "given", "warning"; empty: none
    Table& row(std::vector<Cell> cells, const std::string& kind = {}) {
        rows_.emplace_back(kind, std::move(cells));
        return *this;
    }
    /// A name, a number aligned to the right, its unit, and perhaps more.
    Table& number(const std::string& name, const std::string& value, const std::string& unit,
                  const std::vector<Cell>& more = {});

    /// Returns the lines of a CSV file: csv_line() of the heads and of each row.
    [[nodiscard]] std::string csv() const;
    /// Returns the table at most so wide: cells wrap at spaces, a newline in a cell starts another line of it. Its
    /// widest columns are narrowed; if short words would be torn, each row becomes a list of titles and cells.
    /// @param ruled a rule between all rows, for cells of several lines
    [[nodiscard]] std::string text(std::size_t width, const std::vector<Layout>& columns, bool ruled = false) const;

    [[nodiscard]] const std::vector<std::string>& heads() const noexcept { return heads_; }
    [[nodiscard]] const std::string& kind() const noexcept { return kind_; }
    [[nodiscard]] const std::vector<std::pair<std::string, std::vector<Cell>>>& rows() const noexcept { return rows_; }

  private:
    [[nodiscard]] std::vector<std::size_t> widths(std::size_t width, const std::vector<Layout>& columns) const;
    [[nodiscard]] std::string as_lists(std::size_t width) const;

    std::vector<std::string> heads_;
    std::string kind_;
    std::vector<std::pair<std::string, std::vector<Cell>>> rows_;
};

/// Returns "  name   value", the value wrapped beside the name.
std::string fact_line(const std::string& name, const std::string& value, std::size_t width);
/// Prints it, as wide as the output is.
void print_fact(const std::string& name, const std::string& value);

/// Returns a text whose lines wider than this are wrapped, under their own indentation and two columns more.
std::string folded(const std::string& text, std::size_t width);

}  // namespace frana::app
