// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "analysis/scores.h"
#include "app/input/prepare.h"
#include "app/input/survey_input.h"
#include "app/pictures/map_source.h"
#include "app/text/run_log.h"

namespace frana::app {

/// Input of a comparison.
struct ComparisonInput {
    Raster depth;               ///< greatest depth; NaN: never reached
    Survey survey;              ///< in the depth's CRS
    double threshold = 0;       ///< [m]
    std::string depth_label;    ///< for the file: name of the simulated data
    std::optional<Raster> bed;  ///< for the run-outs; none: not compared
    std::optional<Raster> release;
    std::vector<Point> inflows;              ///< places where material flows in, or of flows that have such a place
    std::optional<Raster> final_depth;       ///< vertical, for a deposit's outline; none: not compared
    std::optional<Raster> elevation_change;  ///< for a surveyed one; likewise
    std::map<std::string, std::string> metadata;
    Words words{};  ///< of the style
};

/// A surveyed front against the simulated outline. Distances are positive where the simulation extends beyond the
/// front, negative where it does not reach it.
struct FrontComparison {
    std::string name;
    double mean_m = 0;           ///< signed
    LineDistance size;           ///< of the absolute distances, over the front's length
    double reached_percent = 0;  ///< fraction of the front's length inside the simulated trace
};

/// A surveyed tip: its distance from the simulated outline, with the same sign.
struct TipComparison {
    std::string name;
    double distance_m = 0;
};

/// Run-out along the flow path, from the top of the release [m].
struct PathRunout {
    double simulated_m = 0, observed_m = 0;
};

struct Comparison {
    std::optional<ComparisonStatistics> statistics;  ///< none: no area was surveyed
    std::vector<ComparisonStatistics> curve;         ///< over the depth threshold
    std::optional<LineDistance> outline;
    std::optional<double> runout_difference_m;  ///< simulated minus observed
    std::optional<PathRunout> path_runout;
    std::vector<FrontComparison> fronts;
    std::vector<TipComparison> tips;
    std::optional<ComparisonStatistics> deposit_overlap;
    std::optional<DepositScores> deposit_depth;
    Warnings warnings{};  ///< what is not compared, and what limits the use of the result
    Raster classes;       ///< values of Agreement; no cells without a surveyed area
};

/// Compares a depth with everything surveyed. Surveyed area outside the depth's grid counts as missed.
/// share/doc/scores.md has the formulas.
Comparison compare_with_survey(const ComparisonInput& input);

std::string comparison_json(const Comparison& comparison, const ComparisonInput& input);

/// Returns threshold_m, hit_m2, ... with one row for each point of the curve.
std::string comparison_curve_csv(const Comparison& comparison);

/// Writes comparison.json, and if an area was surveyed comparison_curve.csv and comparison.tif with its styles, to a
/// folder. Throws Error.
void write_comparison(const Comparison& comparison, const ComparisonInput& input, const std::string& folder);

/// Draws the map of hits, false alarms and misses with the values beside it: comparison.png, .pdf or .svg in a folder;
/// as GeoTIFF maps/comparison.tif below it, for comparison.tif is the raster of classes. Throws Error.
void draw_comparison(const Comparison& comparison, LayerDrawer& drawer, const std::string& folder);

/// Returns the path of its picture without the ending.
std::string comparison_stem(const std::string& folder);
/// Returns the files written by draw_comparison.
std::vector<std::string> comparison_pictures(const MapStyle& style, const std::string& folder);
/// Returns the files that write_comparison may write.
std::vector<std::string> comparison_files(const std::string& folder);

/// Returns the main result of a comparison in one line for the terminal and the log.
std::string comparison_headline(const Comparison& comparison);

/// Returns a scene's survey and threshold for a comparison; the simulated part remains to be filled in.
ComparisonInput surveyed(const Prepared& prepared);

/// Returns the scores of a comparison for a terminal of this width.
std::string comparison_table(const Comparison& comparison, const ComparisonInput& input, std::size_t width);
}  // namespace frana::app
