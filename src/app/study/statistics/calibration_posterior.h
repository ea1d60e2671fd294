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
#include "app/study/statistics/cell_statistics.h"
#include "core/words/sentence.h"

namespace frana::app::study {

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
    double pieces = 0;              ///< N
    bool is_stated = false;
};

/// A key in the unit cube of all keys.
struct CubeKey {
    Distribution prior;
    std::optional<std::size_t> event;  ///< whose own it is
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

/// What the members so far say of all places: a Gaussian process of each event's distance y to its survey, in the keys
/// that the event has. With its mean m and variance v at a place, and N pieces, the expected likelihood of the event is
///
///     stated errors       E exp(-y^2 / 2) = (1 + v)^(-1/2) exp(-m^2 / (2 (1 + v)))
///     otherwise           (m^2 + v)^(-N / 2), the scale of the errors being unknown (Jeffreys' prior)
///
/// so that what was not run is less sure (Jarvenpaa et al. 2021, Bayesian Analysis 16, 147). Where the nearest member
/// failed it is 0. If not even the best member is within its stated errors, chi^2 > N + 2 sqrt(2 N), these are
/// multiplied by f = sqrt(chi^2 / N): the model errs too (Birge 1932, Physical Review 40, 207). Greater errors are
/// alike over longer distances, so that N is divided by f.
class CalibrationModel {
  public:
    /// @param places of the members
    /// @param prior places spread over the cube
    CalibrationModel(std::vector<CubeKey> keys, Places places, std::vector<EventEvidence> events, Places prior,
                     std::int64_t seed);

    /// By event; NaN: too few members.
    [[nodiscard]] std::vector<double> q2() const;
    /// Factor of an event's stated errors.
    [[nodiscard]] double widening(std::size_t event, std::optional<std::size_t> without = std::nullopt) const;
    /// The member that explains the surveys best; none if all failed.
    /// @param without an event whose survey is not used
    [[nodiscard]] std::optional<std::size_t> best(std::optional<std::size_t> without = std::nullopt) const;
    /// Draws from the posterior: importance sampling in rounds, from the prior's places to a mixture about the
    /// weightiest (Cappe et al. 2004, population Monte Carlo), tempered until enough have weight.
    [[nodiscard]] PosteriorSample sample(std::optional<std::size_t> without = std::nullopt) const;
    /// Shares the weights out to the members: each gets those of the places to which it is the nearest, measured in the
    /// posterior's standard deviations.
    [[nodiscard]] std::vector<double> member_weights(const PosteriorSample& sample,
                                                     std::optional<std::size_t> without = std::nullopt) const;
    /// Returns places for the next members: that with the greatest expected improvement of the likelihood (Jones,
    /// Schonlau and Welch 1998), then draws from the posteriors of all events and without each, of many those where the
    /// likelihood is least sure, at some distance of each other.
    [[nodiscard]] Places next(std::size_t count) const;

  private:
    struct LogLikelihood {
        double of_mean = 0, mean = 0, variance = 0;  ///< ln of the expected likelihood; of ln L
    };
    [[nodiscard]] std::vector<double> coordinates(const std::vector<double>& place, std::size_t event) const;
    [[nodiscard]] LogLikelihood log_likelihood(std::size_t event, const Prediction& distance, double widened) const;
    [[nodiscard]] std::vector<LogLikelihood> log_likelihoods(const Places& at,
                                                             std::optional<std::size_t> without) const;
    [[nodiscard]] double of_member(std::size_t member, std::optional<std::size_t> without, bool is_widened) const;
    [[nodiscard]] bool finished(std::size_t member, std::optional<std::size_t> without) const;

    std::vector<CubeKey> keys_;
    Places places_, prior_;
    std::vector<EventEvidence> events_;
    std::vector<Emulator> emulators_;
    std::int64_t seed_;
};

/// Evenly spaced draws (systematic resampling): the place drawn each time.
std::vector<std::size_t> drawn(const std::vector<double>& weights, std::size_t count);

/// What the surveys say of one key.
struct KeyPosterior {
    std::string key, event;  ///< event: empty if all share the key
    bool nominal = false;
    double low = 0, median = 0, high = 0;  ///< 5, 50, 95 % of the weight
    double prior_low = 0, prior_high = 0;  ///< the same of the distribution
    /// Width of the interval in places of the distribution, over 0.9, that of the distribution itself.
    double width = 1;
    double place_low = 0, place_high = 1;                ///< the interval as places in the distribution
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

/// Names the keys that the surveys do not tell apart.
std::vector<Sentence> sentences(const std::vector<KeyPosterior>& keys, const std::vector<IndistinctPair>& pairs);
/// Returns why a posterior may be cut off: an end of its interval within 2 % of the limit of the distribution.
std::vector<Sentence> edge_doubts(const std::vector<KeyPosterior>& keys);
/// Returns a warning if the effective number of members is too small for maps and forecasts.
std::optional<Sentence> few_members(double effective);

}  // namespace frana::app::study
