// SPDX-License-Identifier: Apache-2.0
#include "app/study/publish/publish_study.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <string>

#include "app/pictures/map_layer.h"
#include "app/publish/html_page.h"
#include "app/publish/report.h"
#include "app/publish/report_answer.h"
#include "app/publish/report_tables.h"
#include "app/store/result_files.h"
#include "app/study/plan/study_input.h"
#include "app/study/pool/study_result.h"
#include "app/study/publish/map_writer.h"
#include "app/text/number_text.h"
#include "app/text/version.h"
#include "core/text.h"
#include "core/words/words.h"
#include "params/grammar/value_text.h"
#include "params/keys/output_parameters.h"
#include "params/keys/result_rasters.h"
#include "simulation/run_summary.h"

namespace frana::app::study {
namespace {

constexpr std::size_t k_keys = 8, k_names = 3, k_name_letters = 40;

std::string names_of(const std::vector<std::string>& all) {
    std::vector<std::string> names;
    for (const std::string& name : all)
        if (!name.empty() && names.size() < k_names) names.push_back(elided(valid_utf8(name), k_name_letters));
    return joined(names, ", ") + (all.size() > names.size() && !names.empty() ? ", …" : "");
}

std::string varied(const StudyInput& input) {
    const std::vector<Variation>& vary = input.reading.study.vary;
    std::vector<std::string> told;
    for (std::size_t i = 0; i < std::min(k_keys, vary.size()); ++i)
        told.push_back(vary[i].key + " = " + vary[i].distribution.text);
    if (vary.size() > k_keys) told.emplace_back("…");
    return told.empty() ? joined(input.table.keys, ", ") : joined(told, "; ");
}

// What a study's report says first: a row for each fact.

void add_unfinished(const StudyFacts& facts, const Words& words, Table& table) {
    if (const std::size_t unfinished = facts.troubles.unfinished(); unfinished > 0)
        table.row({words("Unfinished"), words("{1} of {2} runs: values are lower bounds",
                                              {std::to_string(unfinished), std::to_string(facts.troubles.runs)})},
                  "warning");
}

void add_scheme(const StudyFacts& facts, const Words& words, Table& table) {
    if (facts.scheme_check)
        for (const auto& [name, value] : rows_of(*facts.scheme_check)) table.row({name.in(words), value.in(words)});
}

std::string area_text(const Interval& area, const Words& words) {
    const ReportNumbers number(words);
    const std::string low = number.grouped(area.low);
    return number.grouped(area.value) +
           " (95 %: " + (std::isnan(area.high) ? "≥ " + low : words("{1} to {2}", {low, number.grouped(area.high)})) +
           ")";
}

/// Where the least depth threshold is exceeded with at least some probability.
void add_areas(const StudyFacts& facts, const Words& words, Table& table) {
    const ReportNumbers number(words);
    for (std::size_t q = facts.reached_m2.size(); q-- > 0;) {
        const double fraction = k_study_quantiles[q].fraction;
        std::string area = number.grouped(facts.reached_m2[q]);
        if (fraction == 0.5) area = area_text(facts.half_reached_m2, words);
        table.row({words("Area deeper than {1} m in ≥ {2} % of runs [m²]",
                         {number(facts.reached_threshold), number.percent(fraction)}),
                   area});
    }
}

std::string rate_text(const FrequencySpec::Rate& rate, const ReportNumbers& number) {
    if (!(rate.value > 0)) return "?";  // its column cannot be read
    return number.of_any_size(rate.value) + (rate.deviation > 0 ? " ± " + number.of_any_size(rate.deviation) : "");
}

/// The least and the greatest volume of a frequency.
std::string volumes_text(const std::vector<FrequencySpec::Volume>& volumes, const ReportNumbers& number,
                         const Words& words) {
    return "≥ " + number.grouped(volumes.front().volume) + " m³; " +
           words("larger events count as {1} m³", {number.grouped(volumes.back().volume)});
}

/// How often the slopes fail, and what that makes of the least depth threshold.
void add_frequency(const FrequencySpec& frequency, const StudyResult& result, const StudyFacts& facts,
                   const Words& words, Table& table) {
    if (!result.rates) return;
    const ReportNumbers number(words);
    std::string rate = rate_text(result.rates->of_all(), number);
    if (const auto& volumes = frequency.volumes) rate += " (" + volumes_text(*volumes, number, words) + ")";
    const bool is_sum = result.rates->sources().size() > 1;
    table.row(
        {with_unit(words(is_sum ? worded("Annual rate, sum of all slopes") : worded("Annual rate")), "1/a"), rate});
    const std::vector<double> periods = frequency.mapped_periods();
    for (std::size_t i = 0; i < facts.once_m2.size(); ++i)
        table.row({with_unit(words("Covered area") + " (> " + number(facts.reached_threshold) + " m), " +
                                 words("once in {1} years", {number.of_any_size(periods[i])}),
                             "m²"),
                   area_text(facts.once_m2[i], words)});
}

void add_errors(const StudyInput& input, const StudyFacts& facts, const Words& words, Table& table) {
    const ReportNumbers number(words);
    const auto percent = [&](double fraction) { return number.percent(fraction) + " %"; };
    table.row({words("Standard error of the probabilities"),
               words("{1} at most, {2} on average", {percent(facts.error.largest()), percent(facts.error.mean())})});
    table.row({words("Margin of a probability of 0 or 1 (95 %)"), percent(facts.least_margin)});
    if (const auto& rare = facts.rare_place)
        table.row({words("Deeper than {1} m at {2}", {number(rare->event.threshold), rare->event.gauge}),
                   percent(rare->probability.value) +
                       " (95 %: " + words("{1} to {2}", {percent(rare->probability.low()), percent(rare->high)}) +
                       "), " + words.labelled(words("Runs"), std::to_string(rare->hits))});
    if (const auto& until = input.reading.study.until)
        table.row({"study.until = " + words.number(shortest_text(*until)),
                   words(facts.error.largest() <= *until ? worded("reached") : worded("not reached"))});
}

Table runs_table(const StudyInput& input, const StudyResult& result, const StudyFacts& facts, const Words& words) {
    const StudySpec& study = input.reading.study;
    Table table;
    std::vector<std::string> areas;
    for (const ReleaseArea& area : input.base.scene.release) areas.push_back(area.name);
    if (const std::string names = names_of(areas); !names.empty()) table.row({words("Release"), names});
    table.row({words("Varied"), varied(input)});
    table.row({words("Runs"), words("{1} of {2}, sampling {3}, seed {4}",
                                    {std::to_string(result.finished_at.size()), std::to_string(result.members.size()),
                                     name_of(study.sampling), std::to_string(study.seed)})});
    add_unfinished(facts, words, table);
    if (!result.finished_at.empty()) {
        add_frequency(study.frequency, result, facts, words, table);
        add_areas(facts, words, table);
        add_errors(input, facts, words, table);
    }
    add_scheme(facts, words, table);
    return table.row(
        {words("Limitations"),
         words(result.rates ? k_condition_with_rate
                            : worded("If the slope fails, for these distributions; errors of the model excluded"))});
}

Table region_table(const StudyInput& input, const StudyResult& result, const StudyFacts& facts, const Words& words) {
    const ReportNumbers number(words);
    Table table;
    std::set<std::size_t> finished;
    for (const std::size_t at : result.finished_at) finished.insert(result.members[at].member / input.table.draws);
    table.row({words("Slopes"), words("{1} of {2}, each failing alone",
                                      {std::to_string(finished.size()), std::to_string(input.slopes.size())})});
    if (result.rates) {
        table.row({words("Varied"), varied(input)});
        table.row(
            {words("Runs"), std::to_string(result.finished_at.size()) + " / " + std::to_string(result.members.size())});
    }
    add_unfinished(facts, words, table);
    const auto& figures = result.figures();
    const auto run_out =
        std::find_if(figures.begin(), figures.end(), [](const auto& one) { return one.key == k_run_out_key; });
    if (run_out != figures.end()) {
        const std::vector<double> values = result.figure(static_cast<std::size_t>(run_out - figures.begin()));
        const auto farthest = static_cast<std::size_t>(std::max_element(values.begin(), values.end()) - values.begin());
        const std::size_t member = result.members[result.finished_at[farthest]].member;
        const std::string& name = input.slope_of(member).name;
        table.row({words("Farthest run-out [m]"),
                   (facts.troubles.any() ? "> " : "") + number.grouped(values[farthest]) + " (" +
                       (name.empty() ? std::to_string(member) : elided(valid_utf8(name), k_name_letters)) + ")"});
        if (!result.rates)
            table.row(
                {words("Median run-out [m]"), number.grouped(weighted_quantile(values, result.finished.weights, 0.5))});
    }
    add_frequency(input.spec().frequency, result, facts, words, table);
    if (!facts.reached_m2.empty())
        table.row({words("Area deeper than {1} m by any slope [m²]", {number(facts.reached_threshold)}),
                   number.grouped(facts.reached_m2.front())});
    add_scheme(facts, words, table);
    return table.row({words("Limitations"),
                      words(result.rates ? k_condition_with_rate
                                         : worded("One set of values for each slope; none fails with another"))});
}

Document figures_table(const StudyResult& result, const Words& words) {
    if (result.figures().empty()) return {};
    const ReportNumbers number(words);
    Table table({words("Value"), "", words("mean"), "5 %", "50 %", "95 %", words("median, 95 %")});
    const std::vector<double>& weights = result.finished.weights;
    for (std::size_t f = 0; f < result.figures().size(); ++f) {
        const std::vector<double> values = result.figure(f);
        const auto quantile = [&](double q) {
            const double value = weighted_quantile(values, weights, q);
            const bool is_bound = result.quantile_bound(f, q) > value;  // open runs may exceed it
            return (is_bound ? "> " : "") + number.of_any_size(value);
        };
        const Figure& figure = result.figures()[f];
        const Interval median = result.quantile_of(f, 0.5);
        const std::string of_median =
            std::isfinite(median.low) && std::isfinite(median.high)
                ? words("{1} to {2}", {number.of_any_size(median.low), number.of_any_size(median.high)})
                : "";
        table.row({figure.title.in(words), ReportNumbers::unit(figure.unit),
                   number.of_any_size(result.mean_of(f).value), quantile(0.05), quantile(0.5), quantile(0.95),
                   of_median});
    }
    return Document().subheading(words("Values of the runs: mean, 5, 50 and 95 % quantiles")).add(table);
}

Document degrees_table(const std::vector<HazardArea>& degrees, const Words& words) {
    if (degrees.empty()) return {};
    const ReportNumbers number(words);
    Table table({"", words("Degree of hazard"), with_unit(words("Covered area"), "m²"),
                 with_unit(words("Area of all generalised zones"), "m²")});
    for (const HazardArea& one : degrees) {
        Cell colour = "";
        colour.swatch = hex(one.kind.colour);
        table.row({colour,
                   class_label(one.kind.name + ": " + one.kind.thresholds, words),
                   {number.grouped(one.area_m2), "n"},
                   {std::isnan(one.zones_m2) ? "" : number.grouped(one.zones_m2), "n"}});
    }
    return table;
}

/// The first page of a study's report: what varies, where it goes in how many of the runs, how sure that is. Of a
/// region: what any slope reaches.
Document study_answer(const StudyInput& input, const StudyResult& result, const StudyFacts& facts, const Words& words) {
    Document answer;
    if (facts.troubles.are_first()) answer.add(Paragraph{{}, headline(facts.troubles).in(words), "warning"});
    answer.heading("answer", words("Answer"));
    if (input.reading.study.region)
        return answer.add(region_table(input, result, facts, words)).first_warnings(facts.warnings, words);
    return answer.add(runs_table(input, result, facts, words)).first_warnings(facts.warnings, words);
}

/// The figures of the runs with their mean and quantiles; of a region the areas of the degrees of hazard.
Document study_values(const StudyInput& input, const StudyResult& result, const StudyFacts& facts, const Words& words) {
    if (input.reading.study.region) return degrees_table(facts.degrees, words);
    return figures_table(result, words);
}

/// Slopes that a report lists; members.gpkg has all.
constexpr std::size_t k_most_slopes = 50;

/// Of a region with a frequency: how often each slope fails, and how many of its runs finished.
Document sources_section(const StudyInput& input, const StudyResult& result, const Words& words) {
    const AnnualRates& rates = *result.rates;
    const ReportNumbers number(words);
    const auto has_volumes = [](const Slope& slope) { return slope.frequency.volumes.has_value(); };
    const bool with_volumes = std::any_of(input.slopes.begin(), input.slopes.end(), has_volumes);
    std::vector<std::string> heads{"", words("Slope"), with_unit(words("Annual rate"), "1/a")};
    if (with_volumes) heads.push_back(words("Volume"));
    heads.insert(heads.end(), {words("Runs"), words("reason")});
    Table table(heads);
    for (std::size_t i = 0; i < std::min(k_most_slopes, rates.sources().size()); ++i) {
        const Source& source = rates.sources()[i];
        std::vector<Cell> cells{std::to_string(i), valid_utf8(source.name), rate_text(source.rate, number)};
        const auto& volumes = input.slopes[i].frequency.volumes;
        if (with_volumes) cells.push_back(volumes ? volumes_text(*volumes, number, words) : "");
        cells.push_back(std::to_string(source.members.size()) + " / " + std::to_string(source.shares.size()));
        cells.push_back(words(result.members[input.first_member(i)].failure));
        table.row(cells);
    }
    return Document().heading("slopes", words("Slopes")).add(table);
}

namespace fs = std::filesystem;

constexpr std::size_t k_figures_on_first_page = 12;

Table keys_table(const StudyInput& input, const Words& words) {
    Table table({words("Key"), words("distribution")});
    for (const Variation& one : input.reading.study.vary) table.row({one.key, one.distribution.text});
    for (const Correlation& one : input.reading.study.correlate)
        table.row(
            {one.first + ", " + one.second, words("rank correlation {1}", {words.number(shortest_text(one.rho))})});
    return table;
}

Table failures_list(const StudyInput& input, const StudyResult& result, const Words& words) {
    Table table({words("member"), words("reason")});
    for (const MemberRecord& member : result.members) {
        if (member.failure.empty()) continue;
        std::vector<std::string> names{std::to_string(member.member)};
        if (!input.slopes.empty())
            for (const std::string& name : {input.slope_of(member.member).name, input.slope_of(member.member).scenario})
                if (!name.empty()) names.push_back(valid_utf8(name));
        table.row({joined(names, ", "), member.failure});
    }
    return table;
}

/// The map that answers the question of the study first.
std::vector<std::string> maps_in_order(const StudyInput& input, const ResultDirectory& directory) {
    const std::vector<double>& depths = input.base.spec.output.depth_thresholds;
    const std::string of_runs = depths.empty() ? "probability" : "probability_depth_" + shortest_text(depths.front());
    std::vector<std::string> maps = pictures_in(directory.path("maps"));
    for (const std::string& name :
         {std::string("union_max_depth"), std::string(RasterName::hazard_degree), of_runs, rate_name(of_runs)}) {
        const auto found = std::find_if(maps.begin(), maps.end(),
                                        [&](const std::string& map) { return fs::path(map).stem() == name; });
        if (found != maps.end()) std::rotate(maps.begin(), found, found + 1);
    }
    return maps;
}

std::string title_of(const StudyInput& input, const Words& words) {
    const SceneSpec& spec = input.base.spec;
    const std::string name = spec.output.title.value_or(scene_name(spec));
    return input.reading.study.region ? words("{1}: a region of many slopes", {name})
                                      : words("{1}: a range of runs", {name});
}

void add_inputs(const StudyInput& input, const StudyFacts& facts, const Words& words, Document& page) {
    page.heading("inputs", words("Distributions and inputs"));
    if (!input.reading.study.vary.empty()) page.add(keys_table(input, words));
    if (input.base.friction) {
        const ShownFriction shown = shown_friction(input);
        const auto notes = study_friction_notes(shown.of, joined(shown.varied, ", "), words);
        page.subheading(words("Friction by place"))
            .paragraph(joined(notes, ". ") + ".")
            .add(friction_table(*input.base.friction, facts.friction_areas, words));
    }
    page.add(inputs_table(input.base, words)).folded(words("Keys used"), parameters_table(input.base, true, words));
}

}  // namespace

void end_page(const StudyInput& input, const std::string& title, const Table& failures, const StudyFacts& facts,
              Opening opening, Document page, const std::string& folder) {
    const Words words = words_of(input.studies().front()->base.spec);
    if (!facts.warnings.empty()) page.warnings(facts.warnings, words);
    if (!failures.rows().empty()) page.heading("failures", words("Failed runs")).add(failures);
    const std::string origin =
        words("Computed with {1}, study {2}, {3}",
              {std::string(k_program) + " " + k_version, fs::path(input.spec().file).filename().string(), facts.date});
    write_page(folder, {title, origin, words, opening}, page);
}

void write_study_report(const StudyInput& input, const StudyResult& result, const StudyFacts& facts,
                        const ResultDirectory& directory) {
    const Words words = words_of(input.base.spec);
    const std::vector<std::string> maps = maps_in_order(input, directory);
    const std::string& folder = directory.folder();
    Document page = study_answer(input, result, facts, words);
    page.add(exposure_answer(facts.exposure, ReachedBy::any_run, words));
    if (!maps.empty()) page.maps({maps.front()}, folder, words);
    // The first page of paper has room for a short table under its picture.
    const bool is_short = input.reading.study.region || result.figures().size() <= k_figures_on_first_page;
    if (is_short) page.add(study_values(input, result, facts, words));
    page.end_answer();
    if (!is_short) page.add(study_values(input, result, facts, words));
    page.add(exposure_section(facts.exposure, words));
    if (input.reading.study.region && result.rates) page.add(sources_section(input, result, words));
    if (maps.size() > 1) page.heading("maps", words("Maps")).maps({maps.begin() + 1, maps.end()}, folder, words);
    add_inputs(input, facts, words, page);
    page.charts(study_charts(), folder, words);
    end_page(input, title_of(input, words), failures_list(input, result, words), facts,
             maps.empty() ? Opening::answer : Opening::answer_with_picture, std::move(page), folder);
}

}  // namespace frana::app::study
