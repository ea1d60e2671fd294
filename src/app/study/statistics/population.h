// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "app/study/statistics/calibration_posterior.h"

namespace frana::app::study {

/// What several events say of each other and of a slope of the same kind.
///
/// Keys of a slope have places u in their distributions, z = probit(u). z of an event is drawn from a population:
///
///     z ~ normal(m, s^2),   m ~ normal(0, 1 - s^2),   s ~ uniform(0, 1)
///
/// for each key alone. Whatever s, an event has then the distribution that the user gave it, for any law (which a
/// logarithm or a logit would not do), and s is the part of the distribution's spread that is between slopes; one event
/// says nothing of it, and it keeps its uniform distribution (Gelman 2006, Bayesian Analysis 1, 515). A choice has
/// options with the user's weights, as of one event more (Dirichlet's distribution); a field of error is another one on
/// each slope.
struct Population {
    std::vector<PosteriorSample> events;  ///< the places of each, with weights that the others change
    PosteriorSample next;                 ///< of another slope, in the shared keys; equal draws
    std::vector<Interval> spread;         ///< s by shared key: 50, 5, 95 %; NaN: it has no order
};

/// Draws from the population by Gibbs sampling: an event's place among those of its posterior alone (Hogg, Myers and
/// Bovy 2010, Astrophysical Journal 725, 2166), s on a grid with m integrated out, then m.
/// @param shared the keys that all events have, the first coordinates of their places
/// @param events posteriors of each event alone; those that are not possible say nothing
/// @param seed the same gives the same bits
Population population_of(const std::vector<Variation>& shared, std::vector<PosteriorSample> events, std::int64_t seed);

}  // namespace frana::app::study
