// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/words/words.h"

namespace frana {

/// A sentence that is put together where its facts are known and shown later in any language: an English pattern that
/// the catalogues have, and the values for {1}, {2}, ... in it.
///
///     const Sentence warning = worded("{1} m3 left the map at {2}", {numeral(grouped(volume)), name});
///     warning.text();                           // in English, for the terminal and for files that programs read
///     warning.in(Words(Language::italian));     // "1.234 m³ hanno lasciato ..."
class Sentence {
  public:
    Sentence() = default;
    /// A text that is the same in all languages: a name, a path, a key, a message of another program.
    Sentence(std::string text) : text_(std::move(text)) {}  // NOLINT(google-explicit-constructor)
    /// A pattern without values: what worded("...") returns.
    Sentence(const char* english) : kind_(Kind::pattern), text_(english) {}  // NOLINT(google-explicit-constructor)

    [[nodiscard]] std::string in(const Words& words) const;
    [[nodiscard]] std::string text() const { return in(Words()); }

    /// Two warnings with the same pattern are of one kind: only their values differ.
    [[nodiscard]] const std::string& pattern() const noexcept { return text_; }

    /// The first number among its values, in the order of their places; none without one.
    [[nodiscard]] std::optional<double> first_number() const;

    bool operator==(const Sentence& other) const = default;

    template <class Archive>
    void serialise(Archive& archive) {
        auto& [kind, text, values] = *this;
        auto number = static_cast<std::uint8_t>(kind);
        archive(number, text, values);
        kind = static_cast<Kind>(std::min(number, static_cast<std::uint8_t>(Kind::pattern)));
    }

  private:
    enum class Kind { verbatim, number, pattern };
    Sentence(Kind kind, std::string text, std::vector<Sentence> values)
        : kind_(kind), text_(std::move(text)), values_(std::move(values)) {}
    friend Sentence worded(const char* english, std::vector<Sentence> values);
    friend Sentence numeral(std::string english);

    Kind kind_ = Kind::verbatim;
    std::string text_;
    std::vector<Sentence> values_;
};

/// Returns a sentence from a pattern that the catalogues have.
Sentence worded(const char* english, std::vector<Sentence> values);
/// Returns a number written in English ("1 234.5") that is shown as the language writes it.
Sentence numeral(std::string english);
/// Returns "one; two; three".
Sentence listed(const std::vector<Sentence>& parts);

/// Returns the English texts.
std::vector<std::string> texts_of(const std::vector<Sentence>& sentences);

}  // namespace frana
