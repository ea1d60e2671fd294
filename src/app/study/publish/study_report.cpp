// SPDX-License-Identifier: Apache-2.0
#include "app/study/publish/publish_study.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numeric>
#include <string>

#include "app/pictures/map_layer.h"
#include "app/publish/html_page.h"
#include "app/publish/report.h"
#include "app/publish/report_answer.h"
#include "app/publish/report_comparison.h"
#include "app/publish/report_tables.h"
#include "app/store/result_files.h"
#include "app/study/plan/study_input.h"
#include "app/study/pool/study_result.h"
#include "app/study/publish/study_files.h"
#include "app/study/publish/study_tables.h"
#include "app/text/number_text.h"
#include "app/text/version.h"
#include "core/colour.h"
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

/// What a study's report says first: a row for each fact.
class AnswerTable {
  public:
    AnswerTable(const StudyInput& input, const StudyResult& result, const StudyFacts& facts, const Words& words)
        : input_(input), result_(result), facts_(facts), words_(words), number_(words) {}

    Table of_runs();
    Table of_slopes();

  private:
    void add(const std::string& name, const std::string& value, const std::string& kind = {}) {
        table_.row({name, value}, kind);
    }
    void add_unfinished();
    void add_scheme();
    void add_areas();
    void add_errors();

    const StudyInput& input_;
    const StudyResult& result_;
    const StudyFacts& facts_;
    const Words& words_;
    ReportNumbers number_;
    Table table_;
};

void AnswerTable::add_unfinished() {
    if (const std::size_t unfinished = facts_.troubles.unfinished(); unfinished > 0)
        add(words_("Unfinished"),
            words_("{1} of {2} runs: values are lower bounds",
                   {std::to_string(unfinished), std::to_string(facts_.troubles.runs)}),
            "warning");
}

void AnswerTable::add_scheme() {
    if (facts_.scheme_check)
        for (const auto& [name, value] : rows_of(*facts_.scheme_check)) add(name.in(words_), value.in(words_));
}

/// Where the least depth threshold is exceeded with at least some probability.
void AnswerTable::add_areas() {
    for (std::size_t q = facts_.reached_m2.size(); q-- > 0;) {
        const double fraction = k_study_quantiles[q].fraction;
        std::string area = number_.grouped(facts_.reached_m2[q]);
        if (fraction == 0.5)
            area += " (" +
                    words_("95 %: {1} to {2}", {number_.grouped(facts_.half_reached_m2.low),
                                                number_.grouped(facts_.half_reached_m2.high)}) +
                    ")";
        add(words_("Area deeper than {1} m in {2} % of the runs or more [m²]",
                   {number_(facts_.reached_threshold), number_.percent(fraction)}),
            area);
    }
}

void AnswerTable::add_errors() {
    const auto percent = [&](double fraction) { return number_.percent(fraction) + " %"; };
    add(words_("Standard error of the probabilities"),
        words_("{1} at most, {2} on average", {percent(facts_.error.largest()), percent(facts_.error.mean())}));
    add(words_("Margin of a probability of 0 or 1 (95 %)"), percent(facts_.least_margin));
    const std::vector<double>& weights = result_.finished.weights;
    add(words_("Weight of one run"), percent(*std::max_element(weights.begin(), weights.end())));
    if (const auto& rare = facts_.rare_place)
        add(words_("Deeper than {1} m at {2}", {number_(rare->event.threshold), rare->event.gauge}),
            percent(rare->probability.value) + " (" +
                words_("95 %: {1} to {2}", {percent(rare->probability.low()), percent(rare->high)}) + "), " +
                words_("{1} runs", {std::to_string(rare->hits)}));
    if (const auto& until = input_.reading.study.until)
        add("study.until = " + words_.number(shortest_text(*until)),
            words_(facts_.error.largest() <= *until ? worded("reached") : worded("not reached")));
}

Table AnswerTable::of_runs() {
    const StudySpec& study = input_.reading.study;
    std::vector<std::string> areas;
    for (const ReleaseArea& area : input_.base.scene.release) areas.push_back(area.name);
    if (const std::string names = names_of(areas); !names.empty()) add(words_("Release"), names);
    add(words_("Varied"), varied(input_));
    add(words_("Runs"), words_("{1} of {2}, sampling {3}, seed {4}",
                               {std::to_string(result_.finished_at.size()), std::to_string(result_.members.size()),
                                name_of(study.sampling), std::to_string(study.seed)}));
    add_unfinished();
    if (!result_.finished_at.empty()) {
        add_areas();
        add_errors();
    }
    add_scheme();
    add(words_("Limitations"), words_("If the slope fails, for these distributions; errors of the model excluded"));
    return table_;
}

std::optional<std::size_t> place_of_figure(const StudyResult& result, const std::string& key) {
    const auto& figures = result.figures();
    const auto found = std::find_if(figures.begin(), figures.end(), [&](const auto& one) { return one.key == key; });
    if (found == figures.end()) return std::nullopt;
    return static_cast<std::size_t>(found - figures.begin());
}

Table AnswerTable::of_slopes() {
    add(words_("Slopes"), words_("{1} of {2}, each failing alone",
                                 {std::to_string(result_.finished_at.size()), std::to_string(result_.members.size())}));
    add_unfinished();
    if (const auto place = place_of_figure(result_, k_run_out_key)) {
        const std::vector<double> values = result_.figure(*place);
        const auto farthest = static_cast<std::size_t>(std::max_element(values.begin(), values.end()) - values.begin());
        const std::size_t member = result_.members[result_.finished_at[farthest]].member;
        const std::string& name = input_.slopes[member].name;
        add(words_("Farthest run-out [m]"),
            (facts_.troubles.any() ? "> " : "") + number_.grouped(values[farthest]) + " (" +
                (name.empty() ? std::to_string(member) : elided(valid_utf8(name), k_name_letters)) + ")");
        add(words_("Median run-out [m]"), number_.grouped(weighted_quantile(values, result_.finished.weights, 0.5)));
    }
    if (!facts_.reached_m2.empty())
        add(words_("Area deeper than {1} m by any slope [m²]", {number_(facts_.reached_threshold)}),
            number_.grouped(facts_.reached_m2.front()));
    add_scheme();
    add(words_("Limitations"), words_("One set of values for each slope; none fails with another"));
    return table_;
}

Document figures_table(const StudyResult& result, const Words& words) {
    if (result.figures().empty()) return {};
    const ReportNumbers number(words);
    Table table({words("value"), "", words("mean"), "5 %", "50 %", "95 %", words("median, 95 %")});
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
    return Document()
        .subheading(words("Values of the runs: mean, and what 5, 50 and 95 % of them do not exceed"))
        .add(table);
}

Document degrees_table(const std::vector<HazardArea>& degrees, const Words& words) {
    if (degrees.empty()) return {};
    const ReportNumbers number(words);
    Table table({"", words("Degree of hazard"), words("area [m²]")});
    for (const HazardArea& one : degrees) {
        Cell colour = "";
        colour.swatch = hex(one.kind.colour);
        table.row({colour,
                   class_label(one.kind.name + ": " + one.kind.thresholds, words),
                   {number.grouped(one.area_m2), "n"}});
    }
    return table;
}

/// The first page of a study's report: what varies, where it goes in how many of the runs, how sure that is. Of a
/// region: what any slope reaches.
Document study_answer(const StudyInput& input, const StudyResult& result, const StudyFacts& facts, const Words& words) {
    AnswerTable table(input, result, facts, words);
    Document answer;
    if (facts.troubles.are_first()) answer.add(Paragraph{{}, headline(facts.troubles).in(words), "warning"});
    answer.heading("answer", words("Scenario and answer"));
    if (input.reading.study.region) return answer.add(table.of_slopes()).first_warnings(facts.warnings, words);
    return answer.add(table.of_runs())
        .part(k_comparison_answer, comparison_answer(std::nullopt, words))
        .first_warnings(facts.warnings, words);
}

/// The figures of the runs with their mean and quantiles; of a region the areas of the degrees of hazard.
Document study_values(const StudyInput& input, const StudyResult& result, const StudyFacts& facts, const Words& words) {
    if (input.reading.study.region) return degrees_table(facts.degrees, words);
    return figures_table(result, words);
}

/// Slopes that a report lists; members.csv has all.
inline constexpr std::size_t k_most_slopes = 50;

/// A figure of members.csv that the table shows.
struct ShownFigure {
    const char *key, *title;
    bool in_groups;  ///< "1 000", else three digits
};

constexpr ShownFigure k_figures[] = {{"volume_m3", worded("Volume [m³]"), true},
                                     {"runout_m", worded("Run-out [m]"), true},
                                     {"max_depth_m", worded("Greatest depth [m]"), false},
                                     {"max_velocity_ms", worded("Greatest speed [m/s]"), false}};

std::string figure_text(const MemberResult& member, const ShownFigure& shown, const Words& words) {
    for (const Figure& figure : member.figures)
        if (figure.key == shown.key)
            return words.number(shown.in_groups ? grouped(figure.value) : number_text(figure.value, 3));
    return "";
}

std::string why_open(const MemberEnd& end, const Words& words) {
    if (end.is_cut) return words("it still moved at the end");
    if (end.left()) return words("it left the computed ground");
    return end.is_held ? words("cells without elevation held it") : "";
}

/// The section of a report with a region's slopes in their order: name, scenario, volume, run-out, greatest depth and
/// speed, or why a slope failed; the first k_most_slopes of them. Empty for other studies.
Document slopes_section(const StudyInput& input, const StudyResult& result, const Words& words) {
    if (!input.reading.study.region) return {};
    const bool has_scenarios = input.reading.study.region->scenario.has_value(), has_failures = result.failed() > 0;
    const bool has_open = std::any_of(result.members.begin(), result.members.end(), [](const MemberResult& member) {
        return member.failure.empty() && member.end.is_open();
    });
    std::vector<std::string> heads{"", words("Slope")};
    if (has_scenarios) heads.push_back(words("Scenario"));
    for (const ShownFigure& shown : k_figures) heads.push_back(words(shown.title));
    if (has_open) heads.push_back(words("Lower bounds, since"));
    if (has_failures) heads.push_back(words("Why it failed"));
    Table table(heads);
    for (std::size_t i = 0; i < std::min(k_most_slopes, result.members.size()); ++i) {
        const MemberResult& member = result.members[i];
        const Slope& slope = input.slopes[member.member];
        std::vector<Cell> cells{std::to_string(member.member), valid_utf8(slope.name)};
        if (has_scenarios) cells.push_back(valid_utf8(slope.scenario));
        // The figures of a run that failed are those of another event.
        for (const ShownFigure& shown : k_figures)
            cells.push_back(member.failure.empty() ? figure_text(member, shown, words) : "");
        if (has_open) cells.push_back(member.failure.empty() ? why_open(member.end, words) : "");
        if (has_failures) cells.push_back(words(member.failure));
        table.row(cells, member.failure.empty() && !member.end.is_open() ? "" : "warning");
    }
    Document section;
    section.heading("slopes", words("Slopes")).add(table);
    if (result.members.size() > k_most_slopes)
        section.small(words("The first {1} of {2} slopes; {3} has all.",
                            {std::to_string(k_most_slopes),
                             words.number(grouped(static_cast<double>(result.members.size()))), k_member_table}));
    return section;
}

namespace fs = std::filesystem;

constexpr std::size_t k_figures_on_first_page = 12;

Table keys_table(const StudyInput& input, const Words& words) {
    Table table({words("key"), words("distribution")});
    for (const Variation& one : input.reading.study.vary) table.row({one.key, one.distribution.text});
    for (const Correlation& one : input.reading.study.correlate)
        table.row(
            {one.first + ", " + one.second, words("rank correlation {1}", {words.number(shortest_text(one.rho))})});
    return table;
}

std::string interval_text(const std::optional<Interval>& one, const Words& words) {
    if (!one) return "";
    const ReportNumbers number(words);
    if (std::isnan(one->low)) return number(one->value, 2);
    return words("{1} ({2} to {3})", {number(one->value, 2), number(one->low, 2), number(one->high, 2)});
}

/// Of Morris' design, the greatest effects on a figure first.
Document effects_table(const StudyInput& input, const std::vector<FigureSensitivity>& figures, const Words& words) {
    const ReportNumbers number(words);
    Table table({words("value"), words("key"), words("mean change"), words("deviation"), ""});
    for (const FigureSensitivity& figure : figures) {
        std::vector<std::size_t> order(figure.keys.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
            return figure.keys[a].effect->value > figure.keys[b].effect->value;
        });
        for (const std::size_t k : order) {
            const KeySensitivity& one = figure.keys[k];
            table.row({figure.figure.title.in(words), input.table.keys[k], interval_text(one.effect, words),
                       number(one.effect_scatter, 2), ReportNumbers::unit(figure.figure.unit)});
        }
    }
    return Document().add(table).small(
        words("Mean change: by how much the value changes on average when the key alone moves by half of its "
              "distribution, without sign (mu* of Morris), in brackets the interval of 95 %. A deviation as large as "
              "it: the change depends on where the key is and on the others."));
}

Document sensitivity_table(const StudyInput& input, const std::vector<FigureSensitivity>& figures, bool are_dependent,
                           const Words& words) {
    if (!figures.empty() && figures.front().keys.front().effect) return effects_table(input, figures, words);
    const ReportNumbers number(words);
    Table table({words("value"), words("key"), words("first order"), words("total"), words("rank correlation"), "Q2"});
    for (const FigureSensitivity& figure : figures) {
        const std::string title = figure.figure.title.in(words);
        for (std::size_t k = 0; k < figure.keys.size(); ++k) {
            const KeySensitivity& one = figure.keys[k];
            table.row({title, input.table.keys[k], interval_text(one.first_order, words),
                       interval_text(one.total, words), interval_text(one.rank_correlation, words),
                       std::isnan(figure.q2) ? words("not measurable") : number(figure.q2, 2)});
        }
    }
    return Document().add(table).small(
        are_dependent ? words("Correlated keys: no fraction of the variance is that of one of them.")
                      : words("Fractions of the variance, alone and with others; none where Q2 is less than {1}.",
                              {number(k_least_q2)}));
}

Table failures_list(const StudyResult& result, const Words& words) {
    Table table({words("member"), words("reason")});
    for (const MemberResult& member : result.members)
        if (!member.failure.empty()) table.row({std::to_string(member.member), member.failure});
    return table;
}

/// The map that answers the question of the study first.
std::vector<std::string> maps_in_order(const StudyInput& input, const ResultDirectory& directory) {
    const std::vector<double>& depths = input.base.spec.output.depth_thresholds;
    const std::string of_runs = depths.empty() ? "" : "probability_depth_" + shortest_text(depths.front());
    std::vector<std::string> maps = pictures_in(directory.path("maps"));
    for (const std::string name : {"union_max_depth", RasterName::hazard_degree, of_runs.c_str()}) {
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

void write_study_report(const StudyInput& input, const StudyResult& result,
                        const std::vector<FigureSensitivity>& figures, const StudyFacts& facts,
                        const ResultDirectory& directory) {
    const Words words = words_of(input.base.spec);
    const std::vector<std::string> maps = maps_in_order(input, directory);
    const std::string& folder = directory.folder();
    Document page = study_answer(input, result, facts, words);
    page.add(exposure_answer(facts.exposure, exposure_reached_by(input), words));
    if (!maps.empty()) page.maps({maps.front()}, folder, words);
    // The first page of paper has room for a short table under its picture.
    const bool is_short = input.reading.study.region || result.figures().size() <= k_figures_on_first_page;
    if (is_short) page.add(study_values(input, result, facts, words));
    page.end_answer();
    if (!is_short) page.add(study_values(input, result, facts, words));
    page.add(exposure_section(facts.exposure, words))
        .add(slopes_section(input, result, words))
        .heading("maps", words("Maps"));
    if (maps.size() > 1) page.maps({maps.begin() + 1, maps.end()}, folder, words);
    if (maps.size() == 1) page.paragraph(words("The only map is on the first page."));
    if (maps.empty()) page.paragraph(words("There are no maps."));
    page.part(k_comparison_section, {});
    add_inputs(input, facts, words, page);
    if (!figures.empty())
        page.heading("sensitivity", words("Sensitivity"))
            .add(sensitivity_table(input, figures, result.points.are_dependent, words));
    page.charts(study_charts(), folder, words);
    if (!facts.warnings.empty()) page.warnings(facts.warnings, words);
    if (result.failed() > 0) page.heading("failures", words("Failed members")).add(failures_list(result, words));
    write_page(folder,
               {title_of(input, words),
                words("Computed with {1}, study {2}, {3}",
                      {std::string(k_program) + " " + k_version, fs::path(input.reading.study.file).filename().string(),
                       words.date(facts.date)}),
                words, maps.empty() ? Opening::answer : Opening::answer_with_picture},
               page);
}

}  // namespace frana::app::study
