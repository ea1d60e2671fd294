// SPDX-License-Identifier: Apache-2.0
#include "params/grammar/picture_text.h"

#include <cmath>
#include <utility>

#include "params/grammar/value_text.h"

namespace frana {
namespace {

std::optional<Size> page_from_text(const std::string& text) {
    constexpr double k_inch = 25.4;  // mm
    const auto at = text.find('@');
    const std::string page = text.substr(0, at);
    const bool portrait = page.ends_with("-portrait");
    const std::string name = portrait ? page.substr(0, page.size() - std::string("-portrait").size()) : page;
    const auto dots = at == std::string::npos ? std::optional<double>(150) : number_from_text(text.substr(at + 1));
    if ((name != "A4" && name != "A3") || !dots || *dots < 150 || *dots > 300) return std::nullopt;
    const auto pixels = [&](double mm) { return static_cast<int>(std::lround(mm / k_inch * *dots)); };
    Size size{pixels(name == "A4" ? 297 : 420), pixels(name == "A4" ? 210 : 297), *dots, page};
    if (portrait) std::swap(size.width, size.height);
    return size;
}

}  // namespace

std::optional<Size> size_from_text(const std::string& text) {
    if (text.starts_with("A")) return page_from_text(text);
    const auto cross = text.find('x');
    if (cross == std::string::npos) return std::nullopt;
    const auto width = integer_from_text(text.substr(0, cross)), height = integer_from_text(text.substr(cross + 1));
    const auto fits = [](std::optional<std::int64_t> side, std::int64_t least) {
        return side && *side >= least && *side <= 8000;
    };
    if (!fits(width, 640) || !fits(height, 480)) return std::nullopt;
    return Size{static_cast<int>(*width), static_cast<int>(*height)};
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
