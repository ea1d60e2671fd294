// SPDX-License-Identifier: Apache-2.0
#include "params/grammar/thickness.h"

#include "core/text.h"
#include "params/grammar/value_text.h"

namespace frana {

std::optional<ThicknessSpec> thickness_from_text(const std::string& text) {
    using Kind = ThicknessSpec::Kind;
    ThicknessSpec spec;
    if (text == "slip-surface") {
        spec.kind = Kind::slip_surface;
        return spec;
    }
    if (const auto number = number_from_text(text)) {
        spec.metres = *number;
        return spec;
    }
    const auto colon = text.find(':');
    if (colon == std::string::npos) return std::nullopt;
    const std::string word = text.substr(0, colon), rest = trimmed(text.substr(colon + 1));
    if (rest.empty()) return std::nullopt;
    if (word == "attribute") {
        spec.kind = Kind::attribute;
        spec.attribute = rest;
    } else if (word == "raster") {
        spec.kind = Kind::raster;
        spec.raster = rest;
    } else if (word == "slip-surface") {
        spec.kind = Kind::slip_surface;
        spec.raster = rest;
    } else if (word == "difference" || word == "phases") {
        const auto comma = rest.find(',');
        if (comma == std::string::npos) return std::nullopt;
        spec.kind = word == "phases" ? Kind::phases : Kind::difference;
        spec.raster = trimmed(rest.substr(0, comma));
        spec.post = trimmed(rest.substr(comma + 1));
        if (spec.raster.empty() || spec.post.empty()) return std::nullopt;
    } else {
        return std::nullopt;
    }
    return spec;
}

std::string text_of(const ThicknessSpec& thickness) {
    using Kind = ThicknessSpec::Kind;
    switch (thickness.kind) {
        case Kind::attribute:
            return "attribute:" + thickness.attribute;
        case Kind::raster:
            return "raster:" + thickness.raster;
        case Kind::difference:
            return "difference:" + thickness.raster + "," + thickness.post;
        case Kind::phases:
            return "phases:" + thickness.raster + "," + thickness.post;
        case Kind::slip_surface:
            return thickness.fitted() ? "slip-surface" : "slip-surface:" + thickness.raster;
        case Kind::number:
            break;
    }
    return shortest_text(thickness.metres);
}

}  // namespace frana
