// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace frana {

/// Languages of what people read on maps, charts and in reports. File and column names, keys and messages are English.
enum class Language { english, italian, german, french, spanish };

/// A language and its code of two letters.
struct LanguageCode {
    Language language;
    const char* code;
};
inline constexpr std::array<LanguageCode, 5> k_languages{{{Language::english, "en"},
                                                          {Language::italian, "it"},
                                                          {Language::german, "de"},
                                                          {Language::french, "fr"},
                                                          {Language::spanish, "es"}}};

/// Returns "de".
std::string language_code(Language language);
/// Returns "en, it, de, fr, es".
std::string language_codes();
/// Returns the language of a code; none for others.
std::optional<Language> language_of_code(std::string_view code);
/// Returns the language of a locale's name ("de_AT.UTF-8"); English if it is none of these languages.
Language language_of_locale(std::string_view locale);
/// Returns the language of this process: that of the first of LC_ALL, LC_MESSAGES and LANG that is set and not empty.
Language process_language();

}  // namespace frana
