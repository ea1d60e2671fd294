// SPDX-License-Identifier: Apache-2.0
#include "core/words/words.h"

#include <array>
#include <cctype>

#include "core/words/catalogue.h"

namespace frana {
namespace {

bool is_digit(std::string_view text, std::size_t at) {
    return at < text.size() && std::isdigit(static_cast<unsigned char>(text[at])) != 0;
}

/// Whether a space is between groups of a number: one to three digits before it, exactly three after it.
bool is_between_groups(std::string_view text, std::size_t at) {
    const bool three = is_digit(text, at + 1) && is_digit(text, at + 2) && is_digit(text, at + 3);
    if (at == 0 || !is_digit(text, at - 1) || !three || is_digit(text, at + 4)) return false;
    std::size_t before = at;
    while (before > 0 && is_digit(text, before - 1)) --before;
    return at - before <= 3;
}

}  // namespace

std::string Words::operator()(std::string_view english, const std::vector<std::string>& values) const {
    const std::string_view pattern = catalogue_of(language_).find(english).value_or(english);
    std::string text;
    for (std::size_t i = 0; i < pattern.size(); ++i) {
        const bool is_place = pattern[i] == '{' && is_digit(pattern, i + 1) && i + 2 < pattern.size() &&
                              pattern[i + 2] == '}' && pattern[i + 1] > '0' &&
                              static_cast<std::size_t>(pattern[i + 1] - '1') < values.size();
        if (!is_place) {
            text += pattern[i];
            continue;
        }
        text += values[static_cast<std::size_t>(pattern[i + 1] - '1')];
        i += 2;
    }
    return text;
}

std::string Words::number(std::string_view english) const {
    const LanguageRow& signs = row_of(language_);
    std::string text;
    for (std::size_t i = 0; i < english.size(); ++i) {
        if (english[i] == '.' && is_digit(english, i + 1) && i > 0 && is_digit(english, i - 1))
            text += signs.decimal;
        else if (english[i] == ' ' && is_between_groups(english, i))
            text += signs.thousands;
        else
            text += english[i];
    }
    return text;
}

std::string Words::date(std::string_view iso) const {
    const bool is_date = iso.size() == 10 && iso[4] == '-' && iso[7] == '-' && is_digit(iso, 0) && is_digit(iso, 1) &&
                         is_digit(iso, 2) && is_digit(iso, 3) && is_digit(iso, 5) && is_digit(iso, 6) &&
                         is_digit(iso, 8) && is_digit(iso, 9);
    if (!is_date) return std::string(iso);
    static constexpr std::array<const char*, 12> k_months{worded("January"), worded("February"), worded("March"),
                                                          worded("April"),   worded("May"),      worded("June"),
                                                          worded("July"),    worded("August"),   worded("September"),
                                                          worded("October"), worded("November"), worded("December")};
    const int month = 10 * (iso[5] - '0') + (iso[6] - '0');
    if (month < 1 || month > 12) return std::string(iso);
    const std::string day(iso[8] == '0' ? iso.substr(9, 1) : iso.substr(8, 2));
    const Words& words = *this;
    return words("{1} {2} {3}",
                 {day, words(k_months[static_cast<std::size_t>(month - 1)]), std::string(iso.substr(0, 4))});
}

std::string Words::labelled(std::string_view label, std::string_view text) const {
    return std::string(label) + row_of(language_).colon + std::string(text);
}

}  // namespace frana
