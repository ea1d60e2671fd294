// SPDX-License-Identifier: Apache-2.0
#include "app/study/plan/study_input.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <utility>

#include "analysis/hazard.h"
#include "app/input/doubt_ground.h"
#include "app/input/layer_values.h"
#include "app/publish/publish_hazard.h"
#include "app/store/scene_identity.h"
#include "app/study/plan/read_study.h"
#include "app/study/plan/sampling.h"
#include "core/text.h"
#include "params/grammar/value_text.h"
#include "params/keys/scene_parameters.h"

namespace frana::app::study {
namespace {

std::optional<std::string> text_in(const Feature& feature, const std::string& column) {
    if (const auto text = feature.texts.find(column); text != feature.texts.end()) {
        const std::string value = trimmed(text->second);
        if (value.empty()) return std::nullopt;
        return value;
    }
    if (const auto number = feature.numbers.find(column); number != feature.numbers.end())
        return shortest_text(number->second);
    return std::nullopt;
}

/// A column that no polygon has is mistyped.
void require_columns(const RegionSpec& region, const gis::PolygonLayer& layer, const std::string& label,
                     Problems& problems) {
    std::set<std::string> known;
    for (const Feature& feature : layer.features) {
        for (const auto& [name, value] : feature.numbers) known.insert(name);
        for (const auto& [name, value] : feature.texts) known.insert(name);
    }
    const std::vector<std::string> names(known.begin(), known.end());
    const auto require = [&](const std::string& key, const std::string& column) {
        if (known.count(column) > 0) return;
        const std::string nearest = nearest_name(column, names);
        problems.add({"is no column in which a polygon of the release perimeter has a value", Place(label, key), column,
                      "",
                      !nearest.empty() ? "Did you mean " + nearest + "?"
                      : names.empty()  ? "The layer has no attributes"
                                       : "Its columns are " + joined(names, ", ")});
    };
    for (const auto& [key, column] :
         {std::pair{"region.name", region.name}, std::pair{"region.group", region.group},
          std::pair{"region.scenario", region.scenario}, std::pair{"region.return-period", region.return_period}})
        if (column) require(key, *column);
    for (const RegionSpec::Column& one : region.columns) require("columns." + one.key, one.column);
    for (const RegionSpec::Event& event : region.events)
        for (const RegionSpec::Column& one : event.columns)
            require("scenario " + event.name + "." + one.key, one.column);
}

/// How often a slope fails, by its columns or as all do. @param problem of a value in them
FrequencySpec frequency_of(const StudySpec& study, const Feature& feature, std::string& problem) {
    StudySpec own = study;
    for (const RegionSpec::Column& one : study.region->columns) {
        if (!is_of_frequency(one.key)) continue;
        const std::string text = text_in(feature, one.column).value_or("");
        const auto refusal = find_parameter(study_keys(StudyKind::region), one.key)->read(own, text);
        if (text.empty())
            problem = "column " + one.column + " for " + one.key + " has no value";
        else if (refusal)
            problem = "column " + one.column + " for " + one.key + ": " + text + " " + refusal->what +
                      (refusal->remedy.empty() ? "" : ". " + refusal->remedy);
    }
    if (const auto contradiction = vary_volumes(own)) problem = describe(*contradiction);
    return own.frequency;
}

/// @param event null: the columns of the region say which it is
Slope slope_of(const StudySpec& study, const Feature& feature, const RegionSpec::Event* event) {
    const RegionSpec& region = *study.region;
    Slope slope;
    slope.frequency = frequency_of(study, feature, slope.problem);
    const auto word = [&](const std::optional<std::string>& column) {
        return column ? text_in(feature, *column).value_or("") : "";
    };
    slope.name = word(region.name);
    slope.group = word(region.group);
    if (event != nullptr) {
        slope.scenario = event->name;
        slope.return_period = event->return_period;
        return slope;
    }
    slope.scenario = word(region.scenario);
    if (region.scenario && slope.scenario.empty()) slope.problem = "column " + *region.scenario + " has no value";
    if (!region.return_period) return slope;
    const std::string years = word(region.return_period);
    slope.return_period = number_from_text(years);
    if (years.empty())
        slope.problem = "column " + *region.return_period + " has no value";
    else if (!slope.return_period || !(*slope.return_period > 0))
        slope.problem = "column " + *region.return_period + " has no return period: " + years;
    return slope;
}

void require_one_period(const std::vector<Slope>& slopes, const std::string& label, Problems& problems) {
    std::map<std::string, std::set<double>> periods;
    for (const Slope& slope : slopes)
        if (slope.return_period && !slope.scenario.empty()) periods[slope.scenario].insert(*slope.return_period);
    for (const auto& [scenario, all] : periods) {
        if (all.size() < 2) continue;
        problems.add({"gives scenario " + scenario + " several return periods", Place(label, "region.return-period"),
                      shortest_text(*all.begin()) + " and " + shortest_text(*all.rbegin()) + " years",
                      "one for each scenario", "Correct the column, or give the events different scenarios"});
    }
}

constexpr const char* k_friction_period = "material.return-period";

/// The return period of an event is also that of its friction: without one of its own a friction table takes it.
void take_friction_period(RegionSpec& region, const FrictionTableSpec& table) {
    const bool has_own =
        table.return_period || std::any_of(region.columns.begin(), region.columns.end(),
                                           [](const RegionSpec::Column& one) { return one.key == k_friction_period; });
    if (region.return_period && table.name && !has_own)
        region.columns.push_back({k_friction_period, *region.return_period});
}

/// Whether the events of a region say by which return period its friction table is read.
bool gives_friction_period(const RegionSpec& region, const FrictionTableSpec& table) {
    return !region.events.empty() && table.name && !table.return_period;
}

/// Refuses releases of one return period on the friction of another.
void require_friction_period(const FrictionTableSpec& table, StudyInput& members) {
    const auto& keys = members.table.keys;
    const auto place = std::find(keys.begin(), keys.end(), k_friction_period) - keys.begin();
    for (std::size_t i = 0; i < members.slopes.size(); ++i) {
        const auto& values = members.table.values[i];
        const bool is_column = place < static_cast<std::ptrdiff_t>(values.size());
        const auto friction =
            is_column ? number_from_text(values[static_cast<std::size_t>(place)]) : table.return_period;
        const auto& event = members.slopes[i].return_period;
        if (!event || !friction || *event == *friction) continue;
        members.reading.problems.add(
            {"differs from " + std::string(k_friction_period) + ", of member " + std::to_string(i) + " first",
             members.reading.where(members.reading.study.region->events.empty()
                                       ? "region.return-period"
                                       : "scenario " + members.slopes[i].scenario + ".return-period"),
             shortest_text(*event) + " years", shortest_text(*friction) + " years",
             "Leave out " + std::string(k_friction_period) + ": the event's own is taken"});
        return;
    }
}

/// A slope before its columns are read.
struct SlopePlace {
    std::size_t polygon = 0;
    const RegionSpec::Event* event = nullptr;  ///< null: the region names none
};

/// The slopes of a layer: its polygons, each in all events of which it has a value, or in the first one that it lacks.
std::vector<SlopePlace> slopes_in(const gis::PolygonLayer& layer, const RegionSpec& region) {
    std::vector<SlopePlace> all;
    for (std::size_t i = 0; i < layer.features.size(); ++i) {
        const std::size_t before = all.size();
        for (const RegionSpec::Event& event : region.events)
            if (std::any_of(event.columns.begin(), event.columns.end(), [&](const RegionSpec::Column& one) {
                    return text_in(layer.features[i], one.column).has_value();
                }))
                all.push_back({i, &event});
        if (all.size() == before) all.push_back({i, region.events.empty() ? nullptr : &region.events.front()});
    }
    return all;
}

/// Adds the columns of a region to the values of its members.
void add_columns(const gis::PolygonLayer& layer, const std::vector<SlopePlace>& places, bool with_friction_period,
                 StudyInput& members) {
    const StudySpec& study = members.reading.study;
    const RegionSpec& region = *study.region;
    const std::vector<Parameter>& parameters = scene_parameters();
    const std::string folder = std::filesystem::path(study.file).parent_path().string();
    const auto columns_at = [&](const RegionSpec::Event* event) {
        std::vector<RegionSpec::Column> columns = region.columns;
        std::erase_if(columns, [](const RegionSpec::Column& one) { return is_of_frequency(one.key); });
        if (event == nullptr) return columns;
        std::vector<RegionSpec::Column> own = event->columns;  // the same keys in each event
        std::sort(own.begin(), own.end(), [](const auto& a, const auto& b) { return a.key < b.key; });
        columns.insert(columns.end(), own.begin(), own.end());
        return columns;
    };
    const auto add_key = [&](const std::string& key) {
        members.table.keys.push_back(key);
        members.table.nominal.push_back(true);
    };
    for (const RegionSpec::Column& one : columns_at(region.events.empty() ? nullptr : &region.events.front()))
        add_key(one.key);
    if (with_friction_period) add_key(k_friction_period);
    for (std::size_t i = 0; i < places.size(); ++i) {
        const Feature& feature = layer.features[places[i].polygon];
        Slope slope = slope_of(study, feature, places[i].event);
        slope.polygon = places[i].polygon;
        slope.area = area(feature.shape.areas);
        if (!layer.unusable[slope.polygon].empty()) slope.problem = layer.unusable[slope.polygon];
        const auto add = [&](const std::string& value, double number) {
            members.table.values[i].push_back(value);
            members.table.numbers[i].push_back(number);
        };
        for (const RegionSpec::Column& one : columns_at(places[i].event)) {
            const auto text = text_in(feature, one.column);
            if (!text) slope.problem = "column " + one.column + " for " + one.key + " has no value";
            const Parameter& key = *find_parameter(parameters, one.key);
            add(text ? with_absolute_paths(key, *text, folder) : "", text ? number_from_text(*text).value_or(0) : 0);
        }
        if (with_friction_period) add(shortest_text(*slope.return_period), *slope.return_period);
        members.slopes.push_back(std::move(slope));
    }
}

/// Gives each slope its draws in place of one member, from a seed of its own; the first has that of the region.
void draw_members(StudyInput& region) {
    const StudySpec& study = region.spec();
    const SampleTable slopes = std::exchange(region.table, {});
    SampleTable& table = region.table;
    table.keys = slopes.keys;
    table.nominal = slopes.nominal;
    table.draws = static_cast<std::size_t>(study.samples);
    table.is_replicated = true;
    constexpr std::int64_t k_seed_step = 1'000'003;
    const auto draw = [&](std::size_t slope, Problems& problems) {
        StudySpec own = study;
        own.frequency = region.slopes[slope].frequency;
        own.seed = (study.seed + static_cast<std::int64_t>(slope) * k_seed_step) % k_last_seed;
        vary_volumes(own);
        return samples_at(own, draw_places(own, true), region.reading.label, problems);
    };
    const auto is_sound = [&](const Slope& slope) { return slope.problem.empty(); };
    const auto sound = std::find_if(region.slopes.begin(), region.slopes.end(), is_sound);
    if (sound == region.slopes.end()) {
        if (slopes.size() > 0)
            region.reading.problems.add({"no slope has what a frequency needs: " + region.slopes.front().problem,
                                         region.reading.where("frequency"), "", "", "Correct the columns"});
        return;
    }
    // What is wrong with the draws of the first is everybody's; a slope that fails has as many members, without values.
    const SampleTable first = draw(static_cast<std::size_t>(sound - region.slopes.begin()), region.reading.problems);
    if (first.size() == 0) return;
    table.keys.insert(table.keys.end(), first.keys.begin(), first.keys.end());
    table.nominal.insert(table.nominal.end(), first.nominal.begin(), first.nominal.end());
    SampleTable none = first;
    for (auto& row : none.values) row.assign(row.size(), "");
    for (std::size_t i = 0; i < slopes.size(); ++i) {
        Problems of_later;
        const SampleTable drawn = is_sound(region.slopes[i]) ? draw(i, of_later) : none;
        const auto joined_rows = [](auto row, const auto& more) {
            row.insert(row.end(), more.begin(), more.end());
            return row;
        };
        for (std::size_t j = 0; j < drawn.size(); ++j) {
            table.values.push_back(joined_rows(slopes.values[i], drawn.values[j]));
            table.numbers.push_back(joined_rows(slopes.numbers[i], drawn.numbers[j]));
            table.weights.push_back(drawn.weights[j]);
        }
    }
}

/// Adds a member for each polygon of a scene's release perimeter, in the order of the file: release.perimeter-filter
/// selects it. Adds a problem if the scene names none, or it cannot be read, or no polygon has a column that the region
/// names, or one scenario has several return periods. What is wrong with a single slope is only kept with it.
void add_polygons(const SceneReading& scene, StudyInput& members) {
    Problems& problems = members.reading.problems;
    const std::string& label = members.reading.label;
    const ReleaseSpec& release = scene.scene.release;
    const Place where = scene.where("release.perimeter");
    if (!release.perimeter)
        return problems.add({"is missing, and a region takes its polygons", where, "", "a vector file",
                             "Name the file of the release perimeters"});
    const std::string own = release.perimeter_layer.filter.value_or("");
    attempt(problems, [&] {
        gis::LayerChoice choice = layer_choice(scene, release.perimeter_layer, "release.perimeter");
        choice.keep_unusable = true;
        const gis::PolygonLayer layer = gis::read_polygons(*release.perimeter, "", where, choice);
        members.table.keys = {"release.perimeter-filter"};
        members.table.nominal = {true};
        const RegionSpec& region = *members.reading.study.region;
        const std::vector<SlopePlace> places = slopes_in(layer, region);
        for (const SlopePlace& place : places) {
            const std::string& condition = layer.conditions[place.polygon];
            members.table.values.push_back({own.empty() ? condition : "(" + own + ") AND " + condition});
            members.table.numbers.push_back({static_cast<double>(place.polygon)});
            members.table.weights.push_back(1);
        }
        require_columns(region, layer, label, problems);
        add_columns(layer, places, gives_friction_period(region, scene.scene.friction_table), members);
        require_one_period(members.slopes, label, problems);
        require_friction_period(scene.scene.friction_table, members);
    });
}

/// Reads the scene of each slope. What is wrong with some of them is kept with these; what is wrong with all is added
/// to the region's problems once.
void find_problems(StudyInput& region) {
    std::vector<Slope>& slopes = region.slopes;
    std::map<std::string, std::pair<Problem, std::size_t>> counts;  // by words
    std::vector<std::vector<std::string>> of_slope(slopes.size());
    for (std::size_t i = 0; i < slopes.size(); ++i) {
        const SceneReading scene = region.member(region.first_member(i));
        for (const Problem& problem : scene.problems.list()) {
            const std::string words = problem.where + problem.what;
            ++counts.try_emplace(words, problem, 0).first->second.second;
            of_slope[i].push_back(words);
        }
    }
    for (const auto& [words, found] : counts)
        if (found.second == slopes.size()) region.reading.problems.add(found.first);
    for (std::size_t i = 0; i < slopes.size(); ++i)
        for (const std::string& words : of_slope[i]) {
            const auto& [problem, count] = counts.at(words);
            if (count < slopes.size() && slopes[i].problem.empty()) slopes[i].problem = describe(problem);
        }
}

/// Refuses a scheme without intensities, or with several matrices of which hazard.process names none.
void settle_degree(StudyInput& input) {
    RegionSpec& region = *input.reading.study.region;
    const auto scheme = hazard_scheme_of(input.base.spec);
    const bool has_degrees = scheme && has_intensities(*scheme);
    if (!region.return_period && (region.events.empty() || !has_degrees)) return;
    if (has_degrees) {
        if (const ProcessMatrix* const matrix = scheme->matrix_of(input.base.spec.hazard.process)) {
            region.degrees = matrix->degrees;
            return;
        }
        std::vector<std::string> known;
        for (const ProcessMatrix& one : scheme->matrices) known.push_back(one.process);
        throw Error(ErrorKind::input,
                    Problem{"is not given, and " + scheme->name + " has a matrix for each process",
                            input.central.where("hazard.process"), "", joined(known, ", "), "Name one"});
    }
    throw Error(ErrorKind::input,
                Problem{scheme ? "does not tell weak, medium and strong intensity, which the degree of hazard needs"
                               : "is missing, and the degree of hazard needs intensities",
                        input.central.where("hazard.scheme"), scheme ? scheme->name : "",
                        "a scheme with a matrix (`frana schemes` names it)",
                        "Choose one of these, or remove region.return-period"});
}

/// Makes a slope the central one.
void prepare_slope(SceneReading slope, const std::optional<Problem>& place, RunLog& log, StudyInput& input) {
    slope.scene.observed = {};
    slope.scene.output.profiles.reset();
    input.base = prepare(slope, place, {log, input.warnings});
    input.central = std::move(slope);
}

void doubt_central(StudyInput& input, RunLog& log) {
    input.base.scene.warnings += log.tell(doubt_ground(input.central, input.base));
}

/// Prepares the largest slope that can be; one that cannot, off the DTM for example, fails alone when it runs. Throws
/// what is wrong with the largest if none can be.
void prepare_central(StudyInput& input, const std::optional<Problem>& place, RunLog& log) {
    try {
        prepare_slope(input.central, place, log, input);
        doubt_central(input, log);
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::input || place || !input.central.problems.empty()) throw;
        for (const std::size_t member : by_size(input.slopes)) {
            if (!input.slopes[member].problem.empty()) continue;
            const auto take = [&] {
                prepare_slope(input.member(input.first_member(member)), std::nullopt, log, input);
            };
            if (attempt(take)) return doubt_central(input, log);
        }
        throw;
    }
}

}  // namespace

void add_slopes(StudyInput& region) {
    const SceneReading scene = region.scene_with({});
    take_friction_period(*region.reading.study.region, scene.scene.friction_table);
    add_polygons(scene, region);
    if (region.spec().frequency.is_given() && region.reading.problems.empty()) draw_members(region);
    if (region.table.size() > 0) find_problems(region);
}

std::vector<std::size_t> by_size(const std::vector<Slope>& slopes) {
    std::vector<std::size_t> sound;
    for (std::size_t i = 0; i < slopes.size(); ++i)
        if (slopes[i].problem.empty()) sound.push_back(i);
    if (sound.empty())
        for (std::size_t i = 0; i < slopes.size(); ++i) sound.push_back(i);
    // Of the events of one outline the rarest, which releases most.
    const auto size = [&](std::size_t i) { return std::pair(slopes[i].area, slopes[i].return_period.value_or(0)); };
    std::stable_sort(sound.begin(), sound.end(), [&](std::size_t a, std::size_t b) { return size(a) > size(b); });
    return sound;
}

void prepare_region(StudyInput& input, const std::optional<Problem>& place, RunLog& log) {
    const SceneReading of_all = input.scene_with({});
    prepare_central(input, place, log);
    input.base.spec.release.perimeter_layer = of_all.scene.release.perimeter_layer;
    input.base.scene.time.frame_interval = 0;
    settle_degree(input);
    const GridSpec& grid = input.base.scene.grid;
    const std::string key = "release.perimeter";
    gis::LayerChoice all = layer_choice(of_all, of_all.scene.release.perimeter_layer, key);
    all.keep_unusable = true;  // those without an area fail alone
    const gis::PolygonLayer layer =
        of_all.session.read(gis::read_polygons, *of_all.scene.release.perimeter, grid.crs_wkt, of_all.where(key), all);
    for (Slope& slope : input.slopes) {
        if (slope.polygon >= layer.features.size()) continue;
        slope.outline = layer.features[slope.polygon].shape.areas;
        const auto thin = thin_volumes(slope.frequency, area(slope.outline), input.reading.where("frequency.volumes"));
        if (thin && slope.problem.empty()) slope.problem = describe(*thin);
    }
    input.identity = "study = region\n" + values_text(input.table) + scene_identity(input.base);
    StudySpec own = input.spec();
    for (const Slope& slope : input.slopes) {
        own.frequency = slope.frequency;
        input.identity += frequency_text(own);
    }
    const UsedFile polygons = used_polygons("release perimeter of all", *of_all.scene.release.perimeter, layer);
    input.identity += "checksum of the " + polygons.role + " = " + std::to_string(polygons.checksum.value()) + "\n";
}

}  // namespace frana::app::study
