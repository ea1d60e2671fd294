// SPDX-License-Identifier: Apache-2.0
#include "core/colour.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/error.h"

namespace frana {
namespace {

// Anchors of viridis, inferno and plasma (all CC0) at equal steps, from the light end. Inferno's palest tone would be
// invisible on a white hillside and is replaced.
const std::array<Palette, 4>& palettes() {
    static const std::array<Palette, 4> all{
        Palette{"depth",
                {{253, 231, 37},
                 {173, 220, 48},
                 {94, 201, 98},
                 {40, 174, 128},
                 {33, 145, 140},
                 {44, 114, 142},
                 {59, 82, 139},
                 {71, 45, 123},
                 {68, 1, 84}}},
        Palette{"velocity",
                {{253, 236, 138},
                 {249, 201, 50},
                 {249, 142, 9},
                 {227, 89, 51},
                 {188, 55, 84},
                 {138, 34, 106},
                 {87, 16, 110},
                 {33, 12, 74}}},
        Palette{"time",
                {{240, 249, 33},
                 {254, 188, 43},
                 {244, 136, 73},
                 {219, 92, 104},
                 {185, 50, 137},
                 {139, 10, 165},
                 {84, 2, 163},
                 {13, 8, 135}}},
        // Dark blue over a pale middle to vermilion; the blue end is far darker, so that signs differ in grey as well.
        Palette{"difference",
                {{3, 15, 60},
                 {26, 70, 140},
                 {90, 145, 200},
                 {185, 212, 235},
                 {247, 246, 240},
                 {252, 222, 178},
                 {250, 180, 95},
                 {238, 130, 40},
                 {200, 80, 5}}},
    };
    return all;
}

}  // namespace

Rgb colour_at(const Palette& palette, double t) {
    const std::vector<Rgb>& anchors = palette.anchors;
    const double place = std::clamp(std::isnan(t) ? 0.0 : t, 0.0, 1.0) * static_cast<double>(anchors.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(place), anchors.size() - 2);
    const double fraction = place - static_cast<double>(below);
    const auto mix = [fraction](std::uint8_t a, std::uint8_t b) {
        return static_cast<std::uint8_t>(std::lround(a + fraction * (b - a)));
    };
    const Rgb &a = anchors[below], &b = anchors[below + 1];
    return {mix(a.r, b.r), mix(a.g, b.g), mix(a.b, b.b)};
}

const Palette& palette(const std::string& name) {
    std::string known;
    for (const Palette& candidate : palettes()) {
        if (candidate.name == name) return candidate;
        known += (known.empty() ? "" : ", ") + candidate.name;
    }
    throw Error(ErrorKind::input, Problem{"unknown palette", "", name, known, ""});
}

std::vector<double> nice_classes(double maximum, int classes) {
    if (!(maximum > 0) || !std::isfinite(maximum)) return {0, 1};
    const int wanted = std::max(classes, 1);
    int exponent = static_cast<int>(std::floor(std::log10(maximum / wanted))) - 1;
    for (;; ++exponent) {
        for (const int factor : {1, 2, 5}) {
            // Dividing by a power of ten gives the double nearest to the decimal number; multiplying by 0.1
            // would not.
            const auto bound = [&](int k) {
                const double whole = static_cast<double>(factor) * k;
                return exponent < 0 ? whole / std::pow(10.0, -exponent) : whole * std::pow(10.0, exponent);
            };
            if (bound(wanted) < maximum) continue;
            std::vector<double> bounds;
            for (int k = 0; bounds.empty() || bounds.back() < maximum; ++k) bounds.push_back(bound(k));
            return bounds;
        }
    }
}

}  // namespace frana
