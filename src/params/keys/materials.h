// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "params/grammar/ini_file.h"

namespace frana {

/// A file of share/materials: keys of [material] and their sources.
struct MaterialPreset {
    std::string name;  ///< file name without .ini
    std::string file;
    std::vector<std::string> comments;  ///< source and range of validity, line by line
    std::vector<IniEntry> entries;
};

/// Returns the presets of a folder in alphabetical order. Throws Error(input) for a preset that cannot be read,
/// Error(environment) if the folder is missing.
std::vector<MaterialPreset> material_presets(const std::string& directory);

/// Returns the comments as paragraphs, each a text of the catalogues: one begins with each label of one word, such
/// as "Source: ".
std::vector<std::string> paragraphs_of(const std::vector<std::string>& comments);

}  // namespace frana
