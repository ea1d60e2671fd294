// SPDX-License-Identifier: Apache-2.0
#include "simulation/run_values.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "simulation/run_summary.h"

namespace frana {

const Raster* RunResult::find_raster(const std::string& name) const noexcept {
    const auto found =
        std::find_if(rasters.begin(), rasters.end(), [&](const NamedRaster& one) { return one.name == name; });
    return found == rasters.end() ? nullptr : &found->values;
}

const Raster& RunResult::raster(const std::string& name) const {
    const Raster* const found = find_raster(name);
    if (found == nullptr) throw std::out_of_range("the run made no raster " + name);
    return *found;
}

Raster intensity_classes(const RunResult& result, const HazardScheme& scheme) {
    // For a scheme without flux or head none is recorded; depth is passed instead and not read.
    const Raster& depth = result.raster("max_depth");
    const auto recorded = [&](const char* name) -> const Raster& {
        const Raster* const found = result.find_raster(name);
        return found ? *found : depth;
    };
    return hazard_classes(scheme, {depth, result.raster("max_velocity"), recorded("max_flux"), recorded("max_head"),
                                   result.raster("max_pressure"), result.raster("final_depth")});
}

namespace {

/// A value at a place with a name.
struct PlaceValue {
    const char *kind, *key;  ///< "gauge NAME: max_depth_m"
    const char *title, *unit;

    [[nodiscard]] std::string before() const { return std::string(kind) + " "; }
    [[nodiscard]] std::string after() const { return std::string(": ") + key; }
    [[nodiscard]] RunValue at(const std::string& name, double value, double negligible) const {
        return {before() + name + after(), Words()(title, {name}), unit, value, 0, negligible};
    }
};
constexpr PlaceValue k_gauge_depth{"gauge", "max_depth_m", worded("greatest depth at gauge {1}"), "m"},
    k_gauge_speed{"gauge", "max_speed_ms", worded("greatest speed at gauge {1}"), "m/s"},
    k_section_discharge{"section", "max_discharge_m3s", worded("greatest discharge through {1}"), "m3/s"},
    k_section_volume{"section", "volume_m3", worded("volume through {1}"), "m3"};

void add_gauges(const RunResult& result, const Scene& scene, std::vector<RunValue>& values) {
    const std::vector<Gauge>& gauges = scene.recording.gauges;
    std::vector<double> depth(gauges.size()), speed(gauges.size());
    for (const GaugeRow& row : result.gauges) {
        depth[row.gauge] = std::max(depth[row.gauge], row.depth);
        speed[row.gauge] = std::max(speed[row.gauge], row.speed);
    }
    for (std::size_t i = 0; i < gauges.size(); ++i) {
        const std::string& name = gauges[i].name;
        values.push_back(k_gauge_depth.at(name, depth[i], scene.numerics.minimum_depth));
        values.push_back(k_gauge_speed.at(name, speed[i], scene.time.moving_speed));
    }
}

void add_sections(const RunResult& result, const Scene& scene, std::vector<RunValue>& values) {
    const std::vector<CrossSection>& sections = scene.recording.sections;
    std::vector<double> discharge(sections.size()), volume(sections.size());
    for (const SectionRow& row : result.sections) {
        discharge[row.section] = std::max(discharge[row.section], std::abs(row.discharge));
        volume[row.section] = row.volume;
    }
    for (std::size_t i = 0; i < sections.size(); ++i) {
        const std::string& name = sections[i].name;
        values.push_back(k_section_discharge.at(name, discharge[i], 0));
        values.push_back(k_section_volume.at(name, volume[i], 0));
    }
}

/// Returns the place in a key of a gauge or cross-section, with the value's title; nothing for other keys.
std::optional<std::pair<const char*, std::string>> place_in(const std::string& key) {
    for (const PlaceValue& one : {k_gauge_depth, k_gauge_speed, k_section_discharge, k_section_volume}) {
        const std::string before = one.before(), after = one.after();
        if (key.size() >= before.size() + after.size() && key.starts_with(before) && key.ends_with(after))
            return std::pair(one.title, key.substr(before.size(), key.size() - before.size() - after.size()));
    }
    return std::nullopt;
}

}  // namespace

std::vector<RunValue> reported_values(const RunResult& result, const Scene& scene, double threshold) {
    const RunStatistics statistics = run_statistics(result, threshold);
    std::vector<RunValue> values;
    for (const RunStatistic& row : k_run_statistics) {
        if (!is_reported(row)) continue;
        const double value = row.of(statistics);
        const bool is_run_out = std::string_view(row.key) == k_run_out_key;
        values.push_back({row.key, row.title, row.unit, std::isnan(value) ? 0 : value,
                          is_run_out ? result.raster("max_depth").grid.cell_size : 0, 0});
    }
    add_gauges(result, scene, values);
    add_sections(result, scene, values);
    return values;
}

bool is_value_key(const std::string& key) {
    return std::any_of(std::begin(k_run_statistics), std::end(k_run_statistics),
                       [&](const RunStatistic& row) { return key == row.key; }) ||
           place_in(key).has_value();
}

std::string title_in(const RunValue& value, const Words& words) {
    const auto place = place_in(value.key);
    return place ? words(place->first, {place->second}) : words(value.title);
}

}  // namespace frana
