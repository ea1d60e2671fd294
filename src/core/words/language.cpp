// SPDX-License-Identifier: Apache-2.0
#include "core/words/language.h"

#include <cstdlib>

namespace frana {

std::string language_code(Language language) {
    for (const LanguageCode& one : k_languages)
        if (one.language == language) return one.code;
    return {};
}

std::string language_codes() {
    std::string all;
    for (const LanguageCode& one : k_languages) all += (all.empty() ? "" : ", ") + std::string(one.code);
    return all;
}

std::optional<Language> language_of_code(std::string_view code) {
    for (const LanguageCode& one : k_languages)
        if (one.code == code) return one.language;
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
