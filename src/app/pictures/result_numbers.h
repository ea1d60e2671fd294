// SPDX-License-Identifier: Apache-2.0
// The numbers of a result as its files have them, and how a run ended.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "analysis/runout.h"
#include "core/geometry.h"
#include "core/json.h"
#include "core/words/warning.h"
#include "core/words/words.h"
#include "simulation/result.h"

namespace frana::app {

/// How many runs of a study were cut, held, left the ground, failed or warned, and by how much at most. Maps read it
/// from summary.json.
struct Troubles {
    std::size_t runs = 0, cut = 0, left = 0, failed = 0, warned = 0;
    std::size_t open = 0;                   ///< that were cut, held or left the ground, each once
    std::size_t held = 0;                   ///< by cells without elevation
    double most_moving = 0, most_left = 0;  ///< fractions of the volume, of the runs that were cut, that left
    std::size_t flew = 0;                   ///< over edges, where maps of maxima show nothing below
    bool each_counts = false;               ///< of a region: every slope is somebody's

    /// Whether a run was cut, held, left the ground or failed: what --strict makes an error, and the headline tells.
    [[nodiscard]] bool any() const noexcept { return unfinished() > 0; }
    /// Whether they are so many that the study's first line says so: over 5 %, of a region any.
    [[nodiscard]] bool are_first() const noexcept;
    /// Runs whose reach is not known: cut, gone or failed.
    [[nodiscard]] std::size_t unfinished() const noexcept { return open + failed; }
};

/// "Extent, run-out and probabilities are lower bounds: 12 of 12 runs were cut while they still moved (up to 70
/// % of the volume); ...".
Sentence headline(const Troubles& troubles);

/// As `run_troubles` of summary.json, and back; none: an older summary.
Json json_of(const Troubles& troubles);
std::optional<Troubles> troubles_in(const Json& summary);

/// A sentence: a text that is the same in all languages, {"number": "1 234.5"}, or [pattern, values ...]; and back.
Json json_of(Sentence sentence);
Sentence sentence_in(const Json& json);

/// Warnings as `warning_values` of summary.json, from which a page in any language is made, and back; none: an older
/// summary.
Json json_of(const Warnings& warnings);
/// Those that stand on maps.
Warnings warnings_in(const Json& summary);
/// "Warning: the flow still moves ...; ...", for the caption of a page, and "2/3" if not all have room; empty without
/// any.
/// @param longest letters: the sentences of most runs are whole; with few "Warning: summary.json" alone
std::string warning_line(const Warnings& warnings, const Words& words, std::size_t longest = 480);

/// How a run ended. Maps, films, charts and the report say it in the same words.
struct RunEnd {
    std::string reason;          ///< English, as `describe` of a StopReason
    double seconds = 0;          ///< simulated
    double fastest = 0;          ///< greatest speed of the last step [m/s]
    double moving_fraction = 0;  ///< of the volume
    /// Whether the front still moved when the run was stopped: final depth and run-out are not those of the
    /// deposit.
    bool is_cut_short = false;
    /// Whether only the deposit did: run-out and area had stopped changing.
    bool creeps = false;
    /// Whether it came to ground without elevation, which held it back (gap_contact).
    bool is_held = false;
};

RunEnd run_end(const RunResult& result);
/// The same from what summary.json says.
/// @param moving_fraction fraction of the volume that still moved
/// @param front_is_final, deposit_change as in Settling; false, 0: not known
RunEnd run_end(const std::string& reason, double seconds, double fastest, double moving_fraction, bool front_is_final,
               double deposit_change);

/// "Run-out and area final; 3 % still moves, at 0.3 m/s."
Sentence creeping_sentence(const RunEnd& end);

/// Returns "The run ended after 468 s: run-out, area and deposit have stopped changing; greatest speed then 1.2 m/s.",
/// in the language of the words.
std::string end_sentence(const RunEnd& end, const Words& words);

/// Values of a run's series for maps.
struct SeriesEnds {
    double simulated_seconds = 0;
    double volume = 0;       ///< that entered [m3]
    double volume_left = 0;  ///< left through the edges of the domain [m3]
    double last_speed = 0;   ///< greatest speed at the end [m/s]
};

/// Reads the first and the last row of a timeseries.csv. Throws Error(input), naming the file and the line, if it has
/// no rows, lacks a column, or is truncated.
SeriesEnds read_series_ends(const std::string& path);

/// Values of the trace in summary.json, extent.gpkg, report.html and on every map. A run computes them once; later
/// commands read them from summary.json.
struct MainStatistics {
    double threshold = 0;          ///< output.trace-threshold: depth that counts as covered [m]
    double covered_area_m2 = 0;    ///< of the trace: greatest depth above the threshold
    std::vector<Runout> run_outs;  ///< of the separate flows, the longest first; at least one
    std::optional<RunEnd> end{};   ///< none: an older program did not tell

    [[nodiscard]] const Runout& run_out() const { return run_outs.front(); }
};

/// Returns the places from which the flows of a result come: by them flows that only flowed in are recognised.
std::vector<Point> flow_tops(const std::optional<MainStatistics>& statistics);

/// Returns none if the result has no summary.json yet, or not these values. Throws Error(input) if the file is damaged.
std::optional<MainStatistics> read_main_statistics(const std::string& result_folder);

/// What a scenario line is made of.
struct ScenarioFacts {
    std::function<std::optional<std::string>(const std::string& key)> value;  ///< of the result's scene
    bool density_by_default = false;                                          ///< left alone in it
    std::vector<std::string> release_names;                                   ///< of the polygons that have one
    double volume = 0;                                                        ///< [m3]
    double simulated_seconds = 0;
    std::optional<RunEnd> end;  ///< none: not known
};

/// Returns the name of the model, with the scheme where it is not the default.
std::string voellmy_bingham_words(const std::string& scheme);

/// Returns the release, its volume, the model and its values: "Release North, South: 12 300 m3; Voellmy-Bingham,
/// friction angle 12 degrees, turbulence 500 m/s2, density 2000 kg/m3. The run ended after 120 s: ...". Of values that
/// differ from place to place it says so.
std::string scenario_words(const ScenarioFacts& facts, const Words& words);

}  // namespace frana::app
