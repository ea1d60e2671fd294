// SPDX-License-Identifier: Apache-2.0
#include "bench/accuracy/accuracy.h"

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <map>

#include "bench/set_up/setup.h"
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
    cases.push_back(conservation());
    return cases;
}

std::vector<AccuracyRow> run_accuracy(const AccuracyOptions& options) {
    std::vector<AccuracyRow> rows;
    for (const AccuracyCase& one : choose(accuracy_cases(options.sample_terrain), options.only, "accuracy")) {
        const std::size_t levels =
            options.quick ? std::min<std::size_t>(2, one.cell_sizes.size()) : one.cell_sizes.size();
        for (const Scheme scheme : k_schemes) {
            for (std::size_t level = 0; level < levels; ++level) {
                AccuracyRow row{one.name, scheme, one.run(one.cell_sizes[level], scheme), k_no_data};
                if (level > 0 && !one.rounding)
                    row.observed_order = order_between(rows.back().statistics, row.statistics);
                if (options.report) {
                    char line[160];
                    std::snprintf(line, sizeof line, "%-18s %-13s %6g m  l1_depth %.3g  %.2f s", one.name.c_str(),
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

namespace {

[[gnu::format(printf, 1, 2)]] std::string text(const char* format, ...) {
    char buffer[512];
    va_list values;
    va_start(values, format);
    std::vsnprintf(buffer, sizeof buffer, format, values);
    va_end(values);
    return buffer;
}

std::string order_text(double order) {
    return std::isnan(order) ? "-" : text("%.2f", order);
}

// Returns the names of the cases in the order of the runs.
std::vector<std::string> case_names(const std::vector<AccuracyRow>& rows) {
    std::vector<std::string> names;
    for (const AccuracyRow& row : rows)
        if (names.empty() || names.back() != row.case_name) names.push_back(row.case_name);
    return names;
}

void add_case(const std::string& name, const std::vector<AccuracyRow>& rows, std::string& out) {
    out += name + "\n";
    out += text("  %-8s %8s %9s %7s %9s %10s %10s %10s %10s %6s\n", "scheme", "cell m", "particles", "steps", "wall s",
                "l1_depth", "l2_depth", "linf m", "l1_moment.", "order");
    const AccuracyRow *first = nullptr, *last = nullptr;
    std::string own;
    for (const AccuracyRow& row : rows) {
        if (row.case_name != name) continue;
        const CaseStatistics& f = row.statistics;
        out += text("  %-8s %8g %9lld %7lld %9.3g %10.3g %10.3g %10.3g %10.3g %6s%s\n", name_of(row.scheme),
                    f.cell_size, static_cast<long long>(f.particles), static_cast<long long>(f.steps), f.wall_seconds,
                    f.l1_depth, f.l2_depth, f.linf_depth, f.l1_momentum, order_text(row.observed_order).c_str(),
                    f.error.empty() ? "" : ("  FAILED: " + f.error).c_str());
        for (const CaseStatistic& statistic : f.own) {
            own += text("    %-8s %8g m  %-42s %11.4g", name_of(row.scheme), f.cell_size, statistic.name.c_str(),
                        statistic.value);
            if (statistic.mark) own += text("  target %g: %s", *statistic.mark, statistic.met() ? "met" : "MISSED");
            own += "\n";
        }
        if (row.scheme != Scheme::standard || std::isnan(row.observed_order)) {
            if (row.scheme == Scheme::standard && first == nullptr) first = &row;
            continue;
        }
        last = &row;
    }
    if (first != nullptr && last != nullptr) {
        const CaseStatistics &a = first->statistics, &b = last->statistics;
        const auto order = [&](double coarse, double fine) {
            return fine > 0 ? order_text(std::log(coarse / fine) / std::log(a.cell_size / b.cell_size))
                            : std::string("-");
        };
        out += text("  default, from %g to %g m: order of depth %s, of momentum %s\n", a.cell_size, b.cell_size,
                    order(a.l1_depth, b.l1_depth).c_str(), order(a.l1_momentum, b.l1_momentum).c_str());
    }
    out += own + "\n";
}

}  // namespace

std::string accuracy_csv(const std::vector<AccuracyRow>& rows) {
    std::string out =
        "case,scheme,cell_size,particles,steps,wall_seconds,cpu_seconds,l1_depth,l2_depth,linf_depth,l1_momentum,"
        "observed_order\n";
    for (const AccuracyRow& row : rows) {
        const CaseStatistics& f = row.statistics;
        out += text("%s,%s,%.9g,%lld,%lld,%.6g,%.6g,%.9g,%.9g,%.9g,%.9g,", row.case_name.c_str(), name_of(row.scheme),
                    f.cell_size, static_cast<long long>(f.particles), static_cast<long long>(f.steps), f.wall_seconds,
                    f.cpu_seconds, f.l1_depth, f.l2_depth, f.linf_depth, f.l1_momentum);
        out += std::isnan(row.observed_order) ? "nan\n" : text("%.4f\n", row.observed_order);
    }
    return out;
}

std::string accuracy_table(const std::vector<AccuracyRow>& rows) {
    std::string out;
    for (const std::string& name : case_names(rows)) add_case(name, rows, out);
    return out;
}

}  // namespace frana::bench
