// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "app/ensemble/study_input.h"
#include "app/ensemble/study_result.h"
#include "app/ensemble/study_tables.h"
#include "app/store/result_directory.h"
#include "gis/vector/vector_out.h"
#include "study/member_record.h"
#include "study/study_maps.h"

namespace frana::app {

/// Writes the terrain, the scene of the central member and the release areas of all.
void publish_study_ground(const StudyInput& input, const ResultDirectory& directory);

/// Writes all rasters of the table of result rasters that a study makes, and the outlines where the least depth of
/// output.depth-thresholds is exceeded with probabilities of 5, 50 and 95 %. Adds the error of the probabilities and
/// these areas to the facts.
void publish_study_maps(const StudyInput& input, const StudyResult& result, const ResultDirectory& directory,
                        StudyFacts& facts);

/// Returns the layers of extent.gpkg that are known before the members run.
std::vector<gis::OutlineLayer> known_outlines(const StudyInput& input);

/// Writes a member's scene and maps to a folder of the result.
void write_member(const StudyInput& input, std::size_t member, const study::MemberRecord& record, const GridSpec& grid,
                  const ResultDirectory& directory, const std::string& folder);

/// Loads what draw_study() and film_member() draw with, before the members run. Throws Error(environment) if it is
/// missing.
void load_study_drawing(const StudyInput& input);

/// Draws the maps and charts that the scene's output.maps and output.charts ask for. Returns false if one could not be
/// drawn, with a warning.
bool draw_study(const StudyInput& input, const StudyResult& result, const std::vector<FigureSensitivity>& figures,
                const ResultDirectory& directory, RunLog& log);

}  // namespace frana::app
