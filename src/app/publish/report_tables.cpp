// SPDX-License-Identifier: Apache-2.0
#include "app/publish/report_tables.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "app/input/prepare_zones.h"
#include "app/input/used_file.h"
#include "app/pictures/map_layer.h"
#include "app/publish/html_page.h"
#include "app/publish/report_answer.h"
#include "app/store/scene_identity.h"
#include "app/text/number_text.h"
#include "core/text.h"
#include "core/words/words.h"
#include "params/grammar/ini_file.h"
#include "params/grammar/value_text.h"
#include "params/keys/scene_parameters.h"
#include "params/keys/used_keys.h"
#include "params/scene/write_scene.h"
#include "simulation/simulation.h"

namespace frana::app {
namespace {

/// "Float32, m (assumed)", "300 x 270", "polygons: 1"
std::string line_in(std::string line, const Words& words) {
    const std::string assumed = " (assumed)", area = " m2";
    if (line.ends_with(assumed))
        return line_in(line.substr(0, line.size() - assumed.size()), words) + " (" + words("assumed") + ")";
    if (line.ends_with(area)) line.replace(line.size() - area.size(), area.size(), " m²");
    if (const std::size_t by = line.find(" x "); by != std::string::npos) line.replace(by, 3, " × ");
    return NumberPattern(line).in(words);
}

}  // namespace

std::string role_in(const UsedFile& file, const Words& words) {
    const std::size_t colon = file.role.find(": ");  // "Zones: KEY"
    std::string role = colon == std::string::npos
                           ? words(file.role)
                           : words.labelled(words(file.role.substr(0, colon)), file.role.substr(colon + 2));
    if (!file.resampling.empty()) role += " (" + file.resampling + ")";
    return role;
}

std::string content_in(const UsedFile& file, const Words& words) {
    std::stringstream lines(file.content);
    std::string text;
    for (std::string line; std::getline(lines, line);) text += (text.empty() ? "" : "\n") + line_in(line, words);
    return text;
}

std::string operation_in(const UsedFile& file, const Words& words) {
    if (file.crs_label.empty()) return "";
    const std::string operation = transform_text(file.transform);
    if (operation == "none") return "–";
    const double accuracy = file.transform.accuracy_m;
    return operation + "; ± " + (accuracy < 0 ? "?" : words.number(number_text(accuracy, 3))) + " m";
}

namespace {

constexpr std::size_t k_most_rows = 20;  // of hundreds, the files of the result have the rest

/// The separate flows of a result, if it has several.
Document flows_table(const std::vector<Runout>& run_outs, const Words& words) {
    if (run_outs.size() < 2) return {};
    const ReportNumbers number(words);
    Table table({words("Flow"), words("Run-out") + " [m]", words("Drop") + " [m]", words("Angle of reach") + " [°]",
                 words("Area") + " [m²]", words("From"), words("To")});
    const auto place = [](Point p) { return number_text(p.x, 9) + ", " + number_text(p.y, 9); };
    for (std::size_t i = 0; i < std::min(run_outs.size(), k_most_rows); ++i) {
        const Runout& one = run_outs[i];
        table.row({std::to_string(i + 1), number.grouped(one.horizontal_m), number.grouped(one.drop_m),
                   number(one.reach_angle_deg, 3), number.grouped(one.covered_area_m2), place(one.top),
                   place(one.tip)});
    }
    return table;
}

Document gauges_table(const ReportInput& input) {
    const Words& words = input.words;
    const ReportNumbers number(words);
    const std::vector<GaugeAnswer> gauges = gauge_answers(input);
    if (gauges.empty()) return {};
    Table table({words("Gauges"), words("Arrival time") + " [s]", words("Maximum depth") + " [m]", words("its error"),
                 words("Maximum velocity") + " [m/s]", words("its error")});
    for (const GaugeAnswer& one : gauges) {
        const std::string key = "gauge " + one.name + ": ";
        table.row({one.name, one.arrival ? number(*one.arrival, 3) : words("not reached"), number(one.depth, 3),
                   error_text(input.errors, key + "max_depth_m", words), number(one.speed, 3),
                   error_text(input.errors, key + "max_speed_ms", words)});
    }
    return table;
}

Document sections_table(const ReportInput& input) {
    const Words& words = input.words;
    const ReportNumbers number(words);
    const std::vector<CrossSection>& sections = input.prepared.scene.recording.sections;
    if (sections.empty()) return {};
    std::vector<double> discharge(sections.size()), volume(sections.size());
    for (const SectionRow& row : input.result.sections) {
        discharge[row.section] = std::max(discharge[row.section], std::abs(row.discharge));
        volume[row.section] = row.volume;
    }
    Table table({words("Cross-sections"), words("Maximum discharge") + " [m³/s]", words("its error"),
                 words("Volume") + " [m³]", words("its error")});
    for (std::size_t i = 0; i < sections.size(); ++i) {
        const std::string key = "section " + sections[i].name + ": ";
        table.row({sections[i].name, number(discharge[i], 3),
                   error_text(input.errors, key + "max_discharge_m3s", words), number.grouped(volume[i]),
                   error_text(input.errors, key + "volume_m3", words)});
    }
    return table;
}

/// The scene with its files as seen from the result: a report is handed on with the folder, not with the machine.
SceneSpec seen_from_result(const Prepared& p) {
    return p.result_folder.empty() ? p.spec : seen_from(p.spec, p.result_folder);
}

std::string extent_in(const Bounds& box, const Words& words) {
    const auto metres = [&](double value) {
        std::ostringstream text;
        text << std::fixed << std::setprecision(2) << value;
        return words.number(text.str());
    };
    return words("E {1}, N {2}",
                 {metres(box.west) + " – " + metres(box.east), metres(box.south) + " – " + metres(box.north)});
}

}  // namespace

Document high_values_table(const ReportInput& input) {
    const Words& words = input.words;
    const ReportNumbers number(words);
    const auto of_area = [&](double percent) { return words("{1} % of the area", {number(percent)}); };
    Table table({"", words("maximum"), of_area(99.9), of_area(99)});
    const PeakStatistics& high = input.facts.high;
    for (std::size_t i = 0; i < high.size(); ++i) {
        const PeakStatistic& what = k_peak_statistics[i];
        const auto value = [&](double one) { return std::isnan(one) ? "–" : number(one); };
        const std::string direction =
            i == 0 ? std::string(", ") + words(input.result.depth_is_normal ? k_normal : k_vertical) : "";
        table.row({words(what.title) + direction + " [" + what.row().unit + "]",
                   number(std::isnan(high[i].greatest) ? 0 : high[i].greatest), value(high[i].p999),
                   value(high[i].p99)});
    }
    return Document()
        .add(table)
        .add(flows_table(input.facts.statistics.run_outs, words))
        .add(gauges_table(input))
        .add(sections_table(input));
}

Document ground_table(const SummaryFacts& facts, const Words& words) {
    const ReportNumbers number(words);
    Table table({"", words("Lowest") + " [m]", words("Highest") + " [m]", words("Mean slope") + " [°]",
                 words("Steepest slope") + " [°]"});
    const auto row = [&](const std::string& where, const std::optional<GroundStatistics>& ground) {
        if (!ground) return;
        table.row({where, number(ground->lowest, 5), number(ground->highest, 5), number(ground->mean_slope_deg, 3),
                   number(ground->steepest_slope_deg, 3)});
    };
    row(words("Release"), facts.release_ground);
    row(words("Path"), facts.path_ground);
    return table;
}

Document budget_table(const RunResult& r, const Words& words) {
    const ReportNumbers n(words);
    Table table;
    const auto volume = [&](const std::string& name, double value) { table.number(name, n.grouped(value), "m³"); };
    volume(words("Released"), r.volume_entered - r.volume_inflow - r.volume_rained);
    if (r.volume_inflow > 0) volume(words("Inflow"), r.volume_inflow);
    if (r.volume_rained > 0) volume(words("Rain"), r.volume_rained);
    if (r.volume_infiltrated > 0) volume(words("Infiltration"), r.volume_infiltrated);
    if (r.exchanges) {
        volume(words("Eroded from the bed"), r.volume_eroded);
        volume(words("Deposited on the bed"), r.volume_deposited);
    }
    if (r.volume_detrained > 0) volume(words("Of this held by forest"), r.volume_detrained);
    if (const auto& p = r.phases) {
        const auto volumes = [&](const std::string& name, const std::vector<double>& values) {
            std::vector<std::string> texts;
            for (const double value : values) texts.push_back(n.grouped(value));
            table.number(name, joined(texts, "; "), "m³");
        };
        volumes(words("Solids: entered; inside; left"), {p->entered.solids, p->inside.solids, p->left.solids});
        volumes(words("Confined water: entered; released; inside; left"),
                {p->entered.confined, p->released, p->inside.confined, p->left.confined});
        volumes(words("Free water: entered; inside; left"), {p->entered.free, p->inside.free, p->left.free});
        table.number(words("Cohesion left"), n(p->cohesion_left, 3), "");
    }
    volume(words("Inside the domain"), r.volume_final);
    volume(words("Left the domain"), r.volume_left);
    return table.number(words("volume error"), n(100 * relative_volume_error(r), 2), "%");
}

Document numerics_table(const ReportInput& input) {
    const Words& words = input.words;
    const ReportNumbers n(words);
    const RunResult& r = input.result;
    const GridSpec& grid = input.prepared.scene.grid;
    const HardEvents& e = r.hard_events;
    Table table;
    std::vector<std::string> errors;
    const auto event = [&](const char* key, std::int64_t count) {
        if (count > 0) errors.push_back(key + (" " + n.grouped(count)));
    };
    table
        .number(words("cells of {1} m", {n(grid.cell_size)}), n.grouped(grid.columns) + " × " + n.grouped(grid.rows),
                "")
        .number(
            words("Particles: start; end; maximum"),
            n.grouped(r.particles_initial) + "; " + n.grouped(r.particles_final) + "; " + n.grouped(r.particles_peak),
            "")
        .number(words("Time steps"), n.grouped(r.steps), "");
    event("non_finite", e.non_finite);  // as summary.json names them
    event("depth_clamped", e.depth_clamped);
    event("entered_no_data", e.entered_no_data);
    event("impossible_speed", e.impossible_speed);
    event("volume_drift", e.volume_drift);
    return table.number(words("Numerical errors"), errors.empty() ? "0" : joined(errors, "; "), "");
}

Document accuracy_tables(const AccuracyRecord& record, const Words& words) {
    const ReportNumbers n(words);
    Table levels({words("Cell size") + " [m]", words("Particles"), words("Time steps"), words("Time") + " [s]",
                  words("Problem")});
    for (const AccuracyLevel& level : record.levels) {
        levels.row({n(level.cell_size), level.particles > 0 ? n.grouped(level.particles) : words("finite volumes"),
                    n.grouped(level.steps), n(level.wall_seconds, 3), level.problem});
    }
    Table values({words("Value"), "", words("Estimated error"), words("Trend"), words("Allowed error")});
    for (const ValueEstimate& e : value_estimates(record)) {
        const std::string unit = " " + unit_sign(e.value.unit);
        values.row({e.value.title.in(words), n.rounded(e.value.value) + unit,
                    !std::isfinite(e.error)
                        ? words("not converging")
                        : n.rounded(e.error, 2) + unit + (e.value.value != 0 ? " (" + n(e.percent(), 2) + " %)" : ""),
                    words(describe(e.convergence.trend)), n.rounded(e.allowed, 2) + unit});
    }
    return Document()
        .paragraph(accuracy_verdict(record).in(words) + ".")
        .add(values)
        .subheading(words("Levels computed"))
        .add(levels);
}

Document release_table(const RunResult& result, const Words& words) {
    const ReportNumbers n(words);
    Table table({"", words("Name"), words("Start") + " [s]", words("Area") + " [m²]", words("Volume") + " [m³]"});
    for (std::size_t i = 0; i < result.released.size(); ++i) {
        const ReleasedArea& area = result.released[i];
        table.row({std::to_string(i + 1), area.name.empty() ? "–" : area.name, n(area.start), n.grouped(area.area),
                   n.grouped(area.volume)});
    }
    return table;
}

Document friction_table(const FrictionByPlace& friction, const std::vector<FrictionArea>& areas, const Words& words) {
    const ReportNumbers n(words);
    const FrictionChoice& choice = friction.choice();
    const FrictionTable& source = choice.table;
    Table table({words("Terrain"), words("Elevation"), "μ", "ξ [m/s²]", words("Area") + " [m²]"});
    std::vector<std::string> crossed;
    for (std::size_t band = 1; band <= source.altitudes.size(); ++band) {
        const auto is_at = [&](std::size_t of) {
            return std::any_of(areas.begin(), areas.end(), [&](const FrictionArea& area) { return area.band == of; });
        };
        if (is_at(band - 1) && is_at(band)) crossed.push_back(n.grouped(source.altitudes[band - 1]));
    }
    for (const FrictionArea& area : areas) {
        const FrictionPair pair = choice.at(area.kind, area.band, area.forest);
        table.row({words(source.terrain[area.kind].name) + (area.forest ? ", " + words("Forest") : ""),
                   class_text(source.altitudes, area.band, "m").in(words),
                   n(pair.coefficient, 3),
                   n.rounded(pair.turbulence, 4),
                   {n.grouped(area.area_m2), "n"}});
    }
    Document told;
    told.paragraph(friction_text(choice).in(words));
    if (choice.friction_factor != 1 || choice.turbulence_factor != 1)
        told.paragraph("μ × " + n(choice.friction_factor, 3) + ", ξ × " + n(choice.turbulence_factor, 3));
    if (!areas.empty()) told.add(table);
    if (source.terrain.size() > 1)
        told.small(words("Interpolated over {1} m in mu.tif and xi.tif.", {n(friction.spacing(), 4)}));
    if (!crossed.empty()) told.small(words("μ and ξ step at elevations of {1} m.", {joined(crossed, ", ")}));
    if (!source.note.empty()) told.small(source.note);
    return told;
}

Document hazard_table(const SceneSpec& spec, const std::vector<HazardArea>& areas, const Words& words) {
    const ReportNumbers n(words);
    const std::optional<HazardScheme> scheme = hazard_scheme_of(spec);
    Table table({words("Class"), "", words("Thresholds"), words("Area") + " [m²]",
                 with_unit(words("Area of all generalised zones"), "m²")});
    for (const HazardArea& area : areas) {
        Cell kind = area.kind.name == area.kind.thresholds ? "" : words(area.kind.name);
        kind.swatch = hex(area.kind.colour);
        table.row({std::to_string(area.kind.value),
                   kind,
                   class_label(area.kind.thresholds, words),
                   {n.grouped(area.area_m2), "n"},
                   {std::isnan(area.zones_m2) ? "" : n.grouped(area.zones_m2), "n"}});
    }
    Document told;
    told.paragraph(words("Scheme") + ".", words(scheme->called) + "; " + words(scheme->source))
        .paragraph(scheme->has_zones() ? words("Zones of one scenario, not a hazard zone plan")
                                       : words("Intensity of one scenario, without its frequency"))
        .add(table);
    for (const std::string& label : scheme->minimum_labels()) told.small(class_label(label, words));
    return told;
}

Document inputs_table(const Prepared& p, const Words& words) {
    const ReportNumbers n(words);
    Table table(
        {words("Inputs"), words("File"), words("Content"), words("CRS"), words("Operation to the working CRS")});
    for (const UsedFile& file : p.files) {
        table.row({role_in(file, words),
                   p.result_folder.empty() ? file.path : relative_path(file.path, p.result_folder),
                   content_in(file, words), words(file.crs_label), operation_in(file, words)});
    }
    return Document()
        .paragraph(words("Working CRS: {1}; extent {2}; cells without elevation: {3}, filled: {4}",
                         {p.ground.crs_label, extent_in(p.scene.grid.bounds(), words), n.grouped(p.ground.nodata_cells),
                          n.grouped(p.ground.filled_cells)}))
        .add(table);
}

Document parameters_table(const Prepared& p, bool only_used, const Words& words) {
    Table table({words("Key"), words("Value"), words("Origin"), words("Meaning")}, "keys");
    const SceneSpec shown = seen_from_result(p);
    for (const Parameter& parameter : scene_parameters()) {
        const std::string name = parameter.name();
        const auto chosen = p.resolved.find(name);
        if (only_used && !is_used(p.spec, parameter, chosen != p.resolved.end())) continue;
        std::string value = parameter.write(shown).value_or("");
        if (value.empty()) value = "–";
        if (chosen != p.resolved.end() && chosen->second != value)
            value += " → " + (name == "terrain.bounds" ? extent_in(p.scene.grid.bounds(), words) : chosen->second);
        table.row(
            {name, with_unit(value, parameter.unit), origin_text(p.spec, name, words), meaning_in(parameter, words)},
            p.spec.origin_of(name) == Origin::default_value ? "" : "given");
    }
    return table;
}

}  // namespace frana::app
