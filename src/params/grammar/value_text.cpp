// SPDX-License-Identifier: Apache-2.0
#include "params/grammar/value_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

namespace frana {
namespace {

std::string_view without_section(std::string_view name) {
    const auto dot = name.find('.');
    return dot == std::string_view::npos ? name : name.substr(dot + 1);
}

}  // namespace

int edit_distance(std::string_view a, std::string_view b) {
    const std::size_t width = b.size() + 1;
    std::vector<int> table((a.size() + 1) * width);
    const auto cell = [&](std::size_t i, std::size_t j) -> int& { return table[i * width + j]; };
    for (std::size_t i = 0; i <= a.size(); ++i) cell(i, 0) = static_cast<int>(i);
    for (std::size_t j = 0; j <= b.size(); ++j) cell(0, j) = static_cast<int>(j);
    for (std::size_t i = 1; i <= a.size(); ++i) {
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const int replace = cell(i - 1, j - 1) + (a[i - 1] == b[j - 1] ? 0 : 1);
            cell(i, j) = std::min({cell(i - 1, j) + 1, cell(i, j - 1) + 1, replace});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                cell(i, j) = std::min(cell(i, j), cell(i - 2, j - 2) + 1);
        }
    }
    return cell(a.size(), b.size());
}

std::string nearest_name(const std::string& name, const std::vector<std::string>& known) {
    std::string best;
    // Up to a third of the letters wrong is a misspelling; more is another word.
    int best_distance = std::max<int>(2, static_cast<int>(without_section(name).size()) / 3) + 1;
    // A distance is at least the difference of the lengths, so that names of any length cost nothing.
    const auto distance_within = [&](std::string_view a, std::string_view b) {
        const auto lengths = static_cast<std::size_t>(best_distance) + std::min(a.size(), b.size());
        return lengths <= std::max(a.size(), b.size()) ? best_distance : edit_distance(a, b);
    };
    for (const std::string& candidate : known) {
        // A key of another section (or of none) is compared without its section, which counts as one error.
        const int elsewhere = distance_within(without_section(name), without_section(candidate)) + 1;
        const int distance = std::min(distance_within(name, candidate), elsewhere);
        if (distance < best_distance) {
            best = candidate;
            best_distance = distance;
        }
    }
    return best;
}

namespace {

template <class Number>
std::optional<Number> whole_text(const std::string& text) {
    const bool plus = text.size() > 1 && text[0] == '+' && text[1] != '-';  // from_chars does not accept a leading plus
    const std::string body = plus ? text.substr(1) : text;
    Number value{};
    const char* const end = body.data() + body.size();
    const auto result = std::from_chars(body.data(), end, value);
    if (result.ec != std::errc{} || result.ptr != end) return std::nullopt;
    return value;
}

}  // namespace

std::string trimmed(const std::string& text) {
    static constexpr char k_white[] = " \t\r\n";
    const auto first = text.find_first_not_of(k_white);
    if (first == std::string::npos) return {};
    return text.substr(first, text.find_last_not_of(k_white) - first + 1);
}

std::optional<double> number_from_text(const std::string& text) {
    const auto value = whole_text<double>(text);
    if (value && !std::isfinite(*value)) return std::nullopt;
    return value;
}

std::string comma_remedy(const std::string& text) {
    const std::size_t comma = text.find(',');
    const bool is_number = comma != text.npos && number_from_text(text.substr(0, comma) + '.' + text.substr(comma + 1));
    return is_number ? "Write the decimals after a point, not a comma" : "";
}

std::optional<std::int64_t> integer_from_text(const std::string& text) {
    return whole_text<std::int64_t>(text);
}

std::optional<bool> boolean_from_text(const std::string& text) {
    if (text == "on" || text == "true" || text == "yes" || text == "1") return true;
    if (text == "off" || text == "false" || text == "no" || text == "0") return false;
    return std::nullopt;
}

std::vector<std::string> words_of(const std::string& text) {
    std::vector<std::string> words;
    std::string word;
    for (const char c : text + ",") {
        if (c != ',' && c != ' ' && c != '\t') {
            word += c;
        } else if (!word.empty()) {
            words.push_back(word);
            word.clear();
        }
    }
    return words;
}

std::string joined(const std::vector<std::string>& words, const std::string& separator) {
    std::string text;
    for (const std::string& word : words) {
        if (!text.empty()) text += separator;
        text += word;
    }
    return text;
}

namespace {

/// A sheet [mm].
struct Paper {
    const char* name;
    double longer, shorter;
};
constexpr Paper k_papers[] = {{"A4", 297, 210}, {"A3", 420, 297}};
constexpr const char* k_directions[] = {"-portrait", "-landscape"};

std::optional<Size> page_from_text(const std::string& text) {
    constexpr double k_inch = 25.4;  // mm
    const auto at = text.find('@');
    const std::string page = text.substr(0, at);
    const std::string name = page.substr(0, page.find('-')), direction = page.substr(name.size());
    const auto dots = at == std::string::npos ? std::optional<double>(150) : number_from_text(text.substr(at + 1));
    const auto paper =
        std::find_if(std::begin(k_papers), std::end(k_papers), [&](const Paper& p) { return name == p.name; });
    if (paper == std::end(k_papers) || !dots || *dots < 150 || *dots > 300) return std::nullopt;
    if (!direction.empty() &&
        std::find(std::begin(k_directions), std::end(k_directions), direction) == std::end(k_directions))
        return std::nullopt;
    const auto pixels = [&](double mm) { return static_cast<int>(std::lround(mm / k_inch * *dots)); };
    Size size{pixels(paper->longer), pixels(paper->shorter), *dots, page, direction.empty()};
    if (direction == k_directions[0]) std::swap(size.width, size.height);
    return size;
}

}  // namespace

std::string paper_names() {
    std::vector<std::string> names;
    for (const Paper& paper : k_papers) names.emplace_back(paper.name);
    for (const Paper& paper : k_papers)
        for (const char* direction : k_directions) names.push_back(std::string(paper.name) + direction);
    return joined(names, ", ");
}

std::string size_forms() {
    return "auto, WIDTHxHEIGHT, 640x480 to 8000x8000, or " + paper_names() +
           ", with @DPI (150 to 300; 150 where absent)";
}

std::optional<Size> size_from_text(const std::string& text) {
    if (text == "auto" || text.starts_with("A")) return page_from_text(text == "auto" ? "A4" : text);
    const auto cross = text.find('x');
    if (cross == std::string::npos) return std::nullopt;
    const auto width = integer_from_text(text.substr(0, cross)), height = integer_from_text(text.substr(cross + 1));
    const auto fits = [](std::optional<std::int64_t> side, std::int64_t least) {
        return side && *side >= least && *side <= 8000;
    };
    if (!fits(width, 640) || !fits(height, 480)) return std::nullopt;
    return Size{static_cast<int>(*width), static_cast<int>(*height)};
}

Size size_for_ground(Size size, double width, double height) {
    constexpr double k_upright = 1.25;
    if (!size.turns || !(height > k_upright * width)) return size;
    std::swap(size.width, size.height);
    if (is_paper(size)) size.paper += "-portrait";
    return size;
}

std::optional<CameraText> camera_from_text(const std::string& text) {
    const std::vector<std::string> words = words_of(text);
    if (words.size() < 2 || words.size() > 3) return std::nullopt;
    const auto azimuth = number_from_text(words[0]), elevation = number_from_text(words[1]),
               zoom = words.size() == 3 ? number_from_text(words[2]) : 1.0;
    const auto within = [](std::optional<double> value, double least, double most) {
        return value && *value >= least && *value <= most;
    };
    if (!within(azimuth, 0, 360) || !within(elevation, 1, 89) || !within(zoom, 0.1, 20)) return std::nullopt;
    return CameraText{*azimuth, *elevation, *zoom};
}

}  // namespace frana
