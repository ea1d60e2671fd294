// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "study/read_study.h"

namespace frana::study {

/// Whether a file is a region: an INI with a section [region]. Throws Error(input) as read_ini.
bool is_region(const std::string& path);

/// Reads a region file as a study with a polygon for each member. Every problem of the file is collected, as by
/// read_study. Throws Error(input) only if the file is no INI.
StudyReading read_region(const std::string& path);

/// Returns the region file as used, with every key and its meaning; reading it back gives the same.
std::string region_text(const StudySpec& study);

}  // namespace frana::study
