// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/words/language.h"

namespace frana {

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

    [[nodiscard]] Language language() const noexcept { return language_; }

    /// Returns a text in the language, {1}, {2}, ... replaced by the values. A text that has none stays English: it
    /// is a user's own, as the name of another program's raster.
    [[nodiscard]] std::string operator()(std::string_view english, const std::vector<std::string>& values = {}) const;

    /// Returns a number or list of numbers written in English ("1 234.5", "0.1, 0.5") as the language writes it:
    /// decimal sign, separator of thousands. Texts between the numbers are unchanged.
    [[nodiscard]] std::string number(std::string_view english) const;

    /// Returns a day ("2026-11-24") as the language writes it: "24. November 2026"; other texts unchanged.
    [[nodiscard]] std::string date(std::string_view iso) const;

    /// Returns "a: b", with the space that French writes before a colon.
    [[nodiscard]] std::string labelled(std::string_view label, std::string_view text) const;

  private:
    Language language_ = Language::english;
};

/// Marks a text in a table of the program that is put into a language where it is shown. Returns the text.
constexpr const char* worded(const char* english) {
    return english;
}

}  // namespace frana
