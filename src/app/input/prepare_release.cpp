// SPDX-License-Identifier: Apache-2.0
#include "app/input/prepare_release.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "analysis/slip_surface.h"
#include "app/input/check_inputs.h"
#include "app/input/layer_values.h"
#include "app/input/on_demand.h"
#include "app/input/prepare_terrain.h"
#include "app/input/used_file.h"
#include "app/text/number_text.h"
#include "core/text.h"
#include "core/words/words.h"
#include "gis/crs/crs.h"
#include "gis/raster/footprint.h"
#include "gis/vector/vector_in.h"
#include "params/keys/plausible.h"
#include "simulation/scene.h"
#include "simulation/scene_values.h"

namespace frana::app {
namespace {

/// The text or number of the first of these attributes that a polygon has, in any case; empty without one.
std::string attribute_of(const Feature& feature, const std::vector<std::string>& wanted) {
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
std::string own_name(const Feature& feature) {
    const std::string name = attribute_of(feature, {"name", "label"}), id = attribute_of(feature, {"id"});
    if (name.empty() || id.empty() || name == id) return name.empty() ? id : name;
    return name + " (" + id + ")";
}

bool by_attribute(const std::optional<SourceSpec>& source) {
    return source && source->kind == SourceSpec::Kind::attribute;
}

/// A slip surface under one polygon, fitted to the ground round it.
class FittedSurface {
  public:
    FittedSurface(const Raster& ground, const MultiPolygon& outline)
        : grid_(ground.grid),
          window_(window_round(ground, outline)),
          surface_(ground.values.is_tiled() ? SlipSurface(part_of(ground, window_), outline)
                                            : SlipSurface(ground, outline)) {}

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
            sum += surfaces[i].surface().volume(factor * std::sqrt(area(layer.features[i].shape.areas)));
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

/// Sets name, start, velocity, direction and volume of an area: the scene's numbers, or a feature's own in the columns
/// named by the keys (null layer: numbers only).
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

/// Returns one area per feature, its thickness the scene's number or the feature's own attribute.
std::vector<ReleaseArea> areas_by_feature(const SceneReading& reading, const gis::PolygonLayer& layer,
                                          Problems& problems) {
    const ThicknessSpec& spec = *reading.scene.release.thickness;
    const Place where = reading.where("release.thickness");
    std::vector<ReleaseArea> areas;
    for (std::size_t i = 0; i < layer.features.size(); ++i) {
        ReleaseArea area;
        area.outline = layer.features[i].shape.areas;
        area.thickness = spec.metres;
        if (spec.kind != nullptr) {
            const SourceSpec source{SourceSpec::Kind::attribute, 0, spec.names.front()};
            const auto thickness = value_of(reading, "release.thickness", source, layer, i, problems);
            if (!thickness) continue;
            area.thickness = *thickness;
            if (!(area.thickness > 0) || !std::isfinite(area.thickness)) {
                problems.add({feature_name(layer, i) + " has a thickness that is not positive", where,
                              shortest_text(area.thickness) + " m", "greater than 0",
                              "Correct the attribute " + spec.names.front()});
                continue;
            }
        }
        set_details(reading, &layer, i, area, problems);
        areas.push_back(std::move(area));
    }
    return areas;
}

/// Returns one area per feature, filled to a level; its thickness over the terrain is told by a raster.
std::vector<ReleaseArea> areas_to_level(const SceneReading& reading, const gis::PolygonLayer& layer,
                                        const Raster& ground, Problems& problems) {
    std::vector<ReleaseArea> areas;
    for (std::size_t i = 0; i < layer.features.size(); ++i) {
        const auto level = value_of(reading, "release.level", *reading.scene.release.level, layer, i, problems);
        if (!level) continue;
        ReleaseArea area;
        area.outline = layer.features[i].shape.areas;
        area.level = *level;
        area.thickness_raster = Raster(ground.grid);
        gis::visit_cells(area.outline, ground.grid, gis::Cover::closed, [&](std::int64_t row, std::int64_t column) {
            area.thickness_raster->at(row, column) = std::max(0.0, *level - ground.at(row, column));
        });
        set_details(reading, &layer, i, area, problems);
        areas.push_back(std::move(area));
    }
    return areas;
}

/// Whether features share cells.
bool overlap(const gis::PolygonLayer& layer, const GridSpec& grid) {
    if (layer.features.size() < 2) return false;
    Raster times(grid);
    bool shared = false;
    for (const Feature& feature : layer.features)
        gis::visit_cells(feature.shape.areas, grid, gis::Cover::centres, [&](std::int64_t row, std::int64_t column) {
            shared = shared || ++times.at(row, column) > 1;
        });
    return shared;
}

/// Returns one area per feature with the same thickness raster; one for all if features overlap, so that common area
/// counts once (then without attributes of their own: that is a problem).
std::vector<ReleaseArea> areas_of_raster(const SceneReading& reading, const gis::PolygonLayer& layer,
                                         const Raster& thickness, Problems& problems) {
    std::vector<ReleaseArea> areas;
    const ReleaseSpec& spec = reading.scene.release;
    if (overlap(layer, thickness.grid)) {
        if (by_attribute(spec.start) || by_attribute(spec.velocity) || by_attribute(spec.direction) ||
            by_attribute(spec.volume)) {
            problems.add({"polygons with attributes of their own overlap on one thickness raster",
                          reading.where("release.perimeter"), "", "", "Draw them apart"});
            return areas;
        }
        ReleaseArea area;
        for (const Feature& feature : layer.features)
            area.outline.insert(area.outline.end(), feature.shape.areas.begin(), feature.shape.areas.end());
        areas.push_back(std::move(area));
        set_details(reading, nullptr, 0, areas.back(), problems);
    } else {
        for (std::size_t i = 0; i < layer.features.size(); ++i) {
            ReleaseArea area;
            area.outline = layer.features[i].shape.areas;
            set_details(reading, &layer, i, area, problems);
            areas.push_back(std::move(area));
        }
    }
    for (ReleaseArea& area : areas) area.thickness_raster = thickness;
    return areas;
}

/// Returns one area per feature, down to a slip surface fitted to it: of the depth release.slip-depth, or of the depth
/// that gives release.volume; a volume for several polygons is divided over similar surfaces, their depths proportional
/// to the square roots of their areas. Logs shape and depth of each.
std::vector<ReleaseArea> areas_above_slip_surfaces(const SceneReading& reading, const gis::PolygonLayer& layer,
                                                   const Raster& ground, Findings found, Problems& problems) {
    const ReleaseSpec& spec = reading.scene.release;
    std::vector<ReleaseArea> areas;
    std::vector<FittedSurface> surfaces;
    for (std::size_t i = 0; i < layer.features.size(); ++i) {
        try {
            surfaces.emplace_back(ground, layer.features[i].shape.areas);
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
        area.outline = layer.features[i].shape.areas;
        set_details(reading, &layer, i, area, problems);
        std::optional<double> depth;
        if (spec.slip_depth) depth = value_of(reading, "release.slip-depth", *spec.slip_depth, layer, i, problems);
        if (area.volume) depth = surfaces[i].surface().depth_for(*area.volume);
        if (shared) depth = factor * std::sqrt(frana::area(area.outline));
        if (!depth) continue;
        area.thickness_raster = surfaces[i].thickness(*depth);
        found.log.note(
            "slip surface under " + feature_name(layer, i) + ": " +
            (surfaces[i].surface().shape() == SlipShape::ellipsoid ? "ellipsoid" : "sloping local base level") + ", " +
            number_text(*depth, 4) + " m deep");
        areas.push_back(std::move(area));
    }
    return areas;
}

/// Returns the depth of solids and fluid together; keeps the solids' fraction. A missing depth counts as zero; callers
/// have checked that none is negative.
Raster sum_of_phases(const Raster& solids, const Raster& fluid, ReleaseInput& release) {
    Raster sum(solids.grid, k_no_data), fraction(solids.grid, k_no_data);
    const auto add = [&](std::size_t cell, double) {
        const double s = solids.values[cell] > 0 ? solids.values[cell] : 0,
                     f = fluid.values[cell] > 0 ? fluid.values[cell] : 0;
        if (!(s + f > 0)) return;
        sum.values[cell] = s + f;
        fraction.values[cell] = s / (s + f);
    };
    solids.values.for_each_stored(add);
    fluid.values.for_each_stored(add);
    release.solid_fraction = std::move(fraction);
    return sum;
}

/// What a file covers, in the CRS of the grid.
Bounds extent_on(const GridSpec& grid, const gis::RasterInfo& file) {
    return gis::CrsTransform(grid.crs_wkt.empty() ? "" : file.crs_wkt, grid.crs_wkt, file.bounds).around(file.bounds);
}

constexpr const char* k_negative_depth = "a depth is negative";

/// The depth of a phase on a large working grid; only where it is positive it takes memory. Throws Error(input).
Raster phase_on_demand(const GridSpec& grid, const std::shared_ptr<const gis::RasterOnDemand>& file,
                       const gis::RasterInfo& info, const Place& where) {
    const auto checked = [&](double depth) {
        if (depth < 0)
            throw Error(ErrorKind::input,
                        Problem{k_negative_depth, where, info.path + ": " + shortest_text(depth) + " m", "0 or more",
                                "Correct the raster"});
        return depth;
    };
    return positive_values(raster_values_on_demand(grid, file, checked), extent_on(grid, info));
}

/// Returns a mask of the cells where a thickness is positive.
Raster positive_part(const Raster& thickness, const TerrainInput& ground, const gis::RasterInfo& file) {
    if (ground.on_demand) return positive_cells(thickness, extent_on(thickness.grid, file));
    Raster positive(thickness.grid);
    thickness.values.for_each_stored([&](std::size_t cell, double metres) {
        if (metres > 0) positive.values[cell] = 1;
    });
    return positive;
}

/// Returns the thickness of files on the working grid.
std::optional<Raster> thickness_raster(const SceneReading& reading, const ThicknessSpec& spec,
                                       const TerrainInput* ground, ReleaseInput& release, std::vector<UsedFile>& files,
                                       Findings found, Problems& problems) {
    const Place where = reading.where("release.thickness");
    const ThicknessKind& kind = *spec.kind;
    // A thickness has its own unit.
    const std::string unit = kind.elevations ? reading.scene.terrain.vertical_unit : "auto";
    const std::optional<double> nodata = kind.elevations ? reading.scene.terrain.nodata_value : std::nullopt;
    std::vector<Raster> rasters;
    std::vector<std::shared_ptr<const gis::RasterOnDemand>> unread;
    for (const std::string& file : spec.names) {
        attempt(problems, [&] {
            const gis::RasterInfo info = reading.session.read(gis::inspect_raster, file, where);
            if (ground == nullptr) return;
            const bool local = ground->terrain.grid.crs_wkt.empty();
            if (!local && info.crs_wkt.empty()) {
                problems.add({"has no coordinate reference system", where, file, "", k_state_zone_crs});
                return;
            }
            gis::RasterRead read;
            if (ground->on_demand) {
                unread.push_back(std::make_shared<const gis::RasterOnDemand>(
                    file, ground->terrain.grid, info.crs_wkt, gis::Resampling::automatic, unit, nodata, where));
                read = unread.back()->known();
            } else {
                read = reading.session.read(gis::read_raster_on, file, ground->terrain.grid, info.crs_wkt,
                                            gis::Resampling::automatic, unit, nodata, where);
            }
            found.warn_of(worded("Release thickness"), read.warnings);
            report_transform(file, read.transform, ground->terrain.grid.cell_size, found);
            found.log.note("thickness " + file + ": resampling " + read.resampling_used);
            release.rasters.push_back(info);
            files.push_back(used_raster(worded("Release thickness"), info, read));
            if (ground->on_demand) do_not_count_nodata(files.back());
            if (ground->on_demand && kind.phases)
                read.raster = phase_on_demand(ground->terrain.grid, unread.back(), info, where);
            rasters.push_back(std::move(read.raster));
        });
    }
    if (rasters.size() != spec.names.size()) return std::nullopt;
    if (kind.phases) {
        for (std::size_t i = 0; i < rasters.size() && !ground->on_demand; ++i) {
            const double least =
                *std::min_element(rasters[i].values.begin(), rasters[i].values.end(),
                                  [](double a, double b) { return (std::isnan(a) ? 0 : a) < (std::isnan(b) ? 0 : b); });
            if (!(least < 0)) continue;
            problems.add({k_negative_depth, where, spec.names[i] + ": " + shortest_text(least) + " m", "0 or more",
                          "Correct the raster"});
            return std::nullopt;
        }
        return sum_of_phases(rasters[0], rasters[1], release);
    }
    Raster thickness(ground->terrain.grid);
    if (ground->on_demand) {
        thickness = thickness_on_demand(kind, thickness.grid, unread, ground->on_demand);
    } else {
        std::vector<double> here(rasters.size());
        for (std::size_t i = 0; i < thickness.values.size(); ++i) {
            for (std::size_t k = 0; k < here.size(); ++k) here[k] = std::as_const(rasters[k]).values[i];
            thickness.values[i] = kind.metres(ground->terrain.values[i], here);
        }
    }
    if (kind.elevations && !kind.below_dtm)  // both surfaces are files
        release.before = ground->on_demand
                             ? raster_values_on_demand(thickness.grid, unread[0], [](double z) { return z; })
                             : std::move(rasters[0]);
    return thickness;
}

void read_perimeter(const SceneReading& reading, const TerrainInput* ground, std::vector<UsedFile>& files,
                    Findings found, Problems& problems, ReleaseInput& release) {
    if (!reading.scene.release.perimeter) return;
    const std::string key = "release.perimeter";
    const auto read = [&] {
        release.perimeter =
            reading.session.read(gis::read_polygons, *reading.scene.release.perimeter, target_crs(reading, ground),
                                 reading.where(key), layer_choice(reading, reading.scene.release.perimeter_layer, key));
    };
    if (!attempt(problems, read)) return;
    const gis::PolygonLayer& layer = *release.perimeter;
    files.push_back(used_polygons(worded("Release perimeter"), *reading.scene.release.perimeter, layer));
    found.log.note("perimeter " + *reading.scene.release.perimeter + ": " + std::to_string(layer.features.size()) +
                   " features in " + (layer.crs_label.empty() ? "plain metres" : layer.crs_label));
    found.warn_of(worded("Release perimeter"), layer.warnings);
    if (ground != nullptr)
        report_transform(worded("Release perimeter"), layer.transform, ground->terrain.grid.cell_size, found);
}

}  // namespace

ReleaseInput prepare_release(const SceneReading& reading, const TerrainInput* ground, std::vector<UsedFile>& files,
                             Findings found, Problems& problems) {
    ReleaseInput release;
    read_perimeter(reading, ground, files, found, problems, release);
    if (!reading.scene.release.thickness && !reading.scene.release.level)
        return release;  // reported when the scene was read
    const ThicknessSpec spec = reading.scene.release.thickness.value_or(ThicknessSpec{});
    if (reading.scene.release.level) {
        if (!release.perimeter || ground == nullptr ||
            !is_on_ground(reading, "release.perimeter", release.perimeter->bounds, *ground, false, problems))
            return release;
        release.areas = areas_to_level(reading, *release.perimeter, ground->terrain, problems);
    } else if (spec.by_raster()) {
        std::optional<Raster> thickness = thickness_raster(reading, spec, ground, release, files, found, problems);
        if (!thickness || (reading.scene.release.perimeter && !release.perimeter)) return release;
        if (release.perimeter) {
            release.areas = areas_of_raster(reading, *release.perimeter, *thickness, problems);
        } else {
            ReleaseArea area;
            area.outline = gis::polygonise(positive_part(*thickness, *ground, release.rasters.front()));
            area.thickness_raster = std::move(thickness);
            set_details(reading, nullptr, 0, area, problems);
            release.areas.push_back(std::move(area));
        }
    } else if (release.perimeter && spec.fitted()) {
        if (ground == nullptr ||
            !is_on_ground(reading, "release.perimeter", release.perimeter->bounds, *ground, false, problems))
            return release;
        release.areas = areas_above_slip_surfaces(reading, *release.perimeter, ground->terrain, found, problems);
    } else if (release.perimeter) {
        release.areas = areas_by_feature(reading, *release.perimeter, problems);
    }
    double fastest = 0;
    for (const ReleaseArea& area : release.areas) {
        release.area_m2 += frana::area(area.outline);
        fastest = std::max(fastest, area.speed);
    }
    if (const auto warning = implausible("release.velocity", fastest)) found.warn(*warning);
    const double end = reading.scene.time.end;
    const auto is_late = [&](const ReleaseArea& area) { return area.start >= end; };
    if (!release.areas.empty() && !reading.scene.inflow.line && reading.scene.material.model != "structured" &&
        std::all_of(release.areas.begin(), release.areas.end(), is_late))
        problems.add({"nothing is released before the end of the run", reading.where("release.start"),
                      shortest_text(release.areas.front().start) + " s", "before " + shortest_text(end) + " s",
                      "Raise time.end, or correct the start"});
    if (ground != nullptr) {
        check_release(reading, *ground, release, found, problems);
        release.before.reset();
        // What was read on demand is that under the outlines, which were looked at just now.
        if (ground->on_demand && spec.by_raster() && !release.areas.empty())
            files.back().checksum.add(*release.areas.front().thickness_raster);
        // Interpolated at its edge, a raster would lose volume; the released volume is that of the file.
        if (problems.empty() && spec.as_in_file() && !reading.scene.release.volume)
            match_file_volume(release, ground->terrain.grid, reading.session, files.back());
    }
    return release;
}

}  // namespace frana::app
