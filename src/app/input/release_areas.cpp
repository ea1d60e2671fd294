// SPDX-License-Identifier: Apache-2.0
#include "app/input/release_areas.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "analysis/slip_surface.h"
#include "app/input/layer_values.h"
#include "app/text/number_text.h"
#include "core/shortest_text.h"
#include "simulation/scene_values.h"

namespace frana::app {
namespace {

/// The text or number of the first of these attributes that a polygon has, in any case; empty without one.
std::string attribute_of(const PolygonFeature& feature, const std::vector<std::string>& wanted) {
    const auto lower = [](std::string word) {
        for (char& c : word)
            if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
        return word;
    };
    for (const std::string& one : wanted) {
        for (const auto& [attribute, text] : feature.texts)
            if (lower(attribute) == one && !text.empty()) return text;
        for (const auto& [attribute, number] : feature.numbers)
            if (lower(attribute) == one && std::isfinite(number)) return shortest_text(number);
    }
    return {};
}

/// The name of a polygon in the user's file with its id in brackets, or what it has of both; empty without either.
std::string own_name(const PolygonFeature& feature) {
    const std::string name = attribute_of(feature, {"name", "label"}), id = attribute_of(feature, {"id"});
    if (name.empty() || id.empty() || name == id) return name.empty() ? id : name;
    return name + " (" + id + ")";
}

bool by_attribute(const std::optional<SourceSpec>& source) {
    return source && source->kind == SourceSpec::Kind::attribute;
}

std::optional<SlipShape> shape_of(const ReleaseSpec& spec) {
    if (spec.slip_shape == "ellipsoid") return SlipShape::ellipsoid;
    if (spec.slip_shape == "base-level") return SlipShape::base_level;
    return std::nullopt;
}

/// A slip surface under one polygon, fitted to the ground round it.
class FittedSurface {
  public:
    FittedSurface(const Raster& ground, const MultiPolygon& outline, std::optional<SlipShape> shape)
        : grid_(ground.grid),
          window_(window_round(ground, outline)),
          surface_(ground.values.is_tiled() ? SlipSurface(part_of(ground, window_), outline, shape)
                                            : SlipSurface(ground, outline, shape)) {}

    [[nodiscard]] const SlipSurface& surface() const noexcept { return surface_; }
    /// On the cells of the whole ground.
    [[nodiscard]] Raster thickness(double depth) const {
        Raster near = surface_.thickness(depth);
        if (near.grid.same_cells(grid_)) return near;
        Raster whole(grid_);
        near.values.for_each_stored([&](std::size_t cell, double metres) {
            const auto n = static_cast<std::int64_t>(cell);
            if (metres > 0) whole.at(window_.row + n / window_.columns, window_.column + n % window_.columns) = metres;
        });
        return whole;
    }

  private:
    // A large map's ground is only read there; its edges are the window's only where the outline touches them.
    static CellWindow window_round(const Raster& ground, const MultiPolygon& outline) {
        constexpr double k_margin = 2;  // cells
        const GridSpec& grid = ground.grid;
        const Bounds box = bounds(outline);
        const auto cell = [&](double metres, double margin, std::int64_t count) {
            return static_cast<std::int64_t>(
                std::clamp(std::floor(metres / grid.cell_size) + margin, 0.0, static_cast<double>(count - 1)));
        };
        const std::int64_t top = cell(grid.north - box.north, -k_margin, grid.rows),
                           bottom = cell(grid.north - box.south, k_margin, grid.rows),
                           left = cell(box.west - grid.west, -k_margin, grid.columns),
                           right = cell(box.east - grid.west, k_margin, grid.columns);
        return {top, left, bottom - top + 1, right - left + 1};
    }

    GridSpec grid_;
    CellWindow window_;
    SlipSurface surface_;
};

/// Returns the factor by which depths proportional to the square roots of the areas give a total volume.
double common_factor(const std::vector<FittedSurface>& surfaces, const gis::PolygonLayer& layer, double volume) {
    const auto total = [&](double factor) {
        double sum = 0;
        for (std::size_t i = 0; i < surfaces.size(); ++i)
            sum += surfaces[i].surface().volume(factor * std::sqrt(area(layer.features[i].parts)));
        return sum;
    };
    double low = 0, high = 1e-3;
    while (total(high) < volume && high < 1e6) high *= 2;
    while (high - low > 1e-9 * high) {
        const double middle = 0.5 * (low + high);
        (total(middle) < volume ? low : high) = middle;
    }
    return high;
}

}  // namespace

void set_details(const SceneReading& reading, const gis::PolygonLayer* layer, std::size_t feature, ReleaseArea& area,
                 Problems& problems) {
    const ReleaseSpec& spec = reading.scene.release;
    set_uniform_details(spec, area);
    if (layer == nullptr) return;
    area.name = own_name(layer->features[feature]);
    const auto value = [&](const std::string& key, const std::optional<SourceSpec>& source) -> std::optional<double> {
        if (!source) return std::nullopt;
        return value_of(reading, key, *source, *layer, feature, problems);
    };
    area.start = value("release.start", spec.start).value_or(0);
    area.speed = value("release.velocity", spec.velocity).value_or(0);
    if (const auto degrees = value("release.direction", spec.direction))
        area.azimuth = *degrees * std::numbers::pi / 180;
    if (by_attribute(spec.volume)) area.volume = value("release.volume", spec.volume);
}

std::vector<ReleaseArea> areas_by_feature(const SceneReading& reading, const gis::PolygonLayer& layer,
                                          Problems& problems) {
    const ThicknessSpec& spec = *reading.scene.release.thickness;
    const std::string where = reading.where("release.thickness");
    std::vector<ReleaseArea> areas;
    for (std::size_t i = 0; i < layer.features.size(); ++i) {
        ReleaseArea area;
        area.outline = layer.features[i].parts;
        area.thickness = spec.metres;
        if (spec.kind == ThicknessSpec::Kind::attribute) {
            const SourceSpec source{SourceSpec::Kind::attribute, 0, spec.attribute};
            const auto thickness = value_of(reading, "release.thickness", source, layer, i, problems);
            if (!thickness) continue;
            area.thickness = *thickness;
            if (!(area.thickness > 0) || !std::isfinite(area.thickness)) {
                problems.add({feature_name(layer, i) + " has a thickness that is not positive", where,
                              shortest_text(area.thickness) + " m", "greater than 0",
                              "Correct the attribute " + spec.attribute});
                continue;
            }
        }
        set_details(reading, &layer, i, area, problems);
        areas.push_back(std::move(area));
    }
    return areas;
}

std::vector<ReleaseArea> areas_of_raster(const SceneReading& reading, const gis::PolygonLayer& layer,
                                         const Raster& thickness, Problems& problems) {
    std::vector<ReleaseArea> areas;
    const ReleaseSpec& spec = reading.scene.release;
    if (layer.overlap) {
        if (by_attribute(spec.start) || by_attribute(spec.velocity) || by_attribute(spec.direction) ||
            by_attribute(spec.volume)) {
            problems.add({"polygons with attributes of their own overlap on one thickness raster",
                          reading.where("release.perimeter"), "", "", "Draw them apart"});
            return areas;
        }
        ReleaseArea area;
        for (const PolygonFeature& feature : layer.features)
            area.outline.insert(area.outline.end(), feature.parts.begin(), feature.parts.end());
        areas.push_back(std::move(area));
        set_details(reading, nullptr, 0, areas.back(), problems);
    } else {
        for (std::size_t i = 0; i < layer.features.size(); ++i) {
            ReleaseArea area;
            area.outline = layer.features[i].parts;
            set_details(reading, &layer, i, area, problems);
            areas.push_back(std::move(area));
        }
    }
    for (ReleaseArea& area : areas) area.thickness_raster = thickness;
    return areas;
}

std::vector<ReleaseArea> areas_above_slip_surfaces(const SceneReading& reading, const gis::PolygonLayer& layer,
                                                   const Raster& ground, RunLog& log, Problems& problems) {
    const ReleaseSpec& spec = reading.scene.release;
    std::vector<ReleaseArea> areas;
    std::vector<FittedSurface> surfaces;
    for (std::size_t i = 0; i < layer.features.size(); ++i) {
        try {
            surfaces.emplace_back(ground, layer.features[i].parts, shape_of(spec));
        } catch (const Error& error) {
            Problem problem = error.problems().front();
            problem.what = feature_name(layer, i) + ": " + problem.what;
            problem.where = reading.where(problem.where);
            problems.add(problem);
        }
    }
    if (surfaces.size() != layer.features.size()) return areas;
    const bool shared = spec.volume && !by_attribute(spec.volume);
    const double factor = shared ? common_factor(surfaces, layer, spec.volume->number) : 0;
    for (std::size_t i = 0; i < layer.features.size(); ++i) {
        ReleaseArea area;
        area.outline = layer.features[i].parts;
        set_details(reading, &layer, i, area, problems);
        std::optional<double> depth;
        if (spec.slip_depth) depth = value_of(reading, "release.slip-depth", *spec.slip_depth, layer, i, problems);
        if (area.volume) depth = surfaces[i].surface().depth_for(*area.volume);
        if (shared) depth = factor * std::sqrt(frana::area(area.outline));
        if (!depth) continue;
        area.thickness_raster = surfaces[i].thickness(*depth);
        log.note("slip surface under " + feature_name(layer, i) + ": " +
                 (surfaces[i].surface().shape() == SlipShape::ellipsoid ? "ellipsoid" : "sloping local base level") +
                 ", " + number_text(*depth, 4) + " m deep");
        areas.push_back(std::move(area));
    }
    return areas;
}

}  // namespace frana::app
