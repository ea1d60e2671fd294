// SPDX-License-Identifier: Apache-2.0
#include "app/compare/comparison_table.h"

#include "app/text/number_text.h"
#include "app/text/text_table.h"
#include "app/text/unit_sign.h"
#include "core/shortest_text.h"

namespace frana::app {
namespace {

/// Rows of name, value and what the value means.
class Scores {
  public:
    Scores() : table_({{"score", 30}, {"value", 18, true}, {"meaning", 56}}, false) {}
    void add(const std::string& name, const std::string& value, const std::string& meaning) {
        table_.add({name, value, meaning});
    }
    void add_areas(const ComparisonStatistics& f, const std::string& what) {
        add("observed " + what, grouped(f.observed_area_m2) + " m2", "");
        add("simulated " + what, grouped(f.simulated_area_m2) + " m2",
            signed_number_text(f.signed_area_difference_percent()) + " % in size, wherever they lie");
        add("Jaccard index", number_text(f.jaccard, 3), "common ground of all covered: 1 agrees everywhere");
        add("hits", number_text(100 * f.true_positive_rate, 3) + " %", "of the observed ground is covered");
        add("false alarms", grouped(f.false_alarm_m2) + " m2", "covered, not observed");
        add("misses", grouped(f.miss_m2) + " m2", "observed, not covered");
        add("D2PC", number_text(f.d2pc, 3), "distance to perfect classification: 0 is perfect");
        add("AUROC", number_text(f.auroc, 3), "over all depth thresholds: 1 is perfect");
    }
    [[nodiscard]] std::string text(std::size_t width) const { return table_.text(width); }

  private:
    TextTable table_;
};

}  // namespace

std::string comparison_table(const Comparison& comparison, const ComparisonInput& input, std::size_t width) {
    Scores scores;
    if (comparison.statistics) scores.add_areas(*comparison.statistics, "area");
    if (const auto& outline = comparison.outline) {
        scores.add("outline, mean distance", number_text(outline->mean_m, 3) + " m", "");
        scores.add("outline, 95 % within", number_text(outline->percentile_95_m, 3) + " m",
                   "at most " + number_text(outline->hausdorff_m, 3) + " m");
    }
    if (comparison.runout_difference_m)
        scores.add("run-out", signed_number_text(*comparison.runout_difference_m) + " m", "simulated minus observed");
    if (const auto& path = comparison.path_runout)
        scores.add(
            "run-out along the path", signed_number_text(path->simulated_m - path->observed_m) + " m",
            number_text(path->simulated_m, 4) + " m simulated, " + number_text(path->observed_m, 4) + " m observed");
    for (const FrontComparison& front : comparison.fronts)
        scores.add("front " + front.name, signed_number_text(front.mean_m) + " m",
                   "mean; " + number_text(front.reached_percent, 3) + " % of the line was reached");
    for (const TipComparison& tip : comparison.tips)
        scores.add("tip " + tip.name, signed_number_text(tip.distance_m) + " m", "greater than 0: reached beyond it");
    if (comparison.deposit_overlap) scores.add_areas(*comparison.deposit_overlap, "deposit");
    if (const auto& depth = comparison.deposit_depth)
        scores.add("depth of the deposit", signed_number_text(depth->bias_m) + " m",
                   "mean error; root mean square " + number_text(depth->rmse_m, 3) + " m");
    return "Covered: deeper than " + shortest_text(input.threshold) + " m\n\n" + scores.text(width);
}

std::string probability_table(const ProbabilityScores& scores, std::size_t width) {
    Scores table;
    table.add("observed area", grouped(scores.observed_area_m2) + " m2", "");
    table.add("Brier score", number_text(scores.brier, 3), "mean square error of the probability: 0 is perfect");
    table.add("Brier skill", number_text(scores.brier_skill, 3), "1 is perfect, 0 as good as the mean everywhere");
    table.add("reliability", number_text(scores.reliability, 3), "0: the probabilities are those observed");
    table.add("resolution", number_text(scores.resolution, 3), "how far they differ from the mean");
    table.add("AUROC", number_text(scores.auroc, 3), "1 is perfect");
    return table.text(width);
}

}  // namespace frana::app
