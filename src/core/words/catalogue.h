// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "core/words/language.h"

namespace frana {

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

}  // namespace frana
