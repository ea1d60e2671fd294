// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "analysis/hazard.h"
#include "core/error.h"
#include "params/scene/read_scene.h"

namespace frana::app::study {

/// Points of the unit cube, by member and key: cumulative probabilities of the keys' distributions.
using Places = std::vector<std::vector<double>>;

/// The numbers of one key, by member.
inline std::vector<double> column_of(const std::vector<std::vector<double>>& rows, std::size_t key) {
    std::vector<double> column;
    for (const std::vector<double>& row : rows) column.push_back(row[key]);
    return column;
}

enum class Law {
    uniform,
    log_uniform,
    normal,
    log_normal,
    triangular,
    pert,
    pareto,
    table,
    choice,
    gaussian_field,
    gamma,          ///< of rates; no key has it
    return_periods  ///< of release.volume, by [frequency]
};

/// The distribution of one key.
struct Distribution {
    Law law = Law::uniform;
    /// In the key's unit: limits (uniform, log-uniform), mean and standard deviation (normal, log-normal, of the value
    /// itself; gamma) with two limits where it is cut off, least, likeliest and greatest value (triangular, pert),
    /// least value, exponent and greatest value (pareto), values that rise (table), standard deviation and range [m]
    /// (gaussian-field); a volume and its return period over the first one, of each point (return-periods).
    std::vector<double> numbers;
    std::vector<std::string> values;  ///< choice; table: the numbers
    std::vector<double> weights;      ///< choice, table: as many, their sum is 1
    std::string text;                 ///< as written

    /// Whether its values have no order.
    [[nodiscard]] bool is_nominal() const noexcept { return law == Law::choice || law == Law::gaussian_field; }
};

struct Variation {
    std::string key;  ///< of the scene: "material.turbulence"
    Distribution distribution;
};

/// How often the slope fails: what makes rates of probabilities.
struct FrequencySpec {
    /// Events a year at or above the least volume: gamma distributed, as nobody knows it exactly.
    struct Rate {
        double value = 0, deviation = 0;
    };
    /// A volume [m3] that is exceeded once in so many years.
    struct Volume {
        double volume = 0, years = 0;
    };
    std::optional<Rate> rate;  ///< none: no frequency is given
    /// Both rise. The exceedance is a straight line in logarithms between them; all events above the last have its
    /// volume.
    std::optional<std::vector<Volume>> volumes;
    /// Standard deviation of the exponent b by which the law of volumes falls, exceedance ~ V^-b; none: it is certain.
    std::optional<double> exponent_error;
    std::optional<std::vector<double>> return_periods;  ///< that maps have [years]; none: 30, 100, 300
    bool by_columns = false;                            ///< of a region: each slope has its own rate or volumes

    [[nodiscard]] bool is_given() const noexcept { return rate || volumes || by_columns; }
    [[nodiscard]] std::vector<double> mapped_periods() const {
        return !is_given() ? std::vector<double>{} : return_periods.value_or(std::vector<double>{30, 100, 300});
    }
};
inline constexpr const char* k_volume_key = "release.volume";

/// Rank correlation (Spearman's rho) of two varied keys, by a normal copula.
struct Correlation {
    std::string first, second;
    double rho = 0;
};

enum class Sampling {
    sobol,
    random,
    importance,
    morris,
    table,
    polygons  ///< of a region: no sampling, each polygon of the release perimeter is a member
};

/// How the values of members are found. A method is a row of k_samplings; its points are drawn in openturns/module.cpp.
struct SamplingMethod {
    /// A sample: the first members are one too, so that it may stop early, and more may follow; keys may be correlated.
    /// A design: all its members together, with independent keys. Given: nothing is drawn.
    enum class Kind { sample, design, given };
    Sampling sampling;
    const char* name;  ///< of samples and designs in study.sampling
    Kind kind;
    bool replicated = false;        ///< drawn in k_replicates parts that are randomised independently of each other
    std::size_t more_in_group = 0;  ///< its members form groups of so many more than there are keys; 0: no groups
};
/// Members of an even design depend on each other, so that their number does not tell how sure their mean is. Parts of
/// it that are randomised independently do: from the scatter of their means follows the standard error (Owen 1997,
/// Annals of Statistics 25, 1541). Few parts are evener, many tell their scatter better: with 8 the interval is least.
inline constexpr std::size_t k_replicates = 8;
inline constexpr SamplingMethod k_samplings[] = {
    {Sampling::sobol, "sobol", SamplingMethod::Kind::sample, true},
    {Sampling::random, "random", SamplingMethod::Kind::sample},
    {Sampling::importance, "importance", SamplingMethod::Kind::design, true},
    {Sampling::morris, "morris", SamplingMethod::Kind::design, true, 1},
    {Sampling::table, "table", SamplingMethod::Kind::given},
    {Sampling::polygons, "per-polygon", SamplingMethod::Kind::given}};

/// Returns the row of a method, and its name.
constexpr const SamplingMethod& method_of(Sampling sampling) noexcept {
    for (const SamplingMethod& row : k_samplings)
        if (row.sampling == sampling) return row;
    return k_samplings[0];
}
inline std::string name_of(Sampling sampling) {
    return method_of(sampling).name;
}

enum class Keep { none, failed, all };
inline std::string name_of(Keep keep) {
    return keep == Keep::none ? "none" : keep == Keep::all ? "all" : "failed";
}

/// A region: a study with a polygon for each member, or with a frequency for `samples` members, whose attributes say
/// what each is.
struct RegionSpec {
    /// Columns of the release perimeter: what a slope is called, what it belongs to, which of several events it is,
    /// and the return period of that [years].
    std::optional<std::string> name, group, scenario, return_period;
    /// A key of the scene, or of [frequency], whose value is in a column.
    struct Column {
        std::string key, column;
    };
    std::vector<Column> columns;
    /// An event that every polygon has, by columns of its own: [scenario NAME].
    struct Event {
        std::string name;
        double return_period = 0;  ///< [years]
        std::vector<Column> columns;
    };
    std::vector<Event> events;            ///< by return period; empty: each polygon is one event
    std::optional<DegreeMatrix> degrees;  ///< none: no degree of hazard follows

    [[nodiscard]] bool has_scenarios() const { return scenario || !events.empty(); }
};

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
    {Measure::jaccard, "jaccard", Evidence::scar, "1 - Jaccard index of trace and surveyed outline"},
    {Measure::area, "area", Evidence::scar, "r(area of the trace, surveyed area)"},
    {Measure::runout, "runout", Evidence::runout, "r(simulated run-out, observed run-out)"},
    {Measure::outline, "outline", Evidence::scar,
     "d / (d + R): d mean distance of both outlines, R radius of a circle with the surveyed area"},
    {Measure::deposit, "deposit", Evidence::deposit, "1 - Jaccard index of simulated and surveyed deposit"},
    {Measure::deposit_depth, "deposit-depth", Evidence::elevation_change,
     "sum |h - h_obs| / sum (h + h_obs) over the cells of either deposit"},
    {Measure::arrival, "arrival", Evidence::arrival,
     "mean over gauges of r(arrival time, observed one); 1: no arrival"},
    {Measure::speed, "speed", Evidence::speed, "mean over gauges of r(greatest speed, observed one)"},
    {Measure::depth, "depth", Evidence::depth, "mean over gauges of r(greatest depth, observed one)"}};

struct Weight {
    Measure measure = Measure::jaccard;
    double weight = 0;  ///< greater than 0
};

/// An observed value: the run-out, or one at a gauge of the event's scene.
struct Observation {
    Evidence evidence = Evidence::runout;
    std::string gauge;            ///< empty: of the run-out
    double value = 0, error = 0;  ///< error: standard deviation; 0: not stated
};

/// An event that was surveyed.
struct EventSpec {
    std::string name;                   ///< letters, digits, '-' and '_': part of names of files
    std::string scene;                  ///< absolute
    std::vector<Observation> observed;  ///< without a run-out that of the surveyed outline counts
    std::vector<std::string> set;       ///< keys of this event alone
    std::vector<Variation> vary;        ///< likewise

    [[nodiscard]] std::vector<Observation> observed_by(Evidence evidence) const {
        std::vector<Observation> some;
        for (const Observation& one : observed)
            if (one.evidence == evidence) some.push_back(one);
        return some;
    }
};

/// Single observed values: "runout = 420", and at gauges "arrival bridge = 35".
struct ObservedKind {
    Evidence evidence;
    const char *word, *unit;
    const char* figure;  ///< of a gauge; null: from the record's map
};
inline constexpr ObservedKind k_observed_kinds[] = {{Evidence::runout, "runout", "m", nullptr},
                                                    {Evidence::arrival, "arrival", "s", nullptr},
                                                    {Evidence::speed, "speed", "m/s", "max_speed_ms"},
                                                    {Evidence::depth, "depth", "m", "max_depth_m"}};

inline constexpr std::int64_t k_most_samples = 1'000'000;
/// Importance sampling: the part of all members below which each round ends. The first round is drawn as by `sobol`.
inline constexpr double k_round_ends[] = {0.5, 0.75, 1};
/// With fewer members a round's replicates would have less than two each.
inline constexpr std::int64_t k_least_in_rounds = 64;
/// What the first round does not try is never found to bring a flow to a rare place: each option of a choice must be
/// expected so many times in it. By chance an option lacks with exp(-8), one study of 3000.
inline constexpr double k_least_tries_of_option = 8;
/// Of fewer members that came, neither a probability nor its interval is told well: its relative error is 1 / sqrt(5)
/// even if they weigh the same, and an interval that is symmetric about so few misses upwards.
inline constexpr std::size_t k_least_hits = 5;

/// What a study asks: what may happen where values are uncertain; what each of many slopes does; which values explain
/// surveyed events: then its members get the weight of a likelihood.
enum class StudyKind { ensemble, region, calibration };

/// What the rows of a posterior's table are for: a slope of the same kind, or an event of those that were surveyed.
inline constexpr const char *k_for_column = "for", *k_event_column = "event", *k_new_slope = "new-slope",
                            *k_this_event = "this-event";

/// A study as specified in its file; no scene is read yet.
struct StudySpec {
    StudyKind kind = StudyKind::ensemble;
    std::string file;              ///< the study file, absolute
    std::string scene;             ///< absolute; of a calibration each event has its own
    std::optional<Scheme> scheme;  ///< of all members; none: that of the scene
    std::int64_t samples = 200;
    Sampling sampling = Sampling::sobol;
    std::string table;                ///< absolute; sampling by a table alone
    std::optional<std::string> rows;  ///< of a posterior's table: k_new_slope, k_this_event or "this-event NAME"
    std::int64_t seed = 1;
    std::optional<std::string> rare_place;  ///< importance sampling: the gauge of the scene that is seldom reached
    std::optional<double> until;  ///< largest standard error of a probability at which no more members are run
    Keep keep = Keep::none;
    std::vector<std::string> set;  ///< "key=value" for all members, as after `--set`; paths absolute
    std::vector<Variation> vary;   ///< in the order of the file
    std::vector<Correlation> correlate;
    FrequencySpec frequency;           ///< with volumes that is the first of `vary`, of a region slope by slope
    std::optional<RegionSpec> region;  ///< a polygon for each member
    double exponent = 5;            ///< calibration: N of the likelihood of an event whose survey has no stated error
    std::vector<Weight> objective;  ///< calibration
    std::vector<EventSpec> events;  ///< calibration

    [[nodiscard]] bool is_calibration() const noexcept { return kind == StudyKind::calibration; }
    /// Returns the study of one event, with its scene: the shared keys, then its own.
    [[nodiscard]] StudySpec of_event(std::size_t event) const;

    /// Members of a group of its sampling; 0: no groups.
    [[nodiscard]] std::size_t group_size() const noexcept {
        const std::size_t more = method_of(sampling).more_in_group;
        return more == 0 ? 0 : vary.size() + more;
    }
    /// Whether more members may follow the last one, with the same ones before them.
    [[nodiscard]] bool is_extensible() const noexcept {
        return method_of(sampling).kind == SamplingMethod::Kind::sample && !region;
    }
};

/// Returns the number of members that a study in rounds has after one of them.
inline std::int64_t round_end(const StudySpec& study, std::size_t round) {
    return static_cast<std::int64_t>(k_round_ends[round] * static_cast<double>(study.samples));
}

/// A study as far as its file could be read, and all its problems.
struct StudyReading {
    StudySpec study;
    Session session;  ///< of all members
    Problems problems;
    std::string label;                  ///< the study file as the user named it
    std::vector<std::string> doubts{};  ///< of its table of values, as that says before its header

    /// Returns where a key is given, for messages: "study.ini: vary.material.turbulence".
    [[nodiscard]] Place where(const std::string& name) const { return {label, name}; }
};

}  // namespace frana::app::study
