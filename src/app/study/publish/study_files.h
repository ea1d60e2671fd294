// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "app/pictures/charts.h"
#include "app/publish/publish_pictures.h"
#include "app/store/result_directory.h"
#include "app/study/member_record.h"
#include "app/study/plan/study_input.h"
#include "app/study/pool/study_result.h"
#include "app/study/publish/study_tables.h"
#include "app/study/statistics/study_maps.h"
#include "gis/vector/vector_out.h"

namespace frana::app::study {

/// Returns the fraction of the weight of members with more than each value: a staircase.
std::vector<Point> exceedance_curve(const std::vector<double>& values, const std::vector<double>& weights);

/// Returns the charts that a study may have, in the order of the page.
std::vector<ChartTitle> study_charts();

/// Writes the terrain, the scene of the central member and the release areas of all.
void publish_study_ground(const StudyInput& input, const ResultDirectory& directory);

/// Writes all rasters of the table of result rasters that a study makes, and the outlines where the least depth of
/// output.depth-thresholds is exceeded with probabilities of 5, 50 and 95 %. Adds the error of the probabilities and
/// these areas to the facts.
void publish_study_maps(const StudyInput& input, const StudyResult& result, const ResultDirectory& directory,
                        StudyFacts& facts);

/// Writes what a frequency makes of the members: rasters of the table of result rasters, hazard curves and what they
/// are made of. Adds the areas of its return periods to the facts.
void publish_rates(const StudyInput& input, const StudyResult& result, const ResultDirectory& directory,
                   StudyFacts& facts);

/// Returns the layers of extent.gpkg that are known before the members run.
std::vector<gis::OutlineLayer> known_outlines(const StudyInput& input);

/// Writes a member's scene and maps to a folder of the result.
void write_member(const StudyInput& input, std::size_t member, const MemberRecord& record, const GridSpec& grid,
                  const ResultDirectory& directory, const std::string& folder);

/// Draws the maps and charts that the scene's output.maps and output.charts ask for, with a warning of one that could
/// not be drawn.
void draw_study(const StudyInput& input, const StudyResult& result, const std::vector<FigureSensitivity>& figures,
                const ResultDirectory& directory, RunLog& log);

}  // namespace frana::app::study
