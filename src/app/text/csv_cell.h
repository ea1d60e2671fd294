// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace frana::app {

/// Returns a text of the user as one cell of a CSV file: valid UTF-8, quoted if it contains a comma, a quote or a line
/// end.
/// A spreadsheet interprets a text that begins with = + - @, a tab or a line end as a formula: such a text gets an
/// apostrophe before it, and one that begins with an apostrophe another.
std::string csv_cell(const std::string& text);

/// Returns the text from which csv_cell wrote a cell, without its quotes.
std::string text_of_cell(const std::string& cell);

}  // namespace frana::app
