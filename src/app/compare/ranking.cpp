// SPDX-License-Identifier: Apache-2.0
#include "app/compare/ranking.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "app/text/number_text.h"
#include "app/text/text_file.h"
#include "app/text/text_table.h"
#include "core/text.h"

namespace frana::app {
namespace {

constexpr double k_unknown = std::numeric_limits<double>::quiet_NaN();

double front_distance(const Comparison& comparison) {
    double sum = 0;
    for (const FrontComparison& front : comparison.fronts) sum += front.size.mean_m;
    for (const TipComparison& tip : comparison.tips) sum += std::abs(tip.distance_m);
    const std::size_t count = comparison.fronts.size() + comparison.tips.size();
    return count == 0 ? k_unknown : sum / static_cast<double>(count);
}

/// Order of the ranking, less is better; fronts come after every Jaccard index.
double disagreement(const Comparison& comparison) {
    if (comparison.statistics) return 1 - comparison.statistics->jaccard;
    const double distance = front_distance(comparison);
    return std::isnan(distance) ? std::numeric_limits<double>::infinity() : 2 + distance;
}

}  // namespace

std::string Ranking::folder_for(const std::string& result, const std::string& scar) {
    const std::string name = shortened_name(result + "_" + scar);
    std::string folder = name;
    for (int i = 2; std::find(folders_.begin(), folders_.end(), folder) != folders_.end(); ++i)
        folder = name + "_" + std::to_string(i);
    folders_.push_back(folder);
    return folder;
}

void Ranking::add(const std::string& folder, const std::string& simulated, const std::string& observed,
                  const Comparison& comparison, std::map<std::string, std::string> scene) {
    entries_.push_back({folder, simulated, observed, comparison, std::move(scene)});
    entries_.back().comparison.classes = Raster();  // the table needs no cells
}

std::string Ranking::Entry::value(const std::string& key) const {
    const auto found = scene.find(key);
    return found == scene.end() ? "" : found->second;
}

std::vector<const Ranking::Entry*> Ranking::ordered() const {
    std::vector<const Entry*> order;
    for (const Entry& entry : entries_) order.push_back(&entry);
    std::stable_sort(order.begin(), order.end(), [](const Entry* a, const Entry* b) {
        return disagreement(a->comparison) < disagreement(b->comparison);
    });
    return order;
}

std::vector<std::string> Ranking::varied() const {
    std::vector<std::string> keys;
    const Entry* first = nullptr;
    for (const Entry& entry : entries_) {
        if (entry.scene.empty()) continue;
        if (first == nullptr) first = &entry;
        const auto differs = [&](const std::string& key) {
            return key.rfind("output.", 0) != 0 && first->value(key) != entry.value(key) &&
                   std::find(keys.begin(), keys.end(), key) == keys.end();
        };
        for (const auto* scene : {&first->scene, &entry.scene})
            for (const auto& [key, value] : *scene)
                if (differs(key)) keys.push_back(key);
    }
    std::sort(keys.begin(), keys.end());
    return keys;
}

std::string Ranking::table(std::size_t width) const {
    const std::vector<std::string> keys = varied();
    std::vector<TextTable::Column> columns{{"rank", 4, true}, {"folder", 30}};
    for (const std::string& key : keys) columns.push_back({key, 40});
    for (const char* title :
         {"Jaccard index", "area difference [%]", "hits of observed [%]", "run-out difference [m]", "front [m]"})
        columns.push_back({title, 12, true});
    TextTable table(columns, false);
    int rank = 0;
    for (const Entry* entry : ordered()) {
        const Comparison& c = entry->comparison;
        std::vector<std::string> row{std::to_string(++rank), entry->folder};
        for (const std::string& key : keys) row.push_back(entry->value(key));
        const auto add = [&row](double value) { row.push_back(std::isnan(value) ? "-" : number_text(value, 3)); };
        add(c.statistics ? c.statistics->jaccard : k_unknown);
        add(c.statistics ? c.statistics->area_difference_percent : k_unknown);
        add(c.statistics ? 100 * c.statistics->true_positive_rate : k_unknown);
        add(c.runout_difference_m.value_or(k_unknown));
        add(front_distance(c));
        table.add(row);
    }
    return table.text(width);
}

std::string Ranking::csv() const {
    std::string text =
        "rank,folder,simulated,observed,jaccard,dice,area_difference_percent,true_positive_rate,"
        "false_positive_rate,d2pc,auroc,outline_mean_m,outline_95_m,hausdorff_m,runout_difference_m,"
        "path_runout_difference_m,front_distance_m,deposit_jaccard,deposit_rmse_m";
    const std::vector<std::string> keys = varied();
    for (const std::string& key : keys) text += "," + key;
    text += '\n';
    int rank = 0;
    for (const Entry* entry : ordered()) {
        const Comparison& c = entry->comparison;
        text += std::to_string(++rank) + "," + csv_cell(entry->folder) + "," + csv_cell(entry->simulated) + "," +
                csv_cell(entry->observed);
        const auto add = [&text](double value) { text += "," + (std::isnan(value) ? "" : shortest_text(value)); };
        const auto add_statistic = [&](double ComparisonStatistics::*member) {
            add(c.statistics ? (*c.statistics).*member : k_unknown);
        };
        for (const auto member :
             {&ComparisonStatistics::jaccard, &ComparisonStatistics::dice,
              &ComparisonStatistics::area_difference_percent, &ComparisonStatistics::true_positive_rate,
              &ComparisonStatistics::false_positive_rate, &ComparisonStatistics::d2pc, &ComparisonStatistics::auroc})
            add_statistic(member);
        add(c.outline ? c.outline->mean_m : k_unknown);
        add(c.outline ? c.outline->percentile_95_m : k_unknown);
        add(c.outline ? c.outline->hausdorff_m : k_unknown);
        add(c.runout_difference_m.value_or(k_unknown));
        add(c.path_runout ? c.path_runout->simulated_m - c.path_runout->observed_m : k_unknown);
        add(front_distance(c));
        add(c.deposit_overlap ? c.deposit_overlap->jaccard : k_unknown);
        add(c.deposit_depth ? c.deposit_depth->rmse_m : k_unknown);
        for (const std::string& key : keys) text += "," + csv_cell(entry->value(key));
        text += '\n';
    }
    return text;
}

}  // namespace frana::app
