// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

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

/// English texts and what they are in another language: a catalogue that gettext's msgfmt compiled (.mo), read where
/// its bytes are. gettext's own reader needs files and installed locales; without either a result would lose its
/// language silently.
class Catalogue {
  public:
    Catalogue() = default;
    /// Refers to the bytes. Throws Error if they are no catalogue, end early or are not sorted: all later reading is
    /// within them.
    explicit Catalogue(std::string_view bytes);

    /// Returns the text; none if the catalogue does not have it.
    [[nodiscard]] std::optional<std::string_view> find(std::string_view english) const;

    [[nodiscard]] std::uint32_t size() const noexcept { return end_ - begin_; }
    [[nodiscard]] std::string_view english(std::uint32_t index) const { return entry(english_at_, begin_ + index); }

  private:
    [[nodiscard]] std::uint32_t number(std::uint64_t at) const;
    [[nodiscard]] std::string_view entry(std::uint32_t table, std::uint32_t index) const;

    std::string_view bytes_;
    std::uint32_t english_at_ = 0, text_at_ = 0;  ///< tables of lengths and places
    std::uint32_t begin_ = 0, end_ = 0;           ///< entries, without the header: the text of ""
};

/// A catalogue in the program.
struct EmbeddedCatalogue {
    std::string_view code, bytes;
};
/// Returns those of share/po. CMake writes the function (src/CMakeLists.txt).
std::span<const EmbeddedCatalogue> embedded_catalogues();

/// Returns the catalogue of a language; an empty one for English.
const Catalogue& catalogue_of(Language language);

/// Texts that a user's file brings in other languages: by the code of the language, by the English text.
using OwnTexts = std::map<std::string, std::map<std::string, std::string, std::less<>>>;

/// Texts and numbers in a language. A value that travels with what describes a page; English unless given.
///
///     words("Threshold {1} m", {words.number(number_text(threshold, 3))})    // "Schwellenwert 0,5 m"
///
/// The English text is the msgid of the catalogues share/po. tests/core/words/catalogue_test.cpp finds the texts of
/// such calls in the sources, and those of worded(), and refuses one that a catalogue does not have. It sees one
/// literal in a call: words(many ? worded("{1} cells") : worded("{1} cell")).
class Words {
  public:
    Words() = default;
    explicit Words(Language language) : language_(language) {}

    /// Returns the same with texts that come before those of the catalogues.
    [[nodiscard]] Words with(const OwnTexts& texts) const;

    [[nodiscard]] Language language() const noexcept { return language_; }

    /// Returns a text in the language, {1}, {2}, ... replaced by the values. A text that has none stays English: it
    /// is a user's own, as the name of another program's raster.
    [[nodiscard]] std::string operator()(std::string_view english, const std::vector<std::string>& values = {}) const;

    /// Returns a number or list of numbers written in English ("1 234.5", "0.1, 0.5") as the language writes it:
    /// decimal sign, separator of thousands. Texts between the numbers are unchanged.
    [[nodiscard]] std::string number(std::string_view english) const;

    /// Returns "a: b", with the space that French writes before a colon.
    [[nodiscard]] std::string labelled(std::string_view label, std::string_view text) const;

  private:
    Language language_ = Language::english;
    std::map<std::string, std::string, std::less<>> own_;
};

/// Marks a text in a table of the program that is put into a language where it is shown. Returns the text.
constexpr const char* worded(const char* english) {
    return english;
}

/// An English text with its numbers taken out, so that one text of the catalogues serves for all values.
struct NumberPattern {
    std::string text;                  ///< "{1}, a smooth wide bed"; at most nine places, later numbers stay
    std::vector<std::string> numbers;  ///< "24"; with groups of three digits: "63 071"

    explicit NumberPattern(std::string_view english);
    [[nodiscard]] std::string in(const Words& words) const;
};

}  // namespace frana
