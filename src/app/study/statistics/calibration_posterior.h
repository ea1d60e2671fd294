// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/study/openturns/functions.h"
#include "app/study/plan/sampling.h"
#include "core/words/sentence.h"

namespace frana::app::study {

/// Draws places in the unit cube from the density
///
///     q(u) = a + (1 - a) sum_i w_i prod_k t(u_k; u_ik, b_k),    a = 0.2
///
/// t: normal density about a place of the design, cut off at the cube's faces; b_k = s_k n^(-1/(d + 4)) (Scott 1992)
/// from the weighted standard deviation s_k, the effective number of places n and the number of keys d, at least 0.02.
/// The part a is drawn from the prior: every weight prior / q is at most 1 / a (Hesterberg 1995).
/// @param weights by place of the design; their sum is 1
RefinedPlaces refined_places(const Places& design, const std::vector<double>& weights, std::size_t count,
                             std::int64_t seed);

/// The misfit that counts as perfect: cells and surveys are not more exact.
inline constexpr double k_least_misfit = 0.01;

/// Number of members with equal weights that would tell as much: (sum w)^2 / sum w^2; 0 without weight.
double effective_count(const std::vector<double>& weights);

/// Misfits by member and event; NaN: the member failed there.
using Misfits = std::vector<std::vector<double>>;

/// Returns the weights of members given the surveys, with a sum of 1:
///
///     w_i ~ prod_e max(D_ie, 0.01)^-N / q_i
///
/// D_ie misfit of member i at event e, q_i density from which it was drawn. (sum |d|)^-N is the likelihood of N
/// independent Laplace-distributed errors d of unknown scale with Jeffreys' prior for the scale, and the form of Beven
/// and Binley (1992). Those below 1e-4 of the greatest are 0, as are those of failed members; all 0 if none is left.
/// @param without an event whose survey is not used
std::vector<double> posterior_weights(const Misfits& misfits, const std::vector<double>& density, double exponent,
                                      std::optional<std::size_t> without = std::nullopt);

/// Effective number of members that a posterior needs at least: with fewer its intervals would be as narrow as the
/// members are few.
inline constexpr double k_least_effective = 8;
/// Returns the exponent, or the greatest below it with which the effective number of members is k_least_effective, or a
/// quarter of those that finished where they are fewer than 32: tempering, as in sequential Monte Carlo (Del Moral,
/// Doucet and Jasra 2006).
double supported_exponent(const Misfits& misfits, const std::vector<double>& density, double exponent,
                          std::optional<std::size_t> without = std::nullopt);

/// Returns the member that explains the surveys best, whatever its weight in the design; none if all failed.
std::optional<std::size_t> best_member(const Misfits& misfits, std::optional<std::size_t> without = std::nullopt);

/// What the surveys say of one key.
struct KeyPosterior {
    std::string key, event;  ///< event: empty if all share the key
    bool nominal = false;
    double low = 0, median = 0, high = 0;  ///< 5, 50, 95 % of the weight
    double prior_low = 0, prior_high = 0;  ///< the same of the distribution
    /// Width of the interval in places of the distribution, over 0.9, that of the distribution itself.
    double width = 1;
    std::vector<std::pair<std::string, double>> values;  ///< of a choice: probabilities
};

/// Two keys that the surveys cannot tell apart.
struct IndistinctPair {
    std::size_t first = 0, second = 0;  ///< places in the list of keys
    double correlation = 0;             ///< weighted, of the places in the distributions
};

/// Correlation from which two keys count as not told apart.
inline constexpr double k_indistinct_correlation = 0.6;

/// One key of a calibration: its prior and its values in the members.
struct KeySample {
    std::string key, event;
    Distribution prior;
    std::vector<double> places, numbers;  ///< by member
    std::vector<std::string> texts;
};

std::vector<KeyPosterior> key_posteriors(const std::vector<KeySample>& keys, const std::vector<double>& weights);
/// Returns the pairs of keys with an order, the most correlated first.
std::vector<IndistinctPair> indistinct_pairs(const std::vector<KeySample>& keys, const std::vector<double>& weights);

/// Returns plain sentences on what the surveys tell and do not tell.
std::vector<Sentence> sentences(const std::vector<KeyPosterior>& keys, const std::vector<IndistinctPair>& pairs);
/// Returns a warning if the effective number of members is too small for intervals.
std::optional<Sentence> few_members(double effective);

}  // namespace frana::app::study
