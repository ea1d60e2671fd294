// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace frana {

/// Languages of what people read on maps, charts and in reports. File and column names, keys and messages are English.
/// The value is the number of the language's row in languages().
enum class Language : std::uint8_t { english, italian, german, french, spanish };

/// A language: its code of two letters, and the signs between which it writes numbers and labels.
struct LanguageRow {
    const char* code;
    const char* decimal;    ///< sign
    const char* thousands;  ///< sign between groups of three digits
    const char* colon;      ///< what stands between a label and its text
};
/// Returns all languages, English first.
std::span<const LanguageRow> languages();
/// Returns the row of a language.
const LanguageRow& row_of(Language language);

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
