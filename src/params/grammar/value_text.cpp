// SPDX-License-Identifier: Apache-2.0
#include "params/grammar/value_text.h"

#include <charconv>
#include <cmath>

namespace frana {
namespace {

template <class Number>
std::optional<Number> whole_text(const std::string& text) {
    const bool plus = text.size() > 1 && text[0] == '+' && text[1] != '-';  // from_chars does not accept a leading plus
    const std::string body = plus ? text.substr(1) : text;
    Number value{};
    const char* const end = body.data() + body.size();
    const auto result = std::from_chars(body.data(), end, value);
    if (result.ec != std::errc{} || result.ptr != end) return std::nullopt;
    return value;
}

}  // namespace

std::string trimmed(const std::string& text) {
    static constexpr char k_white[] = " \t\r\n";
    const auto first = text.find_first_not_of(k_white);
    if (first == std::string::npos) return {};
    return text.substr(first, text.find_last_not_of(k_white) - first + 1);
}

std::optional<double> number_from_text(const std::string& text) {
    const auto value = whole_text<double>(text);
    if (value && !std::isfinite(*value)) return std::nullopt;
    return value;
}

std::optional<std::int64_t> integer_from_text(const std::string& text) {
    return whole_text<std::int64_t>(text);
}

std::optional<bool> boolean_from_text(const std::string& text) {
    if (text == "on" || text == "true" || text == "yes" || text == "1") return true;
    if (text == "off" || text == "false" || text == "no" || text == "0") return false;
    return std::nullopt;
}

std::vector<std::string> words_of(const std::string& text) {
    std::vector<std::string> words;
    std::string word;
    for (const char c : text + ",") {
        if (c != ',' && c != ' ' && c != '\t') {
            word += c;
        } else if (!word.empty()) {
            words.push_back(word);
            word.clear();
        }
    }
    return words;
}

std::string joined(const std::vector<std::string>& words, const std::string& separator) {
    std::string text;
    for (const std::string& word : words) {
        if (!text.empty()) text += separator;
        text += word;
    }
    return text;
}

}  // namespace frana
