// SPDX-License-Identifier: Apache-2.0
#include "core/words/sentence.h"

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <utility>

#include "core/words/warning.h"

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

std::vector<std::string> texts_of(const Warnings& all) {
    std::vector<std::string> texts;
    for (const Warning& warning : all) texts.push_back(warning.words.text());
    return texts;
}

Warnings without(Warnings all, const Warnings& known) {
    std::erase_if(all, [&](const Warning& one) { return std::find(known.begin(), known.end(), one) != known.end(); });
    return all;
}

Warnings limits_of_use(const Warnings& all) {
    Warnings some;
    std::copy_if(all.begin(), all.end(), std::back_inserter(some), [](const Warning& one) { return one.limits_use; });
    return some;
}

}  // namespace frana
