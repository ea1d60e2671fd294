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
            if ((one.one_scheme && scheme != Scheme::standard) || (one.flies && scheme == Scheme::finite_volume))
                continue;
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

const CaseStatistic* find_statistic(const CaseStatistics& statistics, std::string_view name) {
    for (const CaseStatistic& statistic : statistics.own)
        if (statistic.name == name) return &statistic;
    return nullptr;
}

// Returns the default scheme's row with a peer's cell size or, if there is none, the next coarser one.
const AccuracyRow* row_beside(const PeerResult& peer, const std::vector<AccuracyRow>& rows) {
    const AccuracyRow* best = nullptr;
    for (const AccuracyRow& row : rows) {
        if (row.case_name != peer.case_name || row.scheme != Scheme::standard ||
            row.statistics.cell_size < peer.cell_size)
            continue;
        if (best == nullptr || row.statistics.cell_size < best->statistics.cell_size) best = &row;
    }
    return best;
}

std::string peer_line(const PeerResult& peer, const std::vector<AccuracyRow>& rows) {
    std::string line = text("    %-17s %-8g %-42s %-10.4g", std::string(peer.code).c_str(), peer.cell_size,
                            std::string(peer.measure).c_str(), peer.value);
    if (peer.seconds > 0) line += text(" %.3g s on its own machine", peer.seconds);
    const AccuracyRow* row = row_beside(peer, rows);
    const CaseStatistic* own = row == nullptr ? nullptr : find_statistic(row->statistics, peer.measure);
    if (own == nullptr) return line + "\n";
    line += text("; frana's default, %g m: ", row->statistics.cell_size);
    line += own->value <= peer.value ? text("%.2f of it", own->value / peer.value)
                                     : text("WORSE, %.2f times", own->value / peer.value);
    return line + "\n";
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
    out += own;
    for (const PeerResult& peer : peer_results())
        if (peer.case_name == name) out += peer_line(peer, rows);
    out += "\n";
}

// Returns the cost of the rotated dam relative to the one along the grid, at the same cell size (mark 1.2).
std::string rotation_text(const std::vector<AccuracyRow>& rows) {
    std::string out;
    for (const AccuracyRow& turned : rows) {
        for (const AccuracyRow& aligned : rows) {
            if (turned.case_name != "ritter-rotated" || aligned.case_name != "ritter" ||
                turned.scheme != aligned.scheme || turned.statistics.cell_size != aligned.statistics.cell_size)
                continue;
            const double ratio = turned.statistics.l1_depth / aligned.statistics.l1_depth;
            out += text("ritter-rotated over ritter, %s, %g m cells: %.3f, target 1.2: %s\n", name_of(turned.scheme),
                        turned.statistics.cell_size, ratio, ratio <= 1.2 ? "met" : "MISSED");
        }
    }
    return out.empty() ? out : out + "\n";
}

using Curve = std::vector<std::pair<double, double>>;

Curve curve_of(const std::vector<AccuracyRow>& rows, const std::string& name, Scheme scheme) {
    Curve curve;
    for (const AccuracyRow& row : rows)
        if (row.case_name == name && row.scheme == scheme && row.statistics.error.empty())
            curve.emplace_back(row.statistics.wall_seconds,
                               std::max(row.statistics.l1_depth, row.statistics.l1_momentum));
    std::sort(curve.begin(), curve.end());
    return curve;
}

// Returns the least error of a curve within a time: the best point so far counts.
double best_within(const Curve& curve, double seconds) {
    double best = k_no_data;
    for (const auto& [time, error] : curve)
        if (time <= seconds && !(best <= error)) best = error;
    const double between = error_in_time(curve, seconds);
    return between < best || std::isnan(best) ? between : best;
}

// Compares frana's default and GeoClaw: mean depth error, each in its own time on its own machine.
std::string peer_verdict(const std::vector<AccuracyRow>& rows) {
    std::string out;
    for (const char* name : {"stoker", "ritter"}) {
        Curve own, peer;
        for (const AccuracyRow& row : rows)
            if (row.case_name == name && row.scheme == Scheme::standard)
                own.emplace_back(row.statistics.wall_seconds, row.statistics.mean_depth_error);
        std::sort(own.begin(), own.end());
        for (const PeerResult& statistic : peer_results())
            if (statistic.case_name == name && statistic.code == "GeoClaw, order 2")
                peer.emplace_back(statistic.seconds, statistic.value);
        for (const auto& [seconds, error] : peer) {
            const double ours = error_in_time(own, seconds);
            if (std::isnan(ours)) continue;
            out += text("  %s in %.3g s: GeoClaw %.3g m (published, its own machine), frana's default %.3g m: %s\n",
                        name, seconds, error, ours, ours <= error ? "frana has less" : "GEOCLAW HAS LESS");
        }
    }
    return out.empty() ? out : "Mean depth error beside GeoClaw's for the same time on one thread:\n" + out;
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
    return out + rotation_text(rows);
}

double error_in_time(const std::vector<std::pair<double, double>>& time_and_error, double seconds) {
    for (std::size_t i = 0; i + 1 < time_and_error.size(); ++i) {
        const auto [t0, e0] = time_and_error[i];
        const auto [t1, e1] = time_and_error[i + 1];
        if (seconds < t0 || seconds > t1 || !(t1 > t0)) continue;
        const double w = std::log(seconds / t0) / std::log(t1 / t0);
        return std::exp((1 - w) * std::log(e0) + w * std::log(e1));
    }
    return k_no_data;
}

std::string accuracy_verdict(const std::vector<AccuracyRow>& rows) {
    std::string out = "Least error for a given time (the greater of l1_depth and l1_momentum, one thread):\n";
    int standard = 0, paper = 0, equal = 0;
    for (const std::string& name : case_names(rows)) {
        const auto of_paper_scheme = [&](const AccuracyRow& row) {
            return row.case_name == name && row.scheme == Scheme::paper;
        };
        if (std::none_of(rows.begin(), rows.end(), of_paper_scheme)) continue;  // the structured model has no schemes
        const Curve a = curve_of(rows, name, Scheme::standard), b = curve_of(rows, name, Scheme::paper);
        if (a.empty() || b.empty()) {
            out += "  " + name + ": " + (a.empty() ? "default" : "paper") + " did not reach its end\n";
            (a.empty() ? paper : standard) += 1;
            continue;
        }
        // The longest time that both have used.
        const double seconds = std::max({std::min(a.back().first, b.back().first), a.front().first, b.front().first});
        const double of_standard = best_within(a, seconds), of_paper = best_within(b, seconds);
        constexpr double k_rounding = 1e-12;
        if (of_standard < k_rounding && of_paper < k_rounding) {
            ++equal;
            out += text("  %s: both at rounding\n", name.c_str());
            continue;
        }
        const bool first = of_standard <= of_paper;
        (first ? standard : paper) += 1;
        out += text("  %s: %s, %.3g against %.3g in %.2g s\n", name.c_str(), first ? "default" : "PAPER",
                    first ? of_standard : of_paper, first ? of_paper : of_standard, seconds);
    }
    out += text(
        "The default scheme gives the least error for a given time in %d cases, the paper's in %d; in %d "
        "both "
        "are at rounding.\n",
        standard, paper, equal);
    return out + peer_verdict(rows);
}

}  // namespace frana::bench
