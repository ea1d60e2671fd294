// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace frana {

/// Without white space at either end.
std::string trimmed(const std::string& text);

/// A finite number, the whole text, with a decimal point; nothing otherwise.
std::optional<double> number_from_text(const std::string& text);
std::optional<std::int64_t> integer_from_text(const std::string& text);
/// on, true, yes, 1 and off, false, no, 0.
std::optional<bool> boolean_from_text(const std::string& text);

/// The parts between commas or white space, empty ones left out.
std::vector<std::string> words_of(const std::string& text);

std::string joined(const std::vector<std::string>& words, const std::string& separator);

}  // namespace frana
