// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace frana::app {

/// A text of the user's as one cell of a CSV file: valid UTF-8, quoted where it holds a comma, a quote or a line's end.
/// A spreadsheet takes what begins with = + - @, a tab or a line's end for a formula: such a text gets an apostrophe
/// before it, and one that begins with an apostrophe another.
std::string csv_cell(const std::string& text);

/// The text that csv_cell wrote, from the cell without its quotes.
std::string text_of_cell(const std::string& cell);

}  // namespace frana::app
