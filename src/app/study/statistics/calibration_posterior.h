// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/study/openturns/functions.h"
#include "app/study/plan/sampling.h"
#include "app/study/statistics/cell_statistics.h"
#include "core/words/sentence.h"

namespace frana::app::study {

/// The normal distribution below a score.
inline double normal_below(double score) {
    return 0.5 * std::erfc(-score / std::numbers::sqrt2);
}

/// Returns by key the widths of kernels about weighted places, s_k n^(-1/(d + 4)) (Scott 1992) from the weighted
/// standard deviation s_k, the effective number of places n and the number of keys d, at least `least`.
/// @param weights by place; their sum is 1
std::vector<double> kernel_widths(const Places& places, const std::vector<double>& weights, double least);

/// Draws places in the unit cube from the density
///
///     q(u) = a + (1 - a) sum_i w_i prod_k t(u_k; u_ik, b_k),    a = 0.2
///
/// t: normal density about a place of the design, cut off at the cube's faces; b_k = kernel_widths(), at least 0.02.
/// The part a is drawn from the prior: every weight prior / q is at most 1 / a (Hesterberg 1995).
/// @param weights by place of the design; their sum is 1
RefinedPlaces refined_places(const Places& design, const std::vector<double>& weights, std::size_t count,
                             std::int64_t seed);

/// Returns the weights exp(p ln L) / q with a sum of 1. Those below 1e-4 of the greatest are 0; all are 0 if every ln L
/// is minus infinity.
std::vector<double> weights_of(const std::vector<double>& log_likelihood, const std::vector<double>& density,
                               double power = 1);

/// The misfit that counts as perfect where no error is stated: cells and surveys are not more exact.
inline constexpr double k_least_misfit = 0.01;

/// How far members are from the survey of one event.
struct EventEvidence {
    std::vector<double> distances;  ///< by member: sqrt(chi^2) of the stated errors, else the misfit; NaN: it failed
    double pieces = 0;              ///< N: of stated errors chi^2 of a run without other errors, on the average
    double scatter = 0;             ///< of stated errors the standard deviation of that chi^2
    bool is_stated = false;
};

/// Places with weights: a posterior. Their sum is 1, or all are 0: no member finished.
struct PosteriorSample {
    Places places;
    std::vector<double> weights;

    [[nodiscard]] bool possible() const { return effective_count(weights) > 0; }
};
/// Returns the greatest change of a key's 5, 50, 95 % quantile between two, in places of its distribution.
double greatest_move(const PosteriorSample& before, const PosteriorSample& after);

/// Runs continue until the quantiles move by less between two batches, twice in a row: a part of the prior's width.
inline constexpr double k_settled = 0.02;

/// Returns what members say of a distance at other places: a Gaussian process of those that finished.
/// @param distances by member; NaN: it failed
Emulator emulator_of(const std::vector<Variation>& keys, const Places& places, const std::vector<double>& distances);

/// What the members so far say of all places: a Gaussian process of the distance y to the survey of one event. With its
/// mean m and variance v at a place, and N pieces, the expected likelihood of the event is
///
///     stated errors       E exp(-y^2 / 2) = (1 + v)^(-1/2) exp(-m^2 / (2 (1 + v)))
///     otherwise           (m^2 + v)^(-N / 2), the scale of the errors being unknown (Jeffreys' prior)
///
/// so that what was not run is less sure (Jarvenpaa et al. 2021, Bayesian Analysis 16, 147). A field of error is
/// another one in each member: v then has the variance that it makes, so that it is integrated over. Where the nearest
/// member failed the likelihood is 0. If not even the best member is within its stated errors, with a chi^2 that
/// these alone exceed in 5 %, they are multiplied by f = sqrt(chi^2 / N): the model errs too (Birge 1932, Physical
/// Review 40, 207). Greater errors are alike over longer distances, so that N is divided by f.
class EventModel {
  public:
    /// @param keys the event's distributions, by coordinate
    /// @param places of the members
    /// @param prior places spread over the cube
    EventModel(std::vector<Variation> keys, Places places, EventEvidence evidence, Places prior, std::int64_t seed);

    [[nodiscard]] double q2() const { return emulator_.q2; }  ///< NaN: too few members
    /// Factor of the stated errors.
    [[nodiscard]] double widening() const;
    /// The member that explains the survey best; none if all failed.
    [[nodiscard]] std::optional<std::size_t> best() const;
    /// Draws from the posterior: importance sampling in rounds, from the prior's places to a mixture about the
    /// weightiest (Cappe et al. 2004, population Monte Carlo), tempered until enough have weight.
    [[nodiscard]] PosteriorSample sample() const;
    /// Returns places for the next members: that with the greatest expected improvement of the likelihood (Jones,
    /// Schonlau and Welch 1998), then draws from the posterior, of many those where the likelihood is least sure, at
    /// some distance of each other.
    [[nodiscard]] Places next(std::size_t count) const;

  private:
    struct LogLikelihood {
        double of_mean = 0, mean = 0, variance = 0;  ///< ln of the expected likelihood; of ln L
    };
    [[nodiscard]] LogLikelihood log_likelihood(const Prediction& distance, double widened) const;
    [[nodiscard]] std::vector<LogLikelihood> log_likelihoods(const Places& at) const;

    std::vector<Variation> keys_;
    Places places_, prior_;
    EventEvidence evidence_;
    Emulator emulator_;
    std::int64_t seed_;
};

/// Evenly spaced draws (systematic resampling): the place drawn each time.
std::vector<std::size_t> drawn(const std::vector<double>& weights, std::size_t count);
/// The same in an order in which neighbours are near each other in all keys, so that the draws are even in the cube.
Places evenly_drawn(const PosteriorSample& sample, std::size_t count);

/// What the surveys say of one key.
struct KeyPosterior {
    std::string key, event;  ///< event: empty of another slope
    bool nominal = false;
    double low = 0, median = 0, high = 0;  ///< 5, 50, 95 % of the weight
    double prior_low = 0, prior_high = 0;  ///< the same of the distribution
    /// Width of the interval in places of the distribution, over 0.9, that of the distribution itself.
    double width = 1;
    double share_low = 0, share_high = 0;                ///< of the draws, in the outermost 2 % of the distribution
    std::vector<std::pair<std::string, double>> values;  ///< of a choice: probabilities
};

/// Two keys that the surveys cannot tell apart.
struct IndistinctPair {
    std::size_t first = 0, second = 0;  ///< places in the list of keys
    double correlation = 0;             ///< weighted, of the places in the distributions
};

/// Correlation from which two keys count as not told apart.
inline constexpr double k_indistinct_correlation = 0.6;

/// @param keys of the columns of `draws`, which have places  @param event whose keys they are; empty: another slope's
std::vector<KeyPosterior> key_posteriors(const std::vector<Variation>& keys, const SampleTable& draws,
                                         const std::vector<double>& weights, const std::string& event = "");
/// Returns the pairs of keys with an order, the most correlated first.
std::vector<IndistinctPair> indistinct_pairs(const SampleTable& draws, const std::vector<double>& weights);

/// Names the keys that the surveys do not tell apart.
std::vector<Sentence> sentences(const std::vector<KeyPosterior>& keys, const std::vector<IndistinctPair>& pairs);
/// What is doubtful, as a value.
struct StudyDoubt {
    std::string kind;  ///< prior-limit, survey-error, outline-bias, emulator, unsettled, unfinished
    std::string event, key;
    double value = 0;  ///< of a limit the share of the draws at it; of others what the text says
    Sentence text;
};
/// Returns where a posterior may be cut off: more than 5 % of the draws in 2 % of a distribution, next to its limit.
std::vector<StudyDoubt> edge_doubts(const std::vector<KeyPosterior>& keys);

}  // namespace frana::app::study
