// SPDX-License-Identifier: Apache-2.0
#include "core/words/number_pattern.h"

#include <algorithm>
#include <cctype>
#include <regex>

namespace frana {
namespace {

/// Digits in a word belong to it: Float32, m2.
bool continues_word(std::string_view text, std::size_t at) {
    if (at == 0) return false;
    const auto before = static_cast<unsigned char>(text[at - 1]);
    return std::isalnum(before) != 0 || before == '_' || before == '.' || before == '/' || before >= 0x80;
}

}  // namespace

NumberPattern::NumberPattern(std::string_view english) {
    static const std::regex k_number(R"(\d{1,3}( \d{3})+(?!\d)(\.\d+)?|\d+(\.\d+)?)");
    constexpr std::size_t k_places = 9;
    const std::string whole(english);
    std::size_t end = 0;
    for (std::sregex_iterator one(whole.begin(), whole.end(), k_number), none; one != none; ++one) {
        const auto begin = static_cast<std::size_t>(one->position());
        if (numbers.size() == k_places || continues_word(english, begin)) continue;
        numbers.push_back(one->str());
        text += whole.substr(end, begin - end) + "{" + std::to_string(numbers.size()) + "}";
        end = begin + numbers.back().size();
    }
    text += whole.substr(end);
}

std::string NumberPattern::in(const Words& words) const {
    std::vector<std::string> shown(numbers.size());
    std::transform(numbers.begin(), numbers.end(), shown.begin(),
                   [&](const std::string& number) { return words.number(number); });
    return words(text, shown);
}

}  // namespace frana
