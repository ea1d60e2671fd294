// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace frana {

/// Returns the text without white space at either end.
std::string trimmed(const std::string& text);

/// Reads a finite number with a decimal point from the whole text; none otherwise.
std::optional<double> number_from_text(const std::string& text);
std::optional<std::int64_t> integer_from_text(const std::string& text);
/// Reads on, true, yes, 1 and off, false, no, 0.
std::optional<bool> boolean_from_text(const std::string& text);

/// Returns the parts between commas or white space, without empty ones.
std::vector<std::string> words_of(const std::string& text);

std::string joined(const std::vector<std::string>& words, const std::string& separator);

}  // namespace frana
