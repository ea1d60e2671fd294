// SPDX-License-Identifier: Apache-2.0
#include "params/keys/result_rasters.h"

#include <algorithm>
#include <limits>

#include "params/keys/scene_spec.h"

namespace frana {

const std::vector<QuantityClasses>& quantity_classes() {
    static const std::vector<QuantityClasses> k_table{
        {"max-depth", "m", {0.2, 0.5, 1, 2, 5, 10, 20, 50}},
        {"max-velocity", "m/s", {1, 2, 5, 10, 20, 30, 50}},
        {"max-pressure", "kPa", {1, 3, 10, 30, 100, 300, 1000}},
        {"arrival-time", "s", {10, 30, 60, 120, 300, 600, 1800}},
        {"max-flux", "m2/s", {0.5, 1, 2, 5, 10, 20, 50}},
        {"max-head", "m", {0.5, 1, 1.5, 2, 5, 10, 20}},
        {RasterName::strain, "", {0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1}},
        {"error", "m", {0.02, 0.05, 0.1, 0.2, 0.5, 1, 2}},
    };
    return k_table;
}

std::vector<double> fixed_classes(const std::string& quantity) {
    std::vector<double> bounds;
    for (const QuantityClasses& row : quantity_classes())
        if (row.name == quantity) bounds = row.bounds;
    if (bounds.empty()) return bounds;
    bounds.insert(bounds.begin(), 0);
    bounds.push_back(std::numeric_limits<double>::infinity());
    return bounds;
}

namespace {

using RasterKind = ResultRaster::Kind;

constexpr bool k_progressive = true, k_even = false;
constexpr double k_infinity = std::numeric_limits<double>::infinity();

class Table {
  public:
    /// Sets the condition of the rasters that follow.
    void when(const std::string& sentence, bool (*is_produced_by)(const SceneSpec&)) {
        when_ = sentence;
        is_produced_by_ = is_produced_by;
    }
    void by(const std::string& command, const std::string& sentence) {
        command_ = command;
        when(sentence, nullptr);
    }
    ResultRaster& add(const char* name, RasterKind kind, const char* title, const char* description, const char* unit,
                      const char* palette, bool progressive) {
        return rows.emplace_back(
            ResultRaster{name, kind, title, description, unit, palette, progressive, command_, when_, is_produced_by_});
    }
    ResultRaster& flow(const char* name, const char* title, const char* description, const char* unit,
                       const char* palette, bool progressive) {
        return add(name, RasterKind::flow, title, description, unit, palette, progressive);
    }

    std::vector<ResultRaster> rows;

  private:
    std::string command_ = "run", when_;
    bool (*is_produced_by_)(const SceneSpec&) = nullptr;
};

/// What a study with [frequency] writes.
void add_frequency(Table& table) {
    table.by("ensemble", "with `[frequency]`");
    const auto by_value = [&](const char* name, const char* title, const char* description, const char* unit,
                              const char* palette, bool progressive) -> ResultRaster& {
        ResultRaster& row = table.flow(name, title, description, unit, palette, progressive);
        row.by_value = row.zero_is_blank = row.with_study = true;
        return row;
    };
    const auto rate = [&](const char* name, const char* title, const char* description) {
        by_value(name, title, description, "1/a", "depth", k_even).bounds = {0,    0.001, 0.003, 0.01,
                                                                             0.03, 0.1,   0.3,   k_infinity};
    };
    rate("annual_rate_depth", "Annual rate, depth > {} m",
         "Events a year in which the maximum depth, vertical, exceeds {} m");
    rate("annual_rate_velocity", "Annual rate, speed > {} m/s",
         "Events a year in which the maximum speed exceeds {} m/s");
    rate("annual_rate_pressure", "Annual rate, pressure > {} kPa",
         "Events a year in which the maximum dynamic pressure exceeds {} kPa");
    rate("annual_rate_momentum_flux", "Annual rate, momentum flux > {} m3/s2",
         "Events a year in which the maximum of depth times speed squared exceeds {} m3/s2");
    rate("annual_rate_intensity", "Annual rate, intensity class ≥ {}",
         "Events a year in which the class of `hazard.scheme` is {} or higher");
    const auto period = [&](const char* name, const char* title, const char* description) {
        ResultRaster& row = by_value(name, title, description, "a", "time", k_even);
        row.bounds = {0, 10, 30, 100, 300, 1000, 3000, k_infinity};
        row.with_study = row.zero_is_blank = false;
    };
    period("return_period_depth", "Return period, depth > {} m",
           "Years between events in which the maximum depth, vertical, exceeds {} m");
    period("return_period_velocity", "Return period, speed > {} m/s",
           "Years between events in which the maximum speed exceeds {} m/s");
    period("return_period_pressure", "Return period, pressure > {} kPa",
           "Years between events in which the maximum dynamic pressure exceeds {} kPa");
    period("return_period_momentum_flux", "Return period, momentum flux > {} m3/s2",
           "Years between events in which the maximum of depth times speed squared exceeds {} m3/s2");
    period("return_period_intensity", "Return period, intensity class ≥ {}",
           "Years between events in which the class of `hazard.scheme` is {} or higher");
    by_value("max_depth_T", "Maximum depth, once in {} years",
             "Maximum depth, vertical, that is exceeded once in {} years", "m", "depth", k_progressive)
        .joint = "";
    by_value("max_velocity_T", "Maximum velocity, once in {} years", "Maximum speed that is exceeded once in {} years",
             "m/s", "velocity", k_even)
        .joint = "";
}

/// What studies of many runs write.
void add_study(Table& table) {
    const auto for_values = [&](const char* name, const char* title, const char* description, const char* unit,
                                const char* palette, bool progressive) -> ResultRaster& {
        ResultRaster& row = table.flow(name, title, description, unit, palette, progressive);
        row.by_value = true;
        return row;
    };
    const auto probability = [&](const char* name, const char* title, const char* description) {
        ResultRaster& row = for_values(name, title, description, "-", "depth", k_even);
        row.zero_is_blank = row.with_study = row.is_probability = true;
        row.bounds = {0, 0.01, 0.05, 0.25, 0.5, 0.75, 0.95, 1};
    };
    table.by("calibrate", "by `frana calibrate`, for each event");
    probability("posterior", "Posterior probability, {}",
                "Probability under the posterior that the maximum depth, vertical, exceeds the survey's threshold, "
                "event {}");
    table.by("ensemble", "by `frana ensemble`");
    probability("probability_depth", "Probability, depth > {} m",
                "Probability that the maximum depth, vertical, exceeds {} m");
    probability("probability_velocity", "Probability, speed > {} m/s",
                "Probability that the maximum speed exceeds {} m/s");
    probability("probability_pressure", "Probability, pressure > {} kPa",
                "Probability that the maximum dynamic pressure exceeds {} kPa");
    probability("probability_momentum_flux", "Probability, momentum flux > {} m3/s2",
                "Probability that the maximum of depth times speed squared exceeds {} m3/s2");
    probability("probability_intensity", "Probability, intensity class ≥ {}",
                "Probability that the class of `hazard.scheme` is {} or higher");
    ResultRaster& depth = for_values("quantile_max_depth", "Maximum depth, {} % quantile",
                                     "Quantile {} % of the maximum depth, vertical", "m", "depth", k_progressive);
    depth.zero_is_blank = depth.with_study = true;
    for_values("quantile_max_velocity", "Maximum velocity, {} % quantile", "Quantile {} % of the maximum speed", "m/s",
               "velocity", k_even)
        .zero_is_blank = true;
    for_values("quantile_arrival_time", "Arrival time, {} % quantile",
               "Quantile {} % of the arrival time among the runs that arrived", "s", "time", k_even);
    const auto of_all = [&](const char* name, const char* title, const char* description, const char* unit,
                            const char* palette, bool progressive, bool with_study = false) {
        ResultRaster& row = table.flow(name, title, description, unit, palette, progressive);
        row.zero_is_blank = true;
        row.with_study = with_study;
    };
    of_all(RasterName::hit_count, "Runs that arrived", "Number of runs that reached the cell", "-", "depth", k_even,
           true);
    ResultRaster& sensitivity = for_values(RasterName::sensitivity, "Sensitivity to {}",
                                           "Fraction of the variance of the distance from the outline that {} explains",
                                           "-", "velocity", k_even);
    sensitivity.with_study = true;
    sensitivity.bounds = {0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.8, 1};
    table.by("batch", "by `frana batch`");
    of_all("union_max_depth", "Maximum depth, all sources", "Greatest depth that any source causes, vertical", "m",
           "depth", k_progressive, true);
    of_all("union_max_velocity", "Maximum velocity, all sources", "Greatest speed that any source causes", "m/s",
           "velocity", k_even, true);
    of_all("union_max_pressure", "Maximum dynamic pressure, all sources",
           "Greatest dynamic pressure that any source causes", "kPa", "velocity", k_progressive, true);
    of_all("union_arrival_time", "Arrival time, all sources", "Earliest arrival from any source", "s", "time", k_even);
    of_all(RasterName::worst_source, "Number of the worst source",
           "Number of the source that causes the greatest depth", "-", "", k_even);
}

/// What a region of many slopes writes besides.
void add_region(Table& table) {
    table.by("batch", "by `frana batch` with `region.scenario`");
    const auto of_scenario = [&](const char* name, const char* title, const char* description, const char* unit,
                                 const char* palette, bool progressive) -> ResultRaster& {
        ResultRaster& row = table.flow(name, title, description, unit, palette, progressive);
        row.by_value = row.zero_is_blank = row.of_scenario = true;
        return row;
    };
    of_scenario("scenario_max_depth", "Maximum depth, scenario {}",
                "Greatest depth that any source of scenario {} causes, vertical", "m", "depth", k_progressive)
        .with_study = true;
    of_scenario("scenario_max_velocity", "Maximum velocity, scenario {}",
                "Greatest speed that any source of scenario {} causes", "m/s", "velocity", k_even);
    of_scenario("scenario_max_pressure", "Maximum dynamic pressure, scenario {}",
                "Greatest dynamic pressure that any source of scenario {} causes", "kPa", "velocity", k_progressive);
    of_scenario("scenario_arrival_time", "Arrival time, scenario {}", "Earliest arrival from any source of scenario {}",
                "s", "time", k_even);
    of_scenario("scenario_hit_count", "Sources that arrive, scenario {}",
                "Number of sources of scenario {} that reach the cell", "-", "depth", k_even);
    of_scenario("scenario_worst_source", "Number of the worst source, scenario {}",
                "Number of the source of scenario {} that causes the greatest depth", "-", "", k_even);
    ResultRaster& intensity = of_scenario("scenario_intensity", "Intensity, scenario {}",
                                          "Greatest class of intensity in scenario {}", "", "depth", k_even);
    intensity.kind = RasterKind::classes;
    intensity.with_study = intensity.of_scheme = true;
    table.by("batch", "by `frana batch` with `region.return-period`");
    ResultRaster& degree = table.add(RasterName::hazard_degree, RasterKind::classes, "Degree of hazard",
                                     "Degree of hazard from intensity and return period", "", "depth", k_even);
    degree.with_study = degree.of_scheme = true;
}

/// Rasters without classes of their own have those of the first quantity with their unit.
void set_classes_by_unit(std::vector<ResultRaster>& rows) {
    for (ResultRaster& row : rows)
        for (const QuantityClasses& quantity : quantity_classes())
            if (row.is_drawn() && row.classes.empty() && !row.unit.empty() && quantity.unit == row.unit)
                row.classes = quantity.name;
}

/// The flow's depths, whose direction output.depth chooses; what is released, eroded, deposited and changed
/// stays vertical.
void set_flow_depths(std::vector<ResultRaster>& rows) {
    for (ResultRaster& row : rows)
        row.is_flow_depth =
            row.kind != RasterKind::given && !row.of_ground && !depth_direction(row.description).empty();
}

void add_run(Table& table) {
    ResultRaster& depth = table.flow(RasterName::max_depth, "Maximum depth", "Maximum flow depth over time, vertical",
                                     "m", "depth", k_progressive);
    depth.is_surface = depth.has_view = true;
    table
        .flow(RasterName::max_velocity, "Maximum velocity", "Maximum flow speed over time, along the bed", "m/s",
              "velocity", k_even)
        .has_view = true;
    table.flow(RasterName::final_depth, "Final depth", "Flow depth at the end, vertical", "m", "depth", k_progressive)
        .is_surface = true;
    table.flow(RasterName::arrival_time, "Arrival time", "Time at which the flow first arrived", "s", "time", k_even);
    table.flow(RasterName::max_pressure, "Maximum dynamic pressure", "Maximum over time of density times speed squared",
               "kPa", "velocity", k_progressive);
    table
        .add("release", RasterKind::given, "Thickness released", "Thickness released, vertical", "m", "depth",
             k_progressive)
        .is_surface = true;
    table.add(RasterName::dtm, RasterKind::given, "Terrain", "Terrain on the working grid", "m", "", k_even);
    table.add(RasterName::bed, RasterKind::given, "Bed", "Sliding surface", "m", "", k_even);

    table.when("where the release is deeper than the flow outside of it", nullptr);
    ResultRaster& outside =
        table.flow(RasterName::outside_depth, "Maximum depth outside the release",
                   "Maximum flow depth over time outside the release, vertical", "m", "depth", k_progressive);
    outside.is_surface = outside.if_it_happens = outside.only_asked = true;

    table.when("at the end of a run", nullptr);
    ResultRaster& change = table.flow(RasterName::elevation_change, "Change of elevation",
                                      "Deposit minus release and erosion, vertical", "m", "difference", k_even);
    change.of_ground = true;
    change.bounds = {-k_infinity, -10, -5, -2, -0.5, 0.5, 2, 5, 10, k_infinity};
}

void add_choices(Table& table) {
    table.when("with `material.friction-table`",
               [](const SceneSpec& scene) { return scene.friction_table.name.has_value(); });
    table
        .add("mu", RasterKind::given, "Bed friction coefficient", "Bed friction coefficient mu", "-", "velocity",
             k_even)
        .bounds = {0, 0.15, 0.175, 0.2, 0.225, 0.25, 0.3, 0.35, 0.4, k_infinity};
    table
        .add("xi", RasterKind::given, "Turbulence coefficient", "Voellmy turbulence coefficient xi", "m/s2", "depth",
             k_even)
        .bounds = {0, 500, 1000, 1500, 2000, 2500, 3000, 3500, k_infinity};

    table.when("with `[hazard] scheme`", [](const SceneSpec& scene) { return scene.hazard.scheme.has_value(); });
    table.add("hazard", RasterKind::classes, "Intensity", "Classes of intensity", "", "depth", k_even).of_scheme = true;
    table.when("with a hazard scheme or a threshold that uses it, or `output.rasters`", [](const SceneSpec& scene) {
        return scene.hazard.scheme.has_value() || asks_for_intensity(scene.output) ||
               !scene.output.momentum_flux_thresholds.empty();
    });
    const auto intensity = [&](const char* name, const char* title, const char* description,
                               const char* unit) -> ResultRaster& {
        ResultRaster& row = table.flow(name, title, description, unit, "velocity", k_progressive);
        row.if_it_happens = true;
        row.asked_by = name;
        return row;
    };
    intensity(RasterName::max_flux, "Maximum flux", "Maximum over time of depth times speed at one moment", "m2/s")
        .of_depth = true;
    ResultRaster& momentum = intensity(RasterName::max_momentum_flux, "Maximum momentum flux",
                                       "Maximum over time of depth times speed squared at one moment", "m3/s2");
    momentum.of_depth = true;
    momentum.bounds = {0, 1, 3, 10, 30, 100, 300, 1000, k_infinity};
    intensity(RasterName::max_head, "Maximum energy head", "Maximum over time of depth plus v2/2g at one moment", "m")
        .classes = "max-head";

    table.when("with `output.rasters = plane_stress`",
               [](const SceneSpec& scene) { return asks_for_plane_stress(scene.output); });
    const auto stress = [&](const char* name, const char* title, const char* description) {
        ResultRaster& row = table.flow(name, title, description, "kPa", "velocity", k_even);
        row.in_frames = true;
        row.asked_by = k_plane_stress;
        row.bounds = {0, 10, 30, 100, 150, 200, 250, 300, k_infinity};
    };
    stress(RasterName::plane_stress_xx, "In-plane stress xx", "Normal stress in the plane across x, compression");
    stress(RasterName::plane_stress_yy, "In-plane stress yy", "Normal stress in the plane across y, compression");

    table.when("with `[entrainment]`", [](const SceneSpec& scene) { return scene.entrainment.active(); });
    table
        .flow(RasterName::eroded_depth, "Eroded depth", "Depth eroded from the bed, vertical", "m", "depth",
              k_progressive)
        .of_ground = true;
    table
        .flow(RasterName::deposited_depth, "Deposited depth", "Depth deposited on the bed, vertical", "m", "depth",
              k_progressive)
        .of_ground = true;

    table.when("where material flew over an edge",
               [](const SceneSpec& scene) { return scene.material.model != "structured" && flight(scene.numerics); });
    ResultRaster& jumps = table.flow(RasterName::jump_height, "Height of jumps",
                                     "Greatest height above the ground at which material flew over the cell", "m",
                                     "depth", k_progressive);
    jumps.if_it_happens = jumps.only_asked = true;
}

void add_structured(Table& table) {
    const char* const structured = "with the structured model";
    table.when(structured, [](const SceneSpec& scene) { return scene.material.model == "structured"; });
    const auto phase = [&](const char* name, const char* title, const char* description, const char* unit,
                           const char* palette, bool progressive) -> ResultRaster& {
        ResultRaster& row = table.flow(name, title, description, unit, palette, progressive);
        row.in_frames = true;
        return row;
    };
    phase("fluid_velocity", "Velocity of the fluid", "Speed of the free fluid, along the bed", "m/s", "velocity",
          k_even);
    table.when("with structured.soil-conductivity",
               [](const SceneSpec& scene) { return scene.structured.soil_conductivity.has_value(); });
    phase("infiltrated_depth", "Infiltration", "Depth of fluid that infiltrated into the ground", "m", "depth",
          k_progressive);
    table.when(structured, [](const SceneSpec& scene) { return scene.structured.phases == "solids-and-fluid"; });
    phase("fluid_depth", "Depth of free fluid", "Depth of the free fluid, vertical", "m", "depth", k_progressive);
    phase(RasterName::solid_depth, "Depth of solids", "Depth of solids without their fluid, vertical", "m", "depth",
          k_progressive);
    const std::vector<double> fractions{0, 0.2, 0.4, 0.6, 0.8, 1};
    phase("solid_fraction", "Solid fraction", "Fraction of solids in all material of the cell", "-", "depth", k_even)
        .bounds = fractions;
    phase(RasterName::cohesion_ratio, "Cohesion left", "Cohesion over initial cohesion, mean of the solids", "-",
          "depth", k_even)
        .bounds = fractions;
    phase(RasterName::strain, "Strain", "Greatest strain in the plane since the start, mean of the solids", "-",
          "depth", k_progressive)
        .classes = RasterName::strain;
    phase("solid_velocity", "Velocity of the solids", "Speed of solids and confined fluid, along the bed", "m/s",
          "velocity", k_even);
    phase("released_water", "Released fluid", "Confined fluid released by the solids in the cell", "m", "depth",
          k_progressive);
}

std::vector<ResultRaster> make_table() {
    Table table;
    add_run(table);
    add_choices(table);
    add_structured(table);
    table.by("compare", "with a surveyed outline");
    table.add("comparison", RasterKind::classes, "Comparison with the survey",
              "Simulated trace against the observed outline: 1 hit, 2 false alarm, 3 miss", "", "depth", k_even);

    table.by("run", "with `output.frames = on`");
    table
        .add("depth", RasterKind::frame, "Flow depth", "Flow depth at one instant, vertical", "m", "depth",
             k_progressive)
        .is_surface = true;
    table.add("velocity", RasterKind::frame, "Flow velocity", "Flow speed at one instant, along the bed", "m/s",
              "velocity", k_even);
    add_study(table);
    add_frequency(table);
    add_region(table);
    table.by("converge", "after `frana converge`");
    table.add(RasterName::uncertainty, RasterKind::flow, "Estimated error of the maximum depth",
              "Estimated discretisation error of the maximum depth, vertical", "m", "velocity", k_progressive);
    table.rows.back().classes = "error";
    set_classes_by_unit(table.rows);
    set_flow_depths(table.rows);
    return table.rows;
}

}  // namespace

bool asks_for_plane_stress(const OutputSpec& output) {
    return std::count(output.rasters.begin(), output.rasters.end(), k_plane_stress) > 0;
}

bool asks_for_intensity(const OutputSpec& output) {
    return std::any_of(output.rasters.begin(), output.rasters.end(),
                       [](const std::string& word) { return word != k_plane_stress; });
}

const std::vector<ResultRaster>& result_rasters() {
    static const std::vector<ResultRaster> k_table = make_table();
    return k_table;
}

const ResultRaster* find_result_raster(const std::string& name) {
    const std::vector<ResultRaster>& all = result_rasters();
    const auto found = std::find_if(all.begin(), all.end(), [&](const ResultRaster& one) {
        return one.by_value ? name.starts_with(one.of_value("")) : one.name == name;
    });
    return found == all.end() ? nullptr : &*found;
}

std::string text_for(const ResultRaster& row, const std::string& text, const std::string& name) {
    const auto place = text.find("{}");
    if (!row.by_value || place == std::string::npos) return text;
    std::string value = name.substr(row.of_value("").size());
    if (value.size() == 2 && value.front() == '0') value.erase(0, 1);
    return std::string(text).replace(place, 2, value);
}

std::string directed_description(const ResultRaster& row, const std::string& name, const std::string& direction) {
    std::string text = text_for(row, row.description, name);
    if (row.is_flow_depth) text.replace(text.rfind(k_vertical), std::string(k_vertical).size(), direction);
    return text;
}

std::string description_of(const ResultRaster& row, const std::string& name, const OutputSpec& output) {
    return directed_description(row, name, output.depth == k_normal_depth ? k_normal : k_vertical);
}

std::string depth_direction(const std::string& description) {
    for (const char* direction : {k_vertical, k_normal})
        if (description.find(std::string(", ") + direction) != std::string::npos) return direction;
    return "";
}

std::string raster_of_map(const std::string& map) {
    const std::string ending = k_view_ending;
    return map.ends_with(ending) ? map.substr(0, map.size() - ending.size()) : map;
}

std::vector<std::string> usual_maps() {
    std::vector<std::string> names;
    for (const ResultRaster& one : result_rasters()) {
        const bool shows = one.kind == RasterKind::flow || one.kind == RasterKind::classes;
        if (shows && one.command == "run" && !one.only_asked) names.push_back(one.name);
    }
    return names;
}

std::vector<std::string> map_names() {
    std::vector<std::string> names;
    for (const ResultRaster& one : result_rasters()) {
        const bool shows = one.kind == RasterKind::flow || one.kind == RasterKind::classes ||
                           (one.kind == RasterKind::given && one.is_drawn());
        if (shows && one.command == "run") names.push_back(one.name);
    }
    for (const ResultRaster& one : result_rasters())
        if (one.has_view) names.push_back(one.name + k_view_ending);
    return names;
}

}  // namespace frana
