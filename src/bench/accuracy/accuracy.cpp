// SPDX-License-Identifier: Apache-2.0
#include "bench/accuracy/accuracy.h"

#include <algorithm>
#include <cstdio>

#include "bench/accuracy/bingham_slump.h"
#include "bench/accuracy/channel_dam_break.h"
#include "bench/accuracy/conservation.h"
#include "bench/accuracy/fluid_cases.h"
#include "bench/accuracy/granular_slope.h"
#include "bench/accuracy/lake.h"
#include "bench/accuracy/lake_dtm.h"
#include "bench/accuracy/radial_dam_break.h"
#include "bench/accuracy/rotated_dam_break.h"
#include "bench/accuracy/similarity.h"
#include "bench/accuracy/sliding_block.h"
#include "bench/accuracy/solid_cases.h"
#include "bench/accuracy/steep_ground.h"
#include "bench/accuracy/thacker.h"
#include "bench/accuracy/voellmy_plane.h"
#include "bench/set_up/choose.h"

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

}  // namespace frana::bench
