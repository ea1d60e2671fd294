// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bench/accuracy/accuracy_case.h"

namespace frana::bench {

inline constexpr Scheme k_schemes[] = {Scheme::standard, Scheme::paper, Scheme::finite_volume};

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

/// Returns accuracy.csv: one line per row; "nan" if there is no observed order.
std::string accuracy_csv(const std::vector<AccuracyRow>& rows);

/// Returns the table for the terminal: errors, orders, each case's own values with their marks.
std::string accuracy_table(const std::vector<AccuracyRow>& rows);

}  // namespace frana::bench
