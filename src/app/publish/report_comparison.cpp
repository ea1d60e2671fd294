// SPDX-License-Identifier: Apache-2.0
#include "app/publish/report_comparison.h"

#include <filesystem>
#include <optional>

#include "app/pictures/charts.h"
#include "app/pictures/map_layer.h"
#include "app/publish/report.h"
#include "app/publish/report_tables.h"
#include "app/store/result_files.h"
#include "app/text/number_text.h"
#include "params/keys/result_rasters.h"

namespace frana::app {
namespace {

namespace fs = std::filesystem;

void add_statistics(Table& table, const ComparisonStatistics& f, const Words& words) {
    const auto area = [&](const std::string& name, double value) {
        table.number(name, words.number(grouped(value)), "m²");
    };
    const auto score = [&](const std::string& name, double value, const std::string& unit) {
        table.number(name, words.number(number_text(value, 3)), unit);
    };
    score(words("Depth threshold"), f.threshold_m, "m");
    area(words("Observed area"), f.observed_area_m2);
    area(words("Simulated area"), f.simulated_area_m2);
    table.number(words("Area difference"), words.number(signed_number_text(f.signed_area_difference_percent())), "%");
    area(words("Hit"), f.hit_m2);
    area(words("False alarm"), f.false_alarm_m2);
    area(words("Miss"), f.miss_m2);
    score(words("Jaccard index"), f.jaccard, "");
    score(words("Dice coefficient"), f.dice, "");
    score(words("True positive rate"), f.true_positive_rate, "");
    score(words("False positive rate"), f.false_positive_rate, "");
    score(words("Area under the ROC curve"), f.auroc, "");
}

Table scores_table(const Comparison& c, const Words& words) {
    Table table;
    const auto number = [&](double value) { return words.number(number_text(value, 3)); };
    const auto signed_number = [&](double value) { return words.number(signed_number_text(value)); };
    if (c.statistics) add_statistics(table, *c.statistics, words);
    if (c.outline) {
        table.number(words("Distance of the outlines, mean"), number(c.outline->mean_m), "m")
            .number(words("Distance of the outlines, 95 %"), number(c.outline->percentile_95_m), "m")
            .number(words("Hausdorff distance of the outlines"), number(c.outline->hausdorff_m), "m");
    }
    if (c.runout_difference_m)
        table.number(words("Run-out, simulated minus observed"), signed_number(*c.runout_difference_m), "m");
    if (c.path_runout) {
        table
            .number(words("Run-out along the flow path") + ", " + words("simulated"),
                    words.number(grouped(c.path_runout->simulated_m)), "m")
            .number(words("Run-out along the flow path") + ", " + words("observed"),
                    words.number(grouped(c.path_runout->observed_m)), "m");
    }
    for (const FrontComparison& front : c.fronts) {
        table.number(words("Front {1}: mean distance, + beyond", {front.name}), signed_number(front.mean_m), "m")
            .number(words("Front {1}: reached, of its length", {front.name}), number(front.reached_percent), "%");
    }
    for (const TipComparison& tip : c.tips)
        table.number(words("Tip {1}: distance, + beyond", {tip.name}), signed_number(tip.distance_m), "m");
    return table;
}

Table deposit_table(const Comparison& c, const Words& words) {
    Table table;
    const auto number = [&](double value) { return words.number(number_text(value, 3)); };
    add_statistics(table, *c.deposit_overlap, words);
    if (const auto& d = c.deposit_depth) {
        table.number(words("Volume") + ", " + words("observed"), words.number(grouped(d->observed_volume_m3)), "m³")
            .number(words("Volume") + ", " + words("simulated"), words.number(grouped(d->simulated_volume_m3)), "m³")
            .number(words("Mean error of depth"), words.number(signed_number_text(d->bias_m)), "m")
            .number(words("Mean absolute error of depth"), number(d->mean_absolute_error_m), "m")
            .number(words("Root mean square error of depth"), number(d->rmse_m), "m")
            .number(words("Correlation of the depths"), number(d->correlation), "");
    }
    return table;
}

}  // namespace

Document comparison_answer(const std::optional<Comparison>& comparison, const Words& words) {
    if (!comparison) return {};
    Table table({words("Comparison with the survey"), "", ""});
    if (const auto& f = comparison->statistics)
        table.number(words("Jaccard index"), words.number(number_text(f->jaccard, 3)), "")
            .number(words("True positive rate"), words.number(number_text(f->true_positive_rate, 3)), "")
            .number(words("False alarm"), words.number(grouped(f->false_alarm_m2)), "m²");
    if (comparison->runout_difference_m)
        table.number(words("Run-out, simulated minus observed"),
                     words.number(signed_number_text(*comparison->runout_difference_m)), "m");
    return table.rows().empty() ? Document() : Document(std::move(table));
}

Document comparison_section(const std::optional<Comparison>& comparison, const std::string& picture,
                            const Words& words) {
    if (!comparison) return {};
    const Comparison& c = *comparison;
    Document section;
    section.heading("comparison", words("Comparison with the survey"));
    if (c.statistics && fs::exists(picture))
        section.add(Figure{
            picture, words("Comparison with the survey"),
            words.labelled(words("Hit"), words.number(grouped(c.statistics->hit_m2)) + " m²; ") +
                words.labelled(words("False alarm"), words.number(grouped(c.statistics->false_alarm_m2)) + " m²; ") +
                words.labelled(words("Miss"), words.number(grouped(c.statistics->miss_m2)) + " m²")});
    section.add(scores_table(c, words));
    if (c.deposit_overlap) section.subheading(words("Deposit")).add(deposit_table(c, words));
    return section;
}

}  // namespace frana::app
