// SPDX-License-Identifier: Apache-2.0
#include "app/ensemble/member_troubles.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "app/input/check_release.h"
#include "core/shortest_text.h"

namespace frana::app {
namespace {

Sentence count(std::size_t number) {
    return numeral(std::to_string(number));
}

/// A warning of the runs, told with the one whose figure is the worst.
struct KindOfWarning {
    Sentence worst;
    std::string table;
    std::size_t member = 0, runs = 0;
    double severity = 0;
};

/// The figure that a warning is about, the first of its numbers; of a number of particles the fewest are the worst.
double severity_of(const Sentence& warning) {
    const double figure = warning.first_number().value_or(0);
    return warning.pattern() == k_few_particles_warning ? -figure : figure;
}

}  // namespace

Troubles troubles_of(const std::vector<RunOfStudy>& runs, bool each_counts) {
    Troubles all;
    all.each_counts = each_counts;
    all.runs = runs.size();
    for (const RunOfStudy& run : runs) {
        all.failed += run.failure.empty() ? 0 : 1;
        all.warned += run.end.warnings.empty() ? 0 : 1;
        all.open += run.failure.empty() && run.end.is_open() ? 1 : 0;
        if (run.end.is_cut) {
            ++all.cut;
            all.most_moving = std::max(all.most_moving, run.end.moving_fraction);
        }
        if (run.end.left()) {
            ++all.left;
            all.most_left = std::max(all.most_left, run.end.left_fraction);
        }
    }
    return all;
}

std::vector<Sentence> kinds_of_warnings(const std::vector<RunOfStudy>& runs, const std::vector<Sentence>& known) {
    std::vector<std::string> order;
    std::map<std::string, KindOfWarning> kinds;
    for (const RunOfStudy& run : runs) {
        std::set<std::string> told;
        for (const Sentence& warning : run.end.warnings) {
            if (std::find(known.begin(), known.end(), warning) != known.end()) continue;
            const auto [at, is_new] = kinds.try_emplace(warning.pattern());
            if (is_new) order.push_back(warning.pattern());
            KindOfWarning& kind = at->second;
            kind.runs += told.insert(warning.pattern()).second ? 1 : 0;
            const double severity = severity_of(warning);
            if (!is_new && !(severity > kind.severity)) continue;
            kind.worst = warning;
            kind.member = run.member;
            kind.table = run.table;
            kind.severity = severity;
        }
    }
    std::vector<Sentence> sentences;
    for (const std::string& pattern : order) {
        const KindOfWarning& kind = kinds.at(pattern);
        const Sentence some = count(kind.runs), all = count(runs.size()), member = count(kind.member);
        sentences.push_back(kind.table.empty() ? worded("{1} of {2} runs warn, most of all member {3}: {4}",
                                                        {some, all, member, kind.worst})
                                               : worded("{1} of {2} runs warn, most of all member {3} of {4}: {5}",
                                                        {some, all, member, kind.table, kind.worst}));
    }
    return sentences;
}

std::vector<std::string> end_values(const study::MemberEnd& end) {
    const bool ran = !end.stop_reason.empty();
    const auto cell = [&](double value) { return ran && !std::isnan(value) ? shortest_text(value) : std::string(); };
    return {end.stop_reason, cell(end.moving_fraction), cell(end.left_fraction), cell(end.energy_error),
            std::to_string(end.warnings.size())};
}

void add_end(const study::MemberEnd& end, std::map<std::string, double>& numbers,
             std::map<std::string, std::string>& texts) {
    texts["stop_reason"] = end.stop_reason;
    numbers["warnings"] = static_cast<double>(end.warnings.size());
    if (end.stop_reason.empty()) return;
    numbers["moving_fraction"] = end.moving_fraction;
    numbers["left_domain_fraction"] = end.left_fraction;
    if (!std::isnan(end.energy_error)) numbers["energy_error"] = end.energy_error;
}

}  // namespace frana::app
