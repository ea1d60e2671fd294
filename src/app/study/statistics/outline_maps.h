// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "app/study/openturns/functions.h"
#include "app/study/statistics/cell_statistics.h"
#include "app/study/statistics/study_maps.h"
#include "core/raster.h"

namespace frana::app::study {

// Where a flow ends is a smooth function of the varied keys, whether it reaches a cell is none. So polynomials of the
// keys (Chaos) stand for the runs: of each cell they have the signed distance from the outline of what exceeds a
// threshold, positive inside; for probabilities inside how far the value exceeds it, since in a gully no cell is far
// from the outline.

/// Inputs of the members, and of many more drawn from the same distributions.
struct Emulation {
    DesignPoints members, sample;  ///< sample: empty where nothing can be drawn, as of a table
};

/// The probability that an output is greater than 0, with its polynomials as control variate.
struct EmulatedProbability {
    Estimate estimate;
    double by_sample = 0;  ///< what polynomials alone say
};
/// Estimates it for some outputs, of which only the order and the sign count. Polynomials have their normal scores y,
/// quantiles of the normal distribution at their ranks, less that at the fraction of those not greater than 0:
///
///     p = mean over the sample of g(prediction) + mean over the members of [I - g(prediction from the others)]
///
/// I = 1 where y > 0, and g(t) the fraction of members whose residual, what y is more than is predicted of it from the
/// others, would make a prediction t greater than 0. What polynomials do not know is in the second mean, so that p has
/// no bias, and its scatter is the error (MeanEstimate), at least that of events with the probabilities g, the root of
/// the mean of g (1 - g) over the number of members. p may be below 0 or above 1.
/// @param outputs by output and member
/// @return an estimate without error where polynomials say nothing
std::vector<EmulatedProbability> emulated_probabilities(const Emulation& emulation, const FinishedMembers& members,
                                                        const std::vector<std::vector<double>>& outputs);

/// Returns the signed distance of a cell from the outline of what exceeds a threshold [cells], positive inside, by
/// member.
std::vector<double> distances_from_outline(const FinishedMembers& members, Quantity quantity, double threshold,
                                           const GridSpec& grid, std::size_t cell);

/// What polynomials say of the outline of an event.
struct OutlineMaps {
    /// For each key the fraction of the variance of the distance that it explains alone (Chaos::first_order). NaN where
    /// all or none of the members exceed the threshold, and where Chaos::q2 is less than k_least_q2.
    std::vector<Raster> fractions;
    /// Cells whose probability polynomials tell. Others have too rare an event: the sum would often be beyond 0 or 1,
    /// and what is set to 0 or 1 is wrong on average.
    struct Cell {
        std::size_t cell = 0;
        Estimate emulated, plain;
    };
    std::vector<Cell> cells;
    /// Error of these probabilities over that of the members alone, root mean squares; 1: there are none.
    double error_ratio = 1;

    /// Whether polynomials make the probabilities more certain, as the errors tell.
    [[nodiscard]] bool pays() const noexcept;
    /// Where it pays, puts these errors in the place of the others.
    void improve(ErrorSummary& errors) const;
    /// Likewise probabilities and margins.
    void improve(Raster& probability, Raster& margin) const;
};
/// @param quantity, threshold the event
/// @param wants_fractions otherwise there are none
OutlineMaps outline_maps(const FinishedMembers& members, const Emulation& emulation, Quantity quantity,
                         double threshold, const GridSpec& grid, bool wants_fractions);

}  // namespace frana::app::study
