// SPDX-License-Identifier: Apache-2.0
#include "core/words/language.h"

#include <array>
#include <cstdlib>

namespace frana {
namespace {

constexpr auto k_languages = std::to_array<LanguageRow>({
    {"en", ".", " ", ": "},
    {"it", ",", ".", ": "},
    {"de", ",", ".", ": "},
    {"fr", ",", "\u202F", "\u202F: "},  // a narrow space, at which no line ends
    {"es", ",", "\u202F", ": "},
});

}  // namespace

std::span<const LanguageRow> languages() {
    return k_languages;
}

const LanguageRow& row_of(Language language) {
    return k_languages.at(static_cast<std::size_t>(language));
}

std::string language_code(Language language) {
    return row_of(language).code;
}

std::string language_codes() {
    std::string all;
    for (const LanguageRow& one : k_languages) all += (all.empty() ? "" : ", ") + std::string(one.code);
    return all;
}

std::optional<Language> language_of_code(std::string_view code) {
    for (std::size_t i = 0; i < k_languages.size(); ++i)
        if (k_languages.at(i).code == code) return static_cast<Language>(i);
    return std::nullopt;
}

Language language_of_locale(std::string_view locale) {
    return language_of_code(locale.substr(0, locale.find_first_of("_.@"))).value_or(Language::english);
}

Language process_language() {
    for (const char* name : {"LC_ALL", "LC_MESSAGES", "LANG"})
        if (const char* locale = std::getenv(name); locale != nullptr && *locale != '\0')
            return language_of_locale(locale);
    return Language::english;
}

}  // namespace frana
