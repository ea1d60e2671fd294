// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "analysis/scores.h"
#include "core/raster.h"

namespace frana {

/// Cells whose probability is in one tenth of [0, 1].
struct ReliabilityClass {
    double least = 0, most = 0;    ///< probability; the last class contains its upper end
    double area_m2 = 0;            ///< of its cells
    double mean_probability = 0;   ///< 0 without cells
    double observed_fraction = 0;  ///< likewise
};

/// How well a map of probability foretold an observed outline.
///
/// As in ComparisonStatistics the values do not depend on the size of the map: beside the n+ observed cells count five
/// times as many that were not, those with a probability above 0 first (all of these, if they are more). With the
/// probability p and o = 1 where observed, else 0, over these n cells: brier = mean of (p - o)^2. With classes k of n_k
/// cells, means p_k and o_k, and o the mean of all:
///
///     brier = reliability - resolution + uncertainty + within_classes
///     reliability = sum n_k (p_k - o_k)^2 / n,  resolution = sum n_k (o_k - o)^2 / n,  uncertainty = o (1 - o)
///
/// (Murphy 1973). within_classes = mean of (p - p_k)^2 - 2 (p - p_k)(o - o_k): 0 if the probabilities of a class are
/// equal.
struct ProbabilityScores {
    double observed_area_m2 = 0;
    double compared_area_m2 = 0;  ///< of the n cells
    double brier = 0;
    double reliability = 0, resolution = 0, uncertainty = 0, within_classes = 0;
    double brier_skill = 0;  ///< 1 - brier / uncertainty: 0 is as good as the observed fraction everywhere
    double auroc = 0;        ///< area under the ROC curve over the probability
    std::vector<ReliabilityClass> classes;
    std::vector<RocPoint> roc;
};

/// Compares probabilities (NaN as 0) with a mask (not 0 and not NaN: observed) on the same cells. Throws Error(input)
/// if the grids differ or nothing was observed.
ProbabilityScores score_probability(const Raster& probability, const Raster& observed_mask);

}  // namespace frana
