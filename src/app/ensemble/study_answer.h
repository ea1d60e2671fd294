// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "app/ensemble/study_tables.h"
#include "core/words/words.h"

namespace frana::app {

/// The first page of a study's report, as HTML: what fails, what varies, where it goes in how many of the runs, how
/// sure that is. Of sources that fail alone: what at least one of them reaches.
std::string study_answer(const StudyInput& input, const StudyResult& result, const StudyFacts& facts,
                         const Words& words);

/// The figures of the runs with their mean and quantiles; of a region the areas of the degrees of hazard.
std::string study_values(const StudyInput& input, const StudyResult& result, const StudyFacts& facts,
                         const Words& words);

/// The sources of a study in which each fails alone, those that come farthest first; empty for others.
std::string study_sources(const StudyInput& input, const StudyResult& result, const Words& words);

}  // namespace frana::app
