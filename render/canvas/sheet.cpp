// SPDX-License-Identifier: Apache-2.0
#include "render/canvas/sheet.h"

#include <algorithm>
#include <array>
#include <sstream>
#include <utility>

#include "core/text.h"

namespace frana::render {

void Overlay::rasterise() const {
    if (content_->has_pixels) return;
    Canvas canvas(content_->width, content_->height);
    for (const Shape& one : content_->shapes) {
        if (one.kind == Shape::Kind::area)
            canvas.fill(one.points, one.style.colour, one.style.opacity);
        else if (one.kind == Shape::Kind::frame)
            canvas.frame({one.points[0].x, one.points[0].y, one.points[1].x, one.points[1].y}, one.style);
        else
            canvas.line(one.points, one.style, one.kind == Shape::Kind::ring);
    }
    content_->pixels = canvas.draw();
    content_->has_pixels = true;
}

void Overlay::put(Image& page, int left, int top) const {
    rasterise();
    compose(page, content_->pixels, left, top);
    for (const Text& text : content_->texts) blend(page, text.glyphs, text.style, left, top);
}

Sheet::Sheet(int width, int height) : content_(std::make_shared<Overlay::Content>()) {
    content_->width = width;
    content_->height = height;
}

void Sheet::line(std::span<const Point> points, const LineStyle& style, bool closed) {
    content_->shapes.push_back(
        {closed ? Overlay::Shape::Kind::ring : Overlay::Shape::Kind::line, {points.begin(), points.end()}, style});
}

void Sheet::fill(std::span<const Point> corners, Rgb colour, double opacity) {
    content_->shapes.push_back(
        {Overlay::Shape::Kind::area, {corners.begin(), corners.end()}, LineStyle{0, colour, opacity}});
}

void Sheet::fill(const PageBox& box, Rgb colour, double opacity) {
    fill(
        std::array<Point, 4>{
            {{box.left, box.top}, {box.right, box.top}, {box.right, box.bottom}, {box.left, box.bottom}}},
        colour, opacity);
}

void Sheet::frame(const PageBox& box, const LineStyle& style) {
    content_->shapes.push_back({Overlay::Shape::Kind::frame, {{box.left, box.top}, {box.right, box.bottom}}, style});
}

void Sheet::text(const std::string& words, Point at, const TextStyle& style, Across across, Upright upright) {
    content_->texts.push_back({words, at, style, across, upright, lettering_.set(words, at, style, across, upright)});
    boxes_.push_back(text_box(words, content_->texts.back().glyphs, style));
}

Overlay Sheet::take() {
    auto rest = std::make_shared<Overlay::Content>();
    rest->width = content_->width;
    rest->height = content_->height;
    return Overlay(std::exchange(content_, std::move(rest)));
}

namespace {

constexpr std::size_t k_paragraph_letters = 2000;  // of a paragraph
constexpr std::size_t k_longest_line = 500;        // bytes; longer lines need not be measured

/// Whether a word must not begin a line after another: groups of a number's digits, and the unit of a number.
bool belongs_to(const std::string& before, const std::string& word) {
    static const std::array<std::string, 16> k_units{"m",   "m\u00B2",    "m\u00B3", "m/s", "m\u00B2/s", "m/s\u00B2",
                                                     "s",   "%",          "kPa",     "Pa",  "km",        "cm",
                                                     "min", "kg/m\u00B3", "\u00B0",  "h"};
    const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
    if (before.empty() || !is_digit(before.back())) return false;
    std::string bare = word;  // without the sign that ends a clause
    while (!bare.empty() && (bare.back() == ',' || bare.back() == ';' || bare.back() == '.')) bare.pop_back();
    const bool group = bare.size() >= 3 && std::all_of(bare.begin(), bare.begin() + 3, is_digit) &&
                       (bare.size() == 3 || bare[3] == '.');
    return group || std::find(k_units.begin(), k_units.end(), bare) != k_units.end();
}

}  // namespace

double Sheet::lines(const std::vector<std::string>& words, Point top, const TextStyle& style, Across across) {
    for (const std::string& line : words) {
        text(line, top, style, across, Upright::top);
        top.y += line_height(style);
    }
    return top.y;
}

std::vector<std::string> Sheet::wrapped(const std::string& words, const TextStyle& style, double width) const {
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
    std::istringstream stream(elided(valid_utf8(words), k_paragraph_letters));
    for (std::string word; stream >> word;) {
        const std::string joint = parts.empty() ? word : parts.back() + " " + word;
        if (!parts.empty() && belongs_to(parts.back(), word) && fits(joint))
            parts.back() = joint;
        else
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
