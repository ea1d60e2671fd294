// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/study/plan/read_study.h"
#include "app/study/study_spec.h"
#include "core/error.h"
#include "core/words/words.h"

namespace frana::app::study {

/// In what a run can differ from what was surveyed.
enum class Measure { jaccard, area, runout, outline, deposit, deposit_depth, arrival, speed, depth };

/// What a measure needs of an event.
enum class Evidence { scar, runout, deposit, elevation_change, arrival, speed, depth };

/// A measure with its texts. Its misfit is 0 where run and survey agree, and 1 at most; r(a, b) = |a - b| / max(a, b).
struct MeasureRow {
    Measure measure;
    const char* name;  ///< in [objective] and in tables
    Evidence needs;
    const char* formula;
};
inline constexpr MeasureRow k_measures[] = {
    {Measure::jaccard, "jaccard", Evidence::scar, worded("1 - Jaccard index of trace and surveyed outline")},
    {Measure::area, "area", Evidence::scar, worded("r(area of the trace, surveyed area)")},
    {Measure::runout, "runout", Evidence::runout, worded("r(simulated run-out, observed run-out)")},
    {Measure::outline, "outline", Evidence::scar,
     worded("d / (d + R): d mean distance of both outlines, R radius of a circle with the surveyed area")},
    {Measure::deposit, "deposit", Evidence::deposit, worded("1 - Jaccard index of simulated and surveyed deposit")},
    {Measure::deposit_depth, "deposit-depth", Evidence::elevation_change,
     worded("sum |h - h_obs| / sum (h + h_obs) over the cells of either deposit")},
    {Measure::arrival, "arrival", Evidence::arrival,
     worded("mean over gauges of r(arrival time, observed one); 1: no arrival")},
    {Measure::speed, "speed", Evidence::speed, worded("mean over gauges of r(greatest speed, observed one)")},
    {Measure::depth, "depth", Evidence::depth, worded("mean over gauges of r(greatest depth, observed one)")}};

/// Where an event's evidence comes from, for messages; by Evidence.
inline constexpr const char* k_sources[] = {
    "observed.perimeter in the scene", "observed.perimeter in the scene, or runout in [event NAME]",
    "observed.deposit in the scene",   "observed.deposit in the scene, as a raster",
    "arrival GAUGE in [event NAME]",   "speed GAUGE in [event NAME]",
    "depth GAUGE in [event NAME]"};

struct Weight {
    Measure measure = Measure::jaccard;
    double weight = 0;  ///< greater than 0
};

/// An observed value, at a gauge of the event's scene or the run-out.
struct GaugeValue {
    std::string gauge;
    double value = 0, error = 0;  ///< error: standard deviation; 0: not stated
};

/// An event that was surveyed.
struct EventSpec {
    std::string name;                               ///< letters, digits, '-' and '_': part of names of files
    std::optional<GaugeValue> runout;               ///< observed [m]; none: that of the surveyed outline
    std::vector<GaugeValue> arrival, speed, depth;  ///< [s], [m/s], [m]
    std::vector<std::string> set;                   ///< keys of this event alone
    std::vector<Variation> vary;                    ///< likewise
    StudyReading members;  ///< its scene with all keys that are set or vary for it: shared ones first, then its own
};

/// Values observed at gauges: "arrival bridge = 35".
struct GaugeKind {
    Evidence evidence;
    const char *word, *unit;
    std::vector<GaugeValue> EventSpec::*values;
    const char* figure;  ///< of a gauge; null: from the record's map
};
inline constexpr GaugeKind k_gauge_kinds[] = {{Evidence::arrival, "arrival", "s", &EventSpec::arrival, nullptr},
                                              {Evidence::speed, "speed", "m/s", &EventSpec::speed, "max_speed_ms"},
                                              {Evidence::depth, "depth", "m", &EventSpec::depth, "max_depth_m"}};

/// A calibration as specified in its file; no scene is read yet.
struct CalibrationSpec {
    StudySpec study;      ///< file, samples: members at most, sampling, seed, and what all events share
    double exponent = 5;  ///< N of the likelihood of an event whose survey has no stated error
    std::vector<Weight> objective;
    std::vector<EventSpec> events;

    /// Keys of all members together: the shared ones, then those of each event.
    [[nodiscard]] std::size_t key_count() const;
    /// Place of an event's first own key among them.
    [[nodiscard]] std::size_t first_own_key(std::size_t event) const;
};

/// A calibration as far as its file could be read, and all its problems.
struct CalibrationReading {
    CalibrationSpec calibration;
    Problems problems;
    std::string label;  ///< the file as the user named it

    /// Returns where a key is given, for messages: "study.ini: objective.jaccard".
    [[nodiscard]] Place where(const std::string& name) const { return {label, name}; }
};

/// Whether a study is a calibration: it has a section [objective] or [event NAME]. Throws Error(input) as read_ini.
bool is_calibration(const std::string& path);

/// Reads a calibration's file; every problem is collected, those of [set] and [vary] as read_study() finds them. Throws
/// Error(input) only if the file is no INI.
CalibrationReading read_calibration(const std::string& path);

/// Returns a calibration with every path in it mapped, as of a study, and one whose paths are relative to a folder.
CalibrationSpec with_files(CalibrationSpec calibration, const KeyedFileMap& map);
CalibrationSpec seen_from(CalibrationSpec calibration, const std::string& folder);

/// Returns the file with every key, its meaning and the distributions as used; reading it back gives the same.
std::string calibration_text(const CalibrationSpec& calibration);

}  // namespace frana::app::study
