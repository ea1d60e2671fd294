// SPDX-License-Identifier: Apache-2.0
#include "render/canvas/drawing.h"

#include <array>
#include <sstream>

#include "core/utf8.h"

namespace frana::render {
namespace {

constexpr std::size_t k_most_letters = 2000;  // of a paragraph
constexpr std::size_t k_longest_line = 500;   // bytes; longer lines need not be measured

}  // namespace

void Drawing::fill(const PageBox& box, Rgb colour, double opacity) {
    fill(
        std::array<Point, 4>{
            {{box.left, box.top}, {box.right, box.top}, {box.right, box.bottom}, {box.left, box.bottom}}},
        colour, opacity);
}

double Drawing::lines(const std::vector<std::string>& words, Point top, const TextStyle& style, Across across) {
    for (const std::string& line : words) {
        text(line, top, style, across, Upright::top);
        top.y += line_height(style);
    }
    return top.y;
}

std::vector<std::string> Drawing::wrapped(const std::string& words, const TextStyle& style, double width) const {
    const auto fits = [&](const std::string& candidate) {
        return candidate.size() <= k_longest_line && lettering_.width(candidate, style) <= width;
    };
    // The longest part that fits is found by bisection: measuring a text is expensive.
    const auto cut = [&](const std::string& word) {
        std::size_t good = 1, bad = word.size() + 1;  // characters, with the ellipsis
        while (good + 1 < bad) {
            const std::size_t middle = (good + bad) / 2;
            (fits(elided(word, middle)) ? good : bad) = middle;
        }
        return elided(word, good);
    };
    std::vector<std::string> lines, parts;
    std::istringstream stream(elided(valid_utf8(words), k_most_letters));
    for (std::string word; stream >> word;) {
        parts.push_back(fits(word) ? std::move(word) : cut(word));
    }
    // The number of words that fit on each line, likewise.
    for (std::size_t first = 0; first < parts.size();) {
        const auto line = [&](std::size_t end) {
            std::string all = parts[first];
            for (std::size_t i = first + 1; i < end; ++i) all += " " + parts[i];
            return all;
        };
        std::size_t good = first + 1, bad = parts.size() + 1;
        if (fits(line(parts.size()))) good = parts.size();
        while (good + 1 < bad) {
            const std::size_t middle = (good + bad) / 2;
            (fits(line(middle)) ? good : bad) = middle;
        }
        lines.push_back(line(good));
        first = good;
    }
    return lines;
}

}  // namespace frana::render
