// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "core/words/words.h"
#include "params/keys/parameter.h"
#include "params/keys/scene_spec.h"

namespace frana {

/// Returns the file formats of maps, which are the endings of their files: "png", "pdf", "svg".
const std::vector<std::string>& picture_formats();

/// Formats of the generalised zones of hazard, besides GeoPackage; also the endings of their files.
inline constexpr const char* k_zone_formats[] = {"shp", "kmz", "dxf"};
/// Whether output.formats has a word.
inline bool has_format(const OutputSpec& output, const std::string& word) {
    return std::find(output.formats.begin(), output.formats.end(), word) != output.formats.end();
}
/// Whether the particles of each frame are written.
inline bool writes_particles(const OutputSpec& output) {
    return has_format(output, "particles-gpkg");
}

/// Adds the keys of [output] for the appearance of maps, views and charts.
void add_pictures(std::vector<Parameter>& list);

/// Largest map [cells] whose rasters cover it all with output.extent = auto.
inline constexpr std::int64_t k_largest_whole_map = 1'000'000;

/// Adds the keys of [output] beyond maps, frames and animation: names, report, gauges, cross-sections, profiles.
void add_extra_output(std::vector<Parameter>& list);
/// Adds the keys of [hazard].
void add_hazard(std::vector<Parameter>& list);
/// Adds the keys of [exposure].
void add_exposure(std::vector<Parameter>& list);
/// Adds the keys of [scar] for surveyed data besides the outline.
void add_survey(std::vector<Parameter>& list);

/// Replaces `auto` by the language of this process.
inline void resolve_language(SceneSpec& scene) {
    if (scene.output.language == k_language_of_locale) scene.output.language = language_code(process_language());
}

/// Returns the words of a scene's pictures and report, with those of its hazard scheme and friction table.
inline Words words_of(const SceneSpec& scene) {
    Words words(language_of_code(scene.output.language).value_or(process_language()));
    if (scene.hazard.resolved) words = words.with(scene.hazard.resolved->texts);
    return scene.friction_table.resolved ? words.with(scene.friction_table.resolved->texts) : words;
}

}  // namespace frana
