// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/study/study_spec.h"
#include "core/error.h"
#include "params/grammar/ini_file.h"
#include "params/keys/parameter.h"

namespace frana::app::study {

/// Whether a file is a study: an INI with a section [study]. Throws Error(input) as read_ini.
bool is_study(const std::string& path);

/// Whether a file is a region: an INI with a section [region]. Throws Error(input) as read_ini.
bool is_region(const std::string& path);

/// Returns the value of a key with the paths in it absolute; of a value that the key does not accept, the value itself:
/// it is refused elsewhere.
std::string with_absolute_paths(const Parameter& parameter, const std::string& value, const std::string& folder);

/// Maps the path that a key names to another: "study.scene", "study.sampling" (a table), or a key of the scene.
using KeyedFileMap = std::function<std::string(const std::string& key, const std::string& path)>;

/// Returns a study with every path in it mapped: its scene, its table, and the files in [set] and [vary].
StudySpec with_files(StudySpec study, const KeyedFileMap& map);
/// The same of parts of a study, and of the value of one key.
std::string with_files(const std::string& key, const std::string& value, const KeyedFileMap& map);
std::vector<std::string> with_files(std::vector<std::string> set, const KeyedFileMap& map);
std::vector<Variation> with_files(std::vector<Variation> vary, const KeyedFileMap& map);
/// Returns a study whose paths are relative to a folder.
StudySpec seen_from(StudySpec study, const std::string& folder);

/// Reads a study file; relative paths become absolute, in its folder. Every problem of the file is collected: unknown
/// keys, values, distributions, keys that cannot vary, values outside a key's range. Throws Error(input) only if the
/// file is no INI.
StudyReading read_study(const std::string& path);

/// The same of a region file, as a study with a polygon for each member.
StudyReading read_region(const std::string& path);

/// The same from the entries of a study file, which may be some of them.
/// @param label the file as the user named it
StudyReading read_study_entries(const std::vector<IniEntry>& entries, const std::string& label);

/// Returns the study file with every key, its meaning and the distributions as used; reading it back gives the same.
std::string study_text(const StudySpec& study);
std::string region_text(const StudySpec& study);

/// Returns a section of such a file: "[set]", "[vary]" or those of one event; empty without entries.
std::string settings_text(const std::string& section, const std::vector<std::string>& set);
std::string variations_text(const std::string& section, const std::vector<Variation>& vary);
/// Returns the section [correlate], empty without correlations.
std::string correlations_text(const StudySpec& study);

}  // namespace frana::app::study
