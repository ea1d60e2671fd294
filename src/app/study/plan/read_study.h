// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/study/study_spec.h"
#include "core/error.h"
#include "params/grammar/ini_file.h"
#include "params/keys/parameter.h"

namespace frana::app::study {

/// Returns the kind of a study's file, an INI with a section [study], [region], [objective] or [event NAME]; none: it
/// is a scene. Throws Error(input) as read_ini.
std::optional<StudyKind> study_kind(const std::string& path);

/// Reads a study of some kind; relative paths become absolute, in its folder. Every problem of the file is collected,
/// each once: unknown keys, values, distributions, keys that cannot vary, values outside a key's range. Throws
/// Error(input) only if the file is no INI.
StudyReading read_study(const std::string& path, StudyKind kind = StudyKind::ensemble);

/// Returns the file with every key, its meaning and the distributions as used; reading it back gives the same.
std::string study_text(const StudySpec& study);

/// Makes the volumes of a frequency the first key that varies, and of the first return period the rate. Returns what is
/// wrong with the rate that was given.
std::optional<Problem> vary_volumes(StudySpec& study);
/// Why volumes hardly cover a release of so many m2: they are in thousands of m3.
std::optional<Problem> thin_volumes(const FrequencySpec& frequency, double area, const Place& where);
/// What decides the maps of rates besides the members.
std::string frequency_text(const StudySpec& study);
/// Whether a key of [columns] is one of [frequency].
bool is_of_frequency(const std::string& key);

inline constexpr std::int64_t k_last_seed = 2'147'483'647;

/// Reads "35 +- 5": a number and its standard deviation, 0 if none is stated; NaN for what is no number, and for a
/// deviation that is not greater than 0.
std::pair<double, double> number_and_deviation(const std::string& text);

/// The keys of a kind of study, each in a section of its own; parser, messages and echo follow from them.
const std::vector<ParameterOf<StudySpec>>& study_keys(StudyKind kind);

/// Returns the value of a key with the paths in it absolute; of a value that the key does not accept, the value itself:
/// it is refused elsewhere.
std::string with_absolute_paths(const Parameter& parameter, const std::string& value, const std::string& folder);

/// Maps the path that a key names to another: "study.scene", "study.sampling" (a table), or a key of the scene.
using KeyedFileMap = std::function<std::string(const std::string& key, const std::string& path)>;

/// Returns a study with every path in it mapped: its scenes, its table, and the files in [set] and [vary].
StudySpec with_files(StudySpec study, const KeyedFileMap& map);
/// The same of the value of one key.
std::string with_files(const std::string& key, const std::string& value, const KeyedFileMap& map);
/// Such a map: the file's name alone, so that a study can be moved.
std::string without_folder(const std::string& key, const std::string& path);
/// Returns a study whose paths are relative to a folder.
StudySpec seen_from(StudySpec study, const std::string& folder);

}  // namespace frana::app::study
