// SPDX-License-Identifier: Apache-2.0
#include "bench/accuracy/time_to_error.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include "core/raster.h"

namespace frana::bench {

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

}  // namespace frana::bench
