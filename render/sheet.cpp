// SPDX-License-Identifier: Apache-2.0
#include "render/sheet.h"

#include <sstream>

namespace frana::render {

const TextBox& Sheet::text(const std::string& words, Point at, const TextStyle& style, Across across,
                           Upright upright) {
    texts_.push_back({words, at, style, across, upright});
    return boxes_.emplace_back(lettering_.place(words, at, style, across, upright));
}

double Sheet::lines(const std::vector<std::string>& words, Point top, const TextStyle& style, Across across) {
    for (const std::string& line : words) {
        text(line, top, style, across, Upright::top);
        top.y += line_height(style);
    }
    return top.y;
}

std::vector<std::string> Sheet::wrapped(const std::string& words, const TextStyle& style,
                                        double width) const {
    std::vector<std::string> lines;
    std::istringstream stream(words);
    std::string line;
    const auto fits = [&](const std::string& candidate) {
        return lettering_.width(candidate, style) <= width;
    };
    for (std::string word; stream >> word;) {
        if (!fits(word)) {  // shorten by whole UTF-8 characters
            while (word.size() > 1 && !fits(word + "\u2026")) {
                while (word.size() > 1 && (static_cast<unsigned char>(word.back()) & 0xC0) == 0x80)
                    word.pop_back();
                word.pop_back();
            }
            word += "\u2026";
        }
        if (line.empty()) {
            line = word;
        } else if (fits(line + " " + word)) {
            line += " " + word;
        } else {
            lines.push_back(line);
            line = word;
        }
    }
    if (!line.empty()) lines.push_back(line);
    return lines;
}

LayerImage Sheet::draw() const {
    LayerImage layer = canvas_.draw();
    for (const Text& text : texts_) {
        lettering_.write(layer, text.words, text.at, text.style, text.across, text.upright);
    }
    return layer;
}

}  // namespace frana::render
