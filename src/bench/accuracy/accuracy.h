// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bench/accuracy/accuracy_case.h"

namespace frana::bench {

inline constexpr Scheme k_schemes[] = {Scheme::standard, Scheme::paper};

/// One row of accuracy.csv.
struct AccuracyRow {
    std::string case_name;
    Scheme scheme = Scheme::standard;
    CaseStatistics statistics;
    /// log(error ratio) / log(cell ratio) of l1_depth against the next coarser row; NaN for the coarsest row and for
    /// rounding errors.
    double observed_order = k_no_data;
};

struct AccuracyOptions {
    bool quick = false;                              ///< two resolutions instead of all
    std::vector<std::string> only;                   ///< names of cases; empty: all
    std::optional<Raster> sample_terrain;            ///< for lake-dtm, which is omitted without it
    std::function<void(const std::string&)> report;  ///< called with one line for each finished row
};

/// Returns every case, in the order of the table.
std::vector<AccuracyCase> accuracy_cases(const std::optional<Raster>& sample_terrain);

/// Runs the cases on one thread, each scheme at each resolution. Throws Error(input) for an unknown name.
std::vector<AccuracyRow> run_accuracy(const AccuracyOptions& options);

}  // namespace frana::bench
