// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
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

/// A table for a terminal: cells wrap at spaces, a newline in a cell starts another line of it. Letters count as they
/// are displayed.
class TextTable {
  public:
    struct Column {
        std::string title;
        std::size_t widest;  ///< columns of the terminal
        bool right = false;  ///< aligned there, as numbers are
    };
    /// @param ruled a rule between all rows, for cells of several lines
    explicit TextTable(std::vector<Column> columns, bool ruled = true) : columns_(std::move(columns)), ruled_(ruled) {}

    /// One cell per column.
    void add(const std::vector<std::string>& cells) { rows_.push_back(cells); }
    /// Returns the table at most so wide: its widest columns are narrowed; if short words would be torn, each row
    /// becomes a list of titles and cells.
    [[nodiscard]] std::string text(std::size_t width) const;

  private:
    [[nodiscard]] std::vector<std::size_t> widths(std::size_t width) const;
    [[nodiscard]] std::string as_lists(std::size_t width) const;

    std::vector<Column> columns_;
    bool ruled_;
    std::vector<std::vector<std::string>> rows_;
};

/// Returns "  name   value", the value wrapped beside the name.
std::string fact_line(const std::string& name, const std::string& value, std::size_t width);
/// Prints it, as wide as the output is.
void print_fact(const std::string& name, const std::string& value);

/// Returns a text whose lines wider than this are wrapped, under their own indentation and two columns more.
std::string folded(const std::string& text, std::size_t width);

}  // namespace frana::app
