// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/study/study_spec.h"
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

/// Where an event's evidence comes from, for messages.
const char* source_of(Evidence evidence);

struct Weight {
    Measure measure = Measure::jaccard;
    double weight = 0;  ///< greater than 0
};

/// A value observed at a gauge of the event's scene.
struct GaugeValue {
    std::string gauge;
    double value = 0;
};

/// An event that was surveyed.
struct EventSpec {
    std::string name;                               ///< letters, digits, '-' and '_': part of names of files
    std::optional<double> runout;                   ///< observed [m]; none: that of the surveyed outline
    std::vector<GaugeValue> arrival, speed, depth;  ///< [s], [m/s], [m]
    std::vector<std::string> set;                   ///< keys of this event alone
    std::vector<Variation> vary;                    ///< likewise
    StudyReading members;  ///< its scene with all keys that are set or vary for it: shared ones first, then its own
};

/// A calibration as specified in its file; no scene is read yet.
struct CalibrationSpec {
    StudySpec study;            ///< file, samples, sampling, seed, and what all events share
    std::int64_t refine = 100;  ///< members on the scenes' own cells
    double coarse = 2;          ///< cells of the first members, in units of the scene's
    double exponent = 5;        ///< N of the likelihood
    std::vector<Weight> objective;
    std::vector<EventSpec> events;

    /// Keys of all members together: the shared ones, then those of each event.
    [[nodiscard]] std::size_t key_count() const;
    /// Place of an event's first own key among them.
    [[nodiscard]] std::size_t first_own_key(std::size_t event) const;
};

}  // namespace frana::app::study
