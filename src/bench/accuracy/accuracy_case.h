// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bench/exact/solutions.h"
#include "bench/set_up/setup.h"

namespace frana::bench {

/// A value of a case besides its errors; passed if its absolute value is at most the mark.
struct CaseStatistic {
    std::string name;
    double value = 0;
    std::optional<double> mark;

    [[nodiscard]] bool met() const { return !mark || std::abs(value) <= *mark; }  // NaN does not pass
};

/// The result of one run of a case: cost and errors against its exact solution.
struct CaseStatistics {
    double cell_size = 0;        ///< [m]
    std::int64_t particles = 0;  ///< greatest number at any time
    std::int64_t steps = 0;
    double wall_seconds = 0;      ///< of the engine, one thread
    double cpu_seconds = 0;       ///< the same of the processor
    double l1_depth = 0;          ///< sum |h - h_exact| / sum h_exact over the grid
    double l2_depth = 0;          ///< sqrt(sum (h - h_exact)^2 / sum h_exact^2)
    double linf_depth = 0;        ///< max |h - h_exact| [m]
    double l1_momentum = 0;       ///< sum |q - q_exact| / sum |q_exact|; over sum h sqrt(g h) where q_exact is 0
    double l2_momentum = 0;       ///< the same with squares
    double mean_depth_error = 0;  ///< mean |h - h_exact| over the cells compared [m]
    std::vector<CaseStatistic> own;
    std::string error;  ///< why the run ended early; empty: it did not
};

/// One row of the accuracy bench's table of cases.
struct AccuracyCase {
    std::string name;
    std::string what;                ///< one line for the printed table
    std::vector<double> cell_sizes;  ///< from coarse to fine [m]
    bool rounding = false;           ///< the error is rounding: no order is expected
    std::function<CaseStatistics(double cell_size, Scheme scheme)> run;
};

/// Compares depth and momentum of a flow at the nodes with an exact solution at their positions (local metres), where
/// `inside` is true; with the cost of its run.
CaseStatistics compare_with_exact(TimedFlow& run, const std::function<ExactState(Point)>& exact,
                                  const std::function<bool(Point)>& inside = {});

// Every case, explained where it is defined.
AccuracyCase lake_dtm(const Raster& dtm);
std::vector<AccuracyCase> lakes();
std::vector<AccuracyCase> channel_dam_breaks();
AccuracyCase rotated_dam_break();
std::vector<AccuracyCase> radial_dam_breaks();
std::vector<AccuracyCase> granular_slopes();
std::vector<AccuracyCase> similarities();
std::vector<AccuracyCase> thackers();
AccuracyCase voellmy_plane();
AccuracyCase bingham_slump();
AccuracyCase sliding_block();
AccuracyCase conservation();

}  // namespace frana::bench
