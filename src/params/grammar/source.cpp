// SPDX-License-Identifier: Apache-2.0
#include "params/grammar/source.h"

#include "core/shortest_text.h"
#include "params/grammar/value_text.h"

namespace frana {

std::optional<SourceSpec> source_from_text(const std::string& text) {
    using Kind = SourceSpec::Kind;
    if (const auto number = number_from_text(text)) return SourceSpec{Kind::number, *number, ""};
    const auto colon = text.find(':');
    if (colon == std::string::npos) return std::nullopt;
    const std::string word = text.substr(0, colon), rest = trimmed(text.substr(colon + 1));
    if (rest.empty()) return std::nullopt;
    if (word == "attribute") return SourceSpec{Kind::attribute, 0, rest};
    if (word == "raster") return SourceSpec{Kind::raster, 0, rest};
    return std::nullopt;
}

std::string text_of(const SourceSpec& source) {
    switch (source.kind) {
        case SourceSpec::Kind::attribute:
            return "attribute:" + source.name;
        case SourceSpec::Kind::raster:
            return "raster:" + source.name;
        case SourceSpec::Kind::number:
            break;
    }
    return shortest_text(source.number);
}

}  // namespace frana
