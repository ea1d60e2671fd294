// SPDX-License-Identifier: Apache-2.0
#include "params/keys/thickness.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/raster.h"
#include "core/text.h"
#include "params/grammar/value_text.h"
#include "params/keys/declare.h"
#include "params/keys/scene_spec.h"

namespace frana {
namespace {

using Values = std::span<const double>;

double lowered(double above, double below) {
    const double metres = above - below;
    return std::isnan(metres) ? k_no_data : std::max(metres, 0.0);
}

constexpr ThicknessKind k_kinds[] = {
    {.word = "attribute", .operands = "NAME", .from_files = false},
    {.word = "raster", .operands = "FILE", .as_in_file = true, .metres = [](double, Values file) { return file[0]; }},
    {.word = "difference",
     .operands = "PRE,POST",
     .elevations = true,
     .metres = [](double, Values files) { return lowered(files[0], files[1]); }},
    {.word = "slip-surface",
     .operands = "FILE",
     .elevations = true,
     .below_dtm = true,
     .without_operands = true,
     .metres = [](double dtm, Values file) { return lowered(dtm, file[0]); }},
    {.word = "phases", .operands = "SOLIDS,FLUID", .phases = true}};

std::optional<ThicknessSpec> thickness_from_text(const std::string& text) {
    if (const auto number = number_from_text(text)) return ThicknessSpec{nullptr, *number};
    const auto colon = text.find(':');
    const std::string word = text.substr(0, colon);
    const auto* const kind = std::find_if(std::begin(k_kinds), std::end(k_kinds),
                                          [&](const ThicknessKind& one) { return one.word == word; });
    if (kind == std::end(k_kinds)) return std::nullopt;
    ThicknessSpec spec{kind};
    if (colon == std::string::npos) return kind->without_operands ? std::optional(spec) : std::nullopt;
    std::string rest = text.substr(colon + 1);
    const std::string operands = kind->operands;
    for (auto left = std::count(operands.begin(), operands.end(), ','); left > 0; --left) {
        const auto comma = rest.find(',');
        if (comma == std::string::npos) return std::nullopt;
        spec.names.push_back(trimmed(rest.substr(0, comma)));
        rest.erase(0, comma + 1);
    }
    spec.names.push_back(trimmed(rest));
    const bool complete =
        std::none_of(spec.names.begin(), spec.names.end(), [](const auto& one) { return one.empty(); });
    return complete ? std::optional(spec) : std::nullopt;
}

}  // namespace

std::string thickness_forms() {
    std::string forms = "a number greater than 0";
    for (const ThicknessKind& kind : k_kinds) {
        forms += std::string(", ") + kind.word + ":" + kind.operands;
        if (kind.without_operands) forms += std::string(", ") + kind.word;
    }
    return forms;
}

std::string text_of(const ThicknessSpec& thickness) {
    if (thickness.kind == nullptr) return shortest_text(thickness.metres);
    return thickness.kind->word + (thickness.names.empty() ? "" : ":" + joined(thickness.names, ","));
}

Parameter thickness_parameter() {
    Parameter result = declare::parameter(
        "release.thickness", "text", FRANA_MEMBER(release.thickness),
        [](std::optional<ThicknessSpec>& target, const std::string& value) -> std::optional<ValueProblem> {
            const auto spec = thickness_from_text(value);
            if (!spec) return ValueProblem{"is not understood", comma_remedy(value)};
            if (spec->kind == nullptr && !(spec->metres > 0))
                return ValueProblem{"is not a thickness", "It must be greater than 0 m"};
            target = spec;
            return std::nullopt;
        },
        [](const ThicknessSpec& thickness) { return text_of(thickness); });
    result.unit = "m";
    result.limits = thickness_forms();
    result.range = NumberRange{0, std::numeric_limits<double>::max(), true};
    for (const ThicknessKind& kind : k_kinds)
        if (kind.without_operands) result.choices.emplace_back(kind.word);
    result.meaning =
        "Thickness of the release: a number, a column of the perimeter, a raster, a DTM before minus one after, the "
        "DTM minus a slip surface (a raster, or fitted to each polygon); structured model: depths of solids and of "
        "fluid.";
    result.absent = "required, unless there is an inflow";
    result.map_files = [](SceneSpec& scene, const FileMap& map) {
        auto& thickness = scene.release.thickness;
        if (!thickness || !thickness->by_raster()) return;
        for (std::string& file : thickness->names) file = map(file);
    };
    return result;
}

}  // namespace frana
