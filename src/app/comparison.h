// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "analysis/scores.h"
#include "app/map_source.h"
#include "app/run_log.h"

namespace frana::app {

/// What is compared.
struct ComparisonInput {
    Raster depth;               ///< greatest depth; NaN: never reached
    MultiPolygon scar;          ///< in the depth's CRS
    double threshold = 0;       ///< [m]
    std::string depth_label;    ///< for the file: what was simulated
    std::string scar_label;     ///< and observed
    std::optional<Raster> bed;  ///< for the run-outs; none: not compared
    std::optional<Raster> release;
};

struct Comparison {
    ComparisonFigures figures;
    std::optional<double> runout_difference_m;  ///< simulated less observed
    Raster classes;                             ///< values of Agreement
};

/// Rasterises the scar and compares. Ground outside the depth's grid that the scar covers counts as missed.
Comparison compare_with_scar(const ComparisonInput& input, RunLog& log);

std::string comparison_json(const Comparison& comparison, const ComparisonInput& input);

/// comparison.json and comparison.tif with its styles. `path_of` gives a file's place. Throws Error.
void write_comparison(const Comparison& comparison, const ComparisonInput& input, const std::string& folder);

/// comparison.png.
void draw_comparison(const Comparison& comparison, MapSource source, const std::string& path);

}  // namespace frana::app
