// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/study/study_spec.h"
#include "core/module.h"

namespace frana::app::study {

/// A value and its interval of confidence.
struct Interval {
    double value = 0, low = 0, high = 0;  ///< low, high: of 95 %; NaN: it has none
};
/// Sensitivity of one figure to one key.
struct KeySensitivity {
    std::optional<double> first_order, total;  ///< Sobol' indices: fractions of the variance
    /// Spearman's rank correlation; of a key without order the correlation ratio, which has no interval.
    std::optional<Interval> rank_correlation;
    /// Of Morris' design: mean of the absolute changes of the figure when the key alone moves by half of its
    /// distribution (mu*), and the standard deviation of the changes with their signs (sigma), in the figure's unit.
    std::optional<Interval> effect;
    double effect_scatter = 0;
    std::string method;  ///< of the fractions of variance: "polynomial chaos", or why there are none
};

/// The inputs of members, by member and key.
struct DesignPoints {
    std::vector<std::vector<double>> numbers;  ///< as SampleTable::numbers
    std::vector<bool> nominal;                 ///< by key
    Places places;                             ///< in the distributions; of a table mean ranks, even in (0, 1)
    bool are_dependent = false;                ///< the keys of each other: no fraction of the variance is one key's
};

/// What polynomials of the keys say of an output. The output is a sum of products of orthonormal functions of single
/// keys, y = sum c_a Psi_a, fitted by least squares: Legendre polynomials of a key's place in its distribution, of a
/// key without order contrasts of its values. Of nested sets up to degree 3 and products of 3 keys that with the
/// greatest q2 is taken (Sudret 2008, Reliability Engineering & System Safety 93, 964).
struct Chaos {
    double q2 = 0;  ///< 1 - mean square of the errors at members left out, one by one, over the variance; NaN: none
    std::vector<double> first_order, total;  ///< by key: sums of its c_a^2, alone and with others, over the variance
    std::vector<double>
        left_out;  ///< by member: what is predicted of it from the others; empty without points elsewhere
    std::vector<double> elsewhere;  ///< what is predicted at other points
};

/// Members drawn near others that explain the surveys, with the density from which they were drawn.
struct RefinedPlaces {
    Places places;
    std::vector<double> density;  ///< by member, relative to the prior, which is 1 everywhere in the cube
};

/// What is said of a distance at a place where it was not computed.
struct Prediction {
    double mean = 0, variance = 0;
};
/// A Gaussian process of the square of a distance y, which is smooth where y has its least values: with a constant
/// mean, a Matern correlation (5/2) with a length for each coordinate, and an independent error of y, as pixels make it
/// (Rasmussen and Williams 2006; ordinary kriging).
struct Emulator {
    double q2 = 0;     ///< 1 - mean square of the errors of y left out, one by one, over its variance; NaN: none
    double noise = 0;  ///< variance of the independent error of y, which Prediction::variance does not contain
    std::function<std::vector<Prediction>(const Places& places)> at;
};

/// All that frana takes from OpenTURNS, as functions of the module `openturns`. The files of this folder are its only
/// users: they are linked to the module alone, and of frana they use only types that headers define completely.
struct OpenturnsFunctions {
    /// Values of a distribution of numbers at places in (0, 1).
    std::vector<double> (*quantiles)(const Distribution& distribution, const std::vector<double>& places);
    /// Places of a study's members, independent in each coordinate. Replicated: in parts that are randomised
    /// independently; member i (of Morris' design: group i) is from part i % k_replicates, and of `sobol` and
    /// `random` the first places are those of fewer samples. Otherwise as even as can be.
    Places (*independent_places)(const StudySpec& study, bool is_replicated);
    /// Gives places the rank correlations of a study; each coordinate stays even in (0, 1). False: no distribution has
    /// these correlations.
    bool (*correlate)(const StudySpec& study, Places& places);
    /// As refined_places(), with the widths of the kernels by key and the part drawn from the prior.
    RefinedPlaces (*refined)(const Places& design, const std::vector<double>& weights,
                             const std::vector<double>& widths, double prior_part, std::size_t count,
                             std::int64_t seed);
    /// The polynomials of some outputs (by output and member), all by the same decompositions.
    /// @param elsewhere points for Chaos::elsewhere, with values that members have of keys without order; may be empty
    std::vector<Chaos> (*chaos)(const DesignPoints& points, const std::vector<std::vector<double>>& outputs,
                                const DesignPoints& elsewhere);
    /// The process whose lengths, variance and error make distances at places most likely; of fewer than 4, or of equal
    /// ones, their mean and variance everywhere.
    Emulator (*emulator)(const Places& places, const std::vector<double>& distances);
};

/// Loads the module when it is first called. Throws Error(environment) if that is not possible.
inline const OpenturnsFunctions& openturns() {
    return module_table<OpenturnsFunctions>("openturns");
}

}  // namespace frana::app::study
