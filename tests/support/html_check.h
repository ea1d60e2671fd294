// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace frana::test {

/// Returns the reasons why a page of frana is not well-formed or cannot be read by everybody: tags that are not closed
/// or cross each other, no language, headings that skip a level, pictures without a text, an id used twice, anything
/// that is fetched; empty: none.
std::vector<std::string> html_problems(const std::string& page);

/// Returns the cells of each row of the tables that are printed: without what is folded.
std::vector<std::vector<std::string>> printed_rows(const std::string& page);

/// Returns a text of HTML as it is read, without white space.
std::string letters_of(const std::string& html);

/// Returns a text without white space.
std::string without_space(const std::string& text);

/// Returns the number of times that a word is in a text.
std::size_t count_of(const std::string& text, const std::string& word);

}  // namespace frana::test
