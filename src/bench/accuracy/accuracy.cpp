// SPDX-License-Identifier: Apache-2.0
#include "bench/accuracy/accuracy.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include "bench/accuracy/bingham_slump.h"
#include "bench/accuracy/channel_dam_break.h"
#include "bench/accuracy/conservation.h"
#include "bench/accuracy/fluid_cases.h"
#include "bench/accuracy/granular_slope.h"
#include "bench/accuracy/lake.h"
#include "bench/accuracy/radial_dam_break.h"
#include "bench/accuracy/rotated_dam_break.h"
#include "bench/accuracy/similarity.h"
#include "bench/accuracy/sliding_block.h"
#include "bench/accuracy/solid_cases.h"
#include "bench/accuracy/steep_ground.h"
#include "bench/accuracy/thacker.h"
#include "bench/accuracy/voellmy_plane.h"
#include "bench/set_up/choose.h"
#include "core/raster.h"

namespace frana::bench {
namespace {

void append(std::vector<AccuracyCase>& cases, std::vector<AccuracyCase> more) {
    for (AccuracyCase& one : more) cases.push_back(std::move(one));
}

double order_between(const CaseStatistics& coarse, const CaseStatistics& fine) {
    // Below this an error is the rounding of sums over a grid, which no refinement reduces.
    constexpr double k_rounding = 1e-11;
    if (!(coarse.l1_depth > k_rounding && fine.l1_depth > k_rounding)) return k_no_data;
    return std::log(coarse.l1_depth / fine.l1_depth) / std::log(coarse.cell_size / fine.cell_size);
}

}  // namespace

std::vector<AccuracyCase> accuracy_cases(const std::optional<Raster>& sample_terrain) {
    std::vector<AccuracyCase> cases = lakes();
    if (sample_terrain) cases.push_back(lake_dtm(*sample_terrain));
    append(cases, channel_dam_breaks());
    cases.push_back(rotated_dam_break());
    append(cases, radial_dam_breaks());
    append(cases, granular_slopes());
    append(cases, similarities());
    append(cases, thackers());
    cases.push_back(voellmy_plane());
    cases.push_back(bingham_slump());
    cases.push_back(sliding_block());
    append(cases, steep_ground());
    cases.push_back(conservation());
    append(cases, fluid_cases());
    append(cases, solid_cases());
    return cases;
}

std::vector<AccuracyRow> run_accuracy(const AccuracyOptions& options) {
    std::vector<AccuracyRow> rows;
    for (const AccuracyCase& one : choose(accuracy_cases(options.sample_terrain), options.only, "accuracy")) {
        const std::size_t levels =
            options.quick ? std::min<std::size_t>(2, one.cell_sizes.size()) : one.cell_sizes.size();
        for (const Scheme scheme : k_schemes) {
            if (one.one_scheme && scheme != Scheme::standard) continue;
            for (std::size_t level = 0; level < levels; ++level) {
                AccuracyRow row{one.name, scheme, one.run(one.cell_sizes[level], scheme), k_no_data};
                if (level > 0 && !one.rounding)
                    row.observed_order = order_between(rows.back().statistics, row.statistics);
                if (options.report) {
                    char line[160];
                    std::snprintf(line, sizeof line, "%-18s %-8s %6g m  l1_depth %.3g  %.2f s", one.name.c_str(),
                                  name_of(scheme), row.statistics.cell_size, row.statistics.l1_depth,
                                  row.statistics.wall_seconds);
                    options.report(line);
                }
                rows.push_back(std::move(row));
            }
        }
    }
    return rows;
}

double time_to_error(const std::vector<std::pair<double, double>>& time_and_error, double error) {
    std::size_t under = time_and_error.size();
    while (under > 0 && time_and_error[under - 1].second <= error) --under;
    if (under == time_and_error.size()) return k_no_data;
    if (under == 0) return time_and_error.front().first;
    const auto [t0, e0] = time_and_error[under - 1];
    const auto [t1, e1] = time_and_error[under];
    return t0 * std::pow(t1 / t0, std::log(e0 / error) / std::log(e0 / e1));
}

std::string time_to_error_table(const std::vector<AccuracyRow>& rows) {
    std::map<std::string, std::vector<std::pair<double, double>>> curves;
    for (const AccuracyRow& row : rows) {
        const CaseStatistics& f = row.statistics;
        const double error = std::max(f.l1_depth, f.l1_momentum);
        if (row.scheme == Scheme::standard && f.error.empty() && error > 0)
            curves[row.case_name].emplace_back(f.wall_seconds, error);
    }
    std::string out;
    const auto seconds = [](double s) {
        char text[32];
        std::snprintf(text, sizeof text, std::isnan(s) ? "finer" : "%.3g", s);
        return std::string(text);
    };
    for (auto& [name, curve] : curves) {
        std::sort(curve.begin(), curve.end());
        if (curve.back().second < 1e-9) continue;  // at rounding: nothing to reach
        char line[160];
        std::snprintf(line, sizeof line, "  %-22s %9s %9s    %.2g in %.3g s\n", name.c_str(),
                      seconds(time_to_error(curve, 0.01)).c_str(), seconds(time_to_error(curve, 0.003)).c_str(),
                      curve.back().second, curve.back().first);
        out += line;
    }
    if (out.empty()) return out;
    return "Seconds to an error of 1 % and 0.3 %, default scheme, one thread; the finest resolution's own:\n" + out;
}

namespace {

constexpr std::string_view k_mean = "mean depth error [m]", k_depth_error = "relative L2 of depth",
                           k_momentum = "relative L2 of momentum",
                           k_depth_random = "relative L2 of depth, random particles",
                           k_momentum_random = "relative L2 of momentum, random particles";

constexpr PeerResult k_peers[] = {
    {"stoker", "GeoClaw, order 2", 5, k_mean, 0.0231, 0.14},
    {"stoker", "GeoClaw, order 2", 2.5, k_mean, 0.0119, 0.85},
    {"stoker", "GeoClaw, order 2", 1.25, k_mean, 0.0061, 6.1},
    {"stoker", "GeoClaw, order 2", 0.625, k_mean, 0.0031, 50},
    {"stoker", "D-Claw 1.0", 2.5, k_mean, 0.0096, 4.6},
    {"stoker", "TITAN2D, order 2", 2.9, k_mean, 0.0177, 1.9},
    {"stoker", "r.avaflow", 5, k_mean, 0.0245, 3.2},
    {"ritter", "GeoClaw, order 2", 5, k_mean, 0.0344, 0.17},
    {"ritter", "GeoClaw, order 2", 2.5, k_mean, 0.0176, 1.07},
    {"ritter", "GeoClaw, order 2", 1.25, k_mean, 0.0090, 7.8},
    {"ritter", "GeoClaw, order 2", 0.625, k_mean, 0.0049, 59},
    {"ritter", "D-Claw 1.0", 2.5, k_mean, 0.0151, 5.2},
    {"ritter", "TITAN2D, order 2", 2.9, k_mean, 0.0197, 1.7},
    {"ritter", "r.avaflow", 5, k_mean, 0.060, 2.5},
    {"similarity", "com1DFA", 5, k_depth_error, 0.049, 0},
    {"similarity", "com1DFA", 5, k_momentum, 0.061, 0},
    {"similarity", "com1DFA", 3, k_depth_error, 0.036, 0},
    {"similarity", "com1DFA", 3, k_momentum, 0.048, 0},
    {"similarity", "com1DFA", 2, k_depth_error, 0.028, 78},
    {"similarity", "com1DFA", 2, k_momentum, 0.039, 78},
    {"granular-slope", "com1DFA", 5, k_depth_random, 0.100, 0},
    {"granular-slope", "com1DFA", 5, k_momentum_random, 0.91, 0},
    {"granular-slope", "com1DFA", 2, k_depth_random, 0.059, 0},
    {"granular-slope", "com1DFA", 2, k_momentum_random, 0.54, 0},
    {"granular-slope", "com1DFA", 5, k_depth_error, 0.045, 0},
    {"granular-slope", "com1DFA", 5, k_momentum, 0.14, 0},
};

}  // namespace

std::span<const PeerResult> peer_results() {
    return k_peers;
}

}  // namespace frana::bench
