// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/ensemble/study_input.h"
#include "app/ensemble/study_result.h"
#include "app/ensemble/study_tables.h"
#include "app/store/result_directory.h"
#include "gis/vector/vector_out.h"

namespace frana::app {

/// Writes the terrain and the rasters of a study with a polygon for each member: the union of all, how many reach each
/// cell, which is the worst; of a region also those of each scenario, and the degree of hazard where it has return
/// periods. Adds the area of the union and those of the degrees to the facts.
void publish_unions(StudyInput& input, const StudyResult& result, const ResultDirectory& directory, StudyFacts& facts);

/// Writes a region's table of slopes as a layer: every release polygon, also of those that failed, with what its
/// attributes say, its status, its figures, and the outline of what it reaches.
/// @param traces the outlines of finished members
void write_slopes(const StudyInput& input, const StudyResult& result, const gis::OutlineLayer& traces,
                  const std::string& path);

}  // namespace frana::app
