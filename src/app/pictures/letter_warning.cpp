// SPDX-License-Identifier: Apache-2.0
#include "app/pictures/letter_warning.h"

#include "render/canvas/text_line.h"

namespace frana::app {

std::optional<Sentence> letter_warning() {
    const std::vector<std::string> letters = render::take_letters_without_font();
    if (letters.empty()) return std::nullopt;
    constexpr std::size_t k_named = 10;
    std::string named;
    for (std::size_t i = 0; i < letters.size() && i < k_named; ++i) named += (i > 0 ? " " : "") + letters[i];
    const Sentence all = letters.size() > k_named
                             ? worded("{1} and {2} more", {named, std::to_string(letters.size() - k_named)})
                             : Sentence(named);
    return worded(
        "no installed font has the letters {1}: pictures show boxes in their place. Install a font that has them, for "
        "example Debian's fonts-noto-core or fonts-noto-cjk, and draw again with frana render",
        {all});
}

}  // namespace frana::app
