// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "app/publish/report.h"

namespace frana::app {

// The sentences of a report's first page, each a paragraph of HTML.

/// What fails: names, volume, area, thickness; inflow; what is eroded and deposited.
std::string release_sentences(const ReportInput& input);
/// Model, laws, and each value of theirs with its origin; the source of a preset.
std::string material_sentences(const ReportInput& input);

/// Returns the comments of the scene's material preset; none without a preset, or if it cannot be read.
std::vector<std::string> preset_comments(const SceneSpec& spec);
/// Returns the origin of a key's value: "scene file", "preset bindo".
std::string origin_text(const SceneSpec& spec, const std::string& key, const Words& words);

/// Returns "<p><b>What fails.</b> ...</p>"; the texts are escaped.
std::string paragraph(const std::string& lead, const std::string& text);

}  // namespace frana::app
