// SPDX-License-Identifier: Apache-2.0
#include "app/pictures/letter_warning.h"

#include "render/canvas/text_line.h"

namespace frana::app {

std::string letter_warning() {
    const std::vector<std::string> letters = render::take_letters_without_font();
    if (letters.empty()) return {};
    constexpr std::size_t k_named = 10;
    std::string named;
    for (std::size_t i = 0; i < letters.size() && i < k_named; ++i) named += (i > 0 ? " " : "") + letters[i];
    if (letters.size() > k_named) named += " and " + std::to_string(letters.size() - k_named) + " more";
    return "no installed font has the letters " + named +
           ": pictures show boxes in their place. Install a font that has them, for example Debian's fonts-noto-core "
           "or "
           "fonts-noto-cjk, and draw again with frana render";
}

}  // namespace frana::app
