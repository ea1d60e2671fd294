// SPDX-License-Identifier: Apache-2.0
#include "core/words/sentence.h"

#include <cstdlib>
#include <utility>

namespace frana {

std::string Sentence::in(const Words& words) const {
    if (kind_ == Kind::verbatim) return text_;
    if (kind_ == Kind::number) return words.number(text_);
    std::vector<std::string> values;
    for (const Sentence& value : values_) values.push_back(value.in(words));
    return words(text_, values);
}

std::optional<double> Sentence::first_number() const {
    if (kind_ == Kind::number) {
        std::string digits;  // without the spaces between groups
        for (const char c : text_)
            if (c != ' ') digits += c;
        char* end = nullptr;
        const double value = std::strtod(digits.c_str(), &end);
        if (end != digits.c_str()) return value;
    }
    for (const Sentence& value : values_)
        if (const auto number = value.first_number()) return number;
    return std::nullopt;
}

Sentence worded(const char* english, std::vector<Sentence> values) {
    return {Sentence::Kind::pattern, english, std::move(values)};
}

Sentence numeral(std::string english) {
    return {Sentence::Kind::number, std::move(english), {}};
}

Sentence listed(const std::vector<Sentence>& parts) {
    Sentence all;
    for (std::size_t i = 0; i < parts.size(); ++i) all = i == 0 ? parts[i] : worded("{1}; {2}", {all, parts[i]});
    return all;
}

std::vector<std::string> texts_of(const std::vector<Sentence>& sentences) {
    std::vector<std::string> texts;
    for (const Sentence& sentence : sentences) texts.push_back(sentence.text());
    return texts;
}

}  // namespace frana
