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

/// Returns the time after which a curve of {seconds, error}, ascending in time, remains below an error: between two
/// resolutions by powers of time, beyond the finest NaN; if the coarsest already is, its time.
double time_to_error(const std::vector<std::pair<double, double>>& time_and_error, double error);

/// Returns, for each case with an exact solution, the default scheme's time on one thread to an error of 1 % and of 0.3
/// % (the greater of l1_depth and l1_momentum), and that of the finest resolution.
std::string time_to_error_table(const std::vector<AccuracyRow>& rows);

/// The result of another program for one of the cases, as measured or published. Seconds are those of its own machine
/// (the compiled ones: 2 cores of 2.4 GHz) and only indicative.
struct PeerResult {
    std::string_view case_name, code;
    double cell_size;          ///< [m]
    std::string_view measure;  ///< "mean depth error [m]", "relative L2 of depth", "relative L2 of momentum"
    double value;
    double seconds;  ///< on one thread; 0: not known
};

/// GeoClaw, D-Claw, TITAN2D and r.avaflow on stoker and ritter; AvaFrame com1DFA on similarity and
/// granular-slope.
std::span<const PeerResult> peer_results();

/// Returns accuracy.csv: one line per row; "nan" if there is no observed order.
std::string accuracy_csv(const std::vector<AccuracyRow>& rows);

/// Returns the table for the terminal: errors, orders, each case's own values with their marks, and other programs'
/// values beside them; marks values that do not pass and errors larger than those of another program.
std::string accuracy_table(const std::vector<AccuracyRow>& rows);

/// Returns as text which scheme has the least error for a given time, case by case.
std::string accuracy_verdict(const std::vector<AccuracyRow>& rows);

/// Returns the error reached in a given time, interpolated linearly in logarithms between measured (time, error) pairs;
/// NaN outside them.
double error_in_time(const std::vector<std::pair<double, double>>& time_and_error, double seconds);

}  // namespace frana::bench
