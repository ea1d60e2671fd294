// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "app/pictures/charts.h"
#include "app/process/terminal.h"
#include "app/publish/html_page.h"
#include "app/publish/publish_exposure.h"
#include "app/publish/publish_hazard.h"
#include "app/publish/publish_pictures.h"
#include "app/store/result_directory.h"
#include "app/study/member_record.h"
#include "app/study/plan/study_input.h"
#include "app/study/pool/study_result.h"
#include "app/study/publish/scheme_check.h"
#include "app/study/statistics/study_maps.h"
#include "app/text/number_text.h"
#include "core/json.h"
#include "gis/vector/vector_out.h"

namespace frana::app::study {

/// A column of the tables of members with a member's value.
struct MemberCell {
    std::string name, text;
    bool is_number = true;
};
/// What they say of a member: its values as after `--set`, its figures, how it ended; the same columns for all.
std::vector<MemberCell> member_row(const StudyInput& input, const StudyResult& result, const MemberRecord& member);
/// Adds what they end with: its wall time, how it ended, why it failed.
void add_end(const MemberRecord& member, std::vector<MemberCell>& row);
/// Returns members.csv, with a row for each member; posterior.csv is one of such rows, too.
std::string csv_of(const std::vector<std::vector<MemberCell>>& rows);
std::string members_csv(const StudyInput& input, const StudyResult& result);
/// A number as a cell of a table; empty: NaN.
std::string cell_of(double value);
/// Returns sensitivity.csv: a row for each figure and key.
std::string sensitivity_csv(const StudyInput& input, const std::vector<FigureSensitivity>& figures);

/// What the rates of a study are conditional on.
inline constexpr const char* k_condition_with_rate =
    worded("For this rate and these distributions; errors of the model excluded");

/// What the summary.json of a study of any kind contains besides its members.
struct StudyFacts {
    Troubles troubles;
    ErrorSummary error;       ///< of all maps of probability
    double least_margin = 1;  ///< Estimate::margin of a probability of 0 or 1
    std::optional<RarePlace> rare_place;
    std::optional<ExposureTotals> exposure;
    std::optional<SchemeCheck> scheme_check;
    std::vector<FrictionArea> friction_areas;  ///< of the ground that at least one run reached
    std::string date = today();                ///< the day it was written, "2026-11-24"
    /// Areas deeper than the threshold at some time [m2]: with the probability of each of k_study_quantiles at least;
    /// of sources that fail alone one value, that of all of them. Empty: there is no such map.
    std::vector<double> reached_m2;
    std::vector<Interval> once_m2;    ///< area deeper than the threshold once in each return period of the frequency
    Interval half_reached_m2;         ///< the area with 50 %, where the interval of its probability allows it
    double reached_threshold = 0;     ///< [m]
    std::vector<HazardArea> degrees;  ///< of hazard, of a region with return periods
    double wall_seconds = 0;
    std::size_t computed = 0;  ///< members in this session
    int threads = 1;
    Warnings warnings;
};
/// Whose friction a study shows, and by which of its keys that differs between the runs; of one with a friction table.
struct ShownFriction {
    std::string of;  ///< k_central_friction or k_largest_friction
    std::vector<std::string> varied;
};
ShownFriction shown_friction(const StudyInput& input);
/// What summary.json has of a study of any kind.
Json summary_head(const StudyInput& input, const StudyFacts& facts);
/// Returns summary.json.
std::string study_summary_json(const StudyInput& input, const StudyResult& result, const StudyFacts& facts);

/// One of several events of a region's slopes.
struct Scenario {
    std::string name, stem;    ///< stem: in names of files and columns
    double return_period = 0;  ///< [years]; 0: not known
};
/// Returns those of a region, the most frequent first.
std::vector<Scenario> scenarios_of(const StudyInput& input);

/// Writes what the members together do to the exposed features, if there are any: the greatest values of all; of
/// distributions the probability that the feature, not only one of its cells, is reached and exceeds each threshold; of
/// slopes how many reach it, which is the worst, and in each scenario the class of intensity and the greatest values,
/// with the degree of hazard; of a frequency its rates.
std::optional<ExposureTotals> publish_study_exposure(const StudyInput& input, const StudyResult& result,
                                                     const Bounds& map, const ResultDirectory& directory);

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
std::vector<gis::ShapeLayer> known_outlines(const StudyInput& input);

/// Writes a member's scene and maps to a folder of the result.
void write_member(const StudyInput& input, std::size_t member, const MemberRecord& record, const GridSpec& grid,
                  const ResultDirectory& directory, const std::string& folder);

/// Draws the maps and charts that the scene's output.maps and output.charts ask for, with a warning of one that could
/// not be drawn.
void draw_study(const StudyInput& input, const StudyResult& result, const std::vector<FigureSensitivity>& figures,
                const ResultDirectory& directory, Findings found);

struct StudyOutcome {
    bool too_many_failed = false;
    bool has_troubles = false;  ///< Troubles::any
};

/// Adds to the facts what the runs warn of, and tells it.
/// @param table that has the reasons of failures  @param facts with what is doubted of the study as a whole
StudyOutcome tell_of_runs(const StudyInput& input, const std::vector<MemberRecord>& runs, const std::string& table,
                          StudyFacts& facts, RunLog& log);

/// Writes the study as used, and which files it and its scenes name.
void write_study_file(const StudyInput& input, const ResultDirectory& directory);

/// Writes everything that follows from the members' records in the directory: rasters, tables, outlines, maps, charts,
/// report.html, summary.json. Throws Error(environment).
/// @param members that ran  @param computed of these in this session
StudyOutcome publish_study(StudyInput& input, std::size_t members, std::size_t computed, int threads,
                           const Stopwatch& since_start, const ResultDirectory& directory, RunLog& log);

/// Adds warnings and failed members, if there are any, to the report of a study and writes it.
void end_page(const StudyInput& input, const std::string& title, const Table& failures, const StudyFacts& facts,
              Opening opening, Document page, const std::string& folder);

/// Writes report.html of a study from its tables and the pictures already in its directory: one self-contained file.
/// Throws Error(environment).
void write_study_report(const StudyInput& input, const StudyResult& result, const StudyFacts& facts,
                        const ResultDirectory& directory);

}  // namespace frana::app::study
