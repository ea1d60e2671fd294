// SPDX-License-Identifier: Apache-2.0
#include "analysis/probability_scores.h"

#include <algorithm>
#include <cmath>

namespace frana {
namespace {

constexpr std::size_t k_classes = 10;

/// Sums over the cells of a class.
struct ClassSums {
    double cells = 0, probability = 0, observed = 0;
};

std::size_t class_of(double probability) {
    constexpr double k_float32 = 1e-6;  // probabilities of a file are rounded
    const double place = std::floor(probability * k_classes + k_float32);
    return std::min(k_classes - 1, static_cast<std::size_t>(std::max(0.0, place)));
}

}  // namespace

ProbabilityScores score_probability(const Raster& probability, const Raster& observed_mask) {
    ProbabilityScores scores;
    scores.roc = roc_curve(probability, observed_mask);
    scores.auroc = area_below(scores.roc);
    std::vector<ClassSums> sums(k_classes);
    double squares = 0, observed_cells = 0, others = 0;
    const auto add = [&](double p, bool observed) {
        ClassSums& one = sums[class_of(p)];
        one.cells += 1;
        one.probability += p;
        one.observed += observed ? 1 : 0;
        squares += (p - (observed ? 1 : 0)) * (p - (observed ? 1 : 0));
        (observed ? observed_cells : others) += 1;
    };
    observed_mask.values.for_each_stored([&](std::size_t cell, double value) {
        if (!is_observed(value)) return;
        const double p = probability.values[cell];
        add(std::isnan(p) ? 0 : p, true);
    });
    probability.values.for_each_stored([&](std::size_t cell, double p) {
        if (p > 0 && !is_observed(observed_mask.values[cell])) add(p, false);
    });
    const double dry = std::max(0.0, k_negatives_per_positive * observed_cells - others);  // rightly 0
    sums.front().cells += dry;
    const double cells = observed_cells + others + dry, mean = observed_cells / cells;
    const double cell_area = observed_mask.grid.cell_area();
    for (std::size_t k = 0; k < k_classes; ++k) {
        const ClassSums& one = sums[k];
        ReliabilityClass kind{static_cast<double>(k) / k_classes, static_cast<double>(k + 1) / k_classes,
                              one.cells * cell_area, 0, 0};
        if (one.cells > 0) {
            kind.mean_probability = one.probability / one.cells;
            kind.observed_fraction = one.observed / one.cells;
            scores.reliability += one.cells / cells * std::pow(kind.mean_probability - kind.observed_fraction, 2);
            scores.resolution += one.cells / cells * std::pow(kind.observed_fraction - mean, 2);
        }
        scores.classes.push_back(kind);
    }
    scores.observed_area_m2 = observed_cells * cell_area;
    scores.compared_area_m2 = cells * cell_area;
    scores.brier = squares / cells;
    scores.uncertainty = mean * (1 - mean);
    scores.within_classes = scores.brier - (scores.reliability - scores.resolution + scores.uncertainty);
    scores.brier_skill = 1 - scores.brier / scores.uncertainty;
    return scores;
}

}  // namespace frana
