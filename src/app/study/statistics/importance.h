// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "app/study/openturns/functions.h"
#include "app/study/plan/sampling.h"
#include "app/study/study_spec.h"

namespace frana::app::study {

/// Importance sampling of a rare event: members of the first round are drawn from the study's distributions, those of
/// each later one near what the runs before say makes the event happen. Where a flow ends is a smooth function of the
/// keys: polynomials (Chaos) of their values stand for its signed distance y from a place, positive where it comes.
/// Of k_dense places drawn from the distributions, k_centres are taken with the probabilities
///
///     Phi((y' - min(0, y'_50)) / s)      y': prediction, y'_50: the 50th greatest, s: root mean square of y' - y left
///     out
///
/// and round r has the density q_r about them, relative to that of the distributions, in normal scores z =
/// Phi^-1(place):
///
///     q_r = mean over the centres c of prod_k phi((z_k - c_k) / b_k) / (b_k phi(z_k)),      q_0 = 1
///
/// with b_k = kernel_widths(), at least 0.1. A member counts by the balance
/// heuristic (Veach and Guibas 1995, SIGGRAPH 419): w = 1 / sum over the rounds of n_r / n q_r, at most n / n_0 = 2.
/// Centres are no members, so that what a member happened to reach hardly changes its own weight, as it would in
/// adaptive multiple importance sampling (Cornuet et al. 2012, Scandinavian Journal of Statistics 39, 798).
class ImportanceSampling {
  public:
    explicit ImportanceSampling(const StudySpec& study);

    /// Appends the next round to a table whose members have run, and gives all members their weights. Where nothing can
    /// be predicted the round is drawn as the first.
    /// @param distances of its members, in any unit; NaN: it failed
    void add_round(const std::vector<double>& distances, SampleTable& table);

  private:
    /// Normal densities about places, all in normal scores; without centres the distributions themselves.
    struct Kernels {
        std::size_t members = 0;
        Places centres;
        std::vector<double> weights;  ///< of the centres; their sum is 1
        std::vector<double> widths;   ///< by key

        [[nodiscard]] double density(const std::vector<double>& scores) const;
    };
    [[nodiscard]] DesignPoints coordinates(const std::vector<std::vector<double>>& numbers) const;
    [[nodiscard]] Kernels kernels_near(const std::vector<double>& distances, const SampleTable& table) const;
    [[nodiscard]] Places draw(const Kernels& kernels, std::size_t round) const;

    StudySpec study_;
    DesignPoints dense_;
    std::vector<double> low_, high_;  ///< of its numbers, by key
    std::vector<Kernels> rounds_;
};

}  // namespace frana::app::study
