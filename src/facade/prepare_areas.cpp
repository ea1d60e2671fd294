// SPDX-License-Identifier: Apache-2.0
#include "facade/prepare_areas.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <span>

#include "analysis/cell_outlines.h"
#include "core/shortest_text.h"
#include "facade/particle_count.h"
#include "facade/values_in_place.h"
#include "params/keys/laws.h"
#include "params/keys/zone_keys.h"
#include "params/scene/read_keys.h"
#include "simulation/release.h"
#include "simulation/scene_values.h"

namespace frana::facade {
namespace {

std::string name_of(const Release& release, std::size_t index) {
    return "release " + (release.name.empty() ? std::to_string(index + 1) : release.name);
}

std::string extent_of(const Bounds& box) {
    return "west " + shortest_text(box.west) + " south " + shortest_text(box.south) + " east " +
           shortest_text(box.east) + " north " + shortest_text(box.north);
}

frana::Ring ring_of(const Ring& points) {
    frana::Ring ring;
    for (const Point& p : points) ring.push_back({p.x, p.y});
    return ring;
}

MultiPolygon outline_of(const Release& release, const GridSpec& grid) {
    if (release.outline.empty() && !release.thicknesses.empty())
        return outlines_where_positive(grid, release.thicknesses.cells);
    MultiPolygon outline;
    for (const Polygon& polygon : release.outline) {
        frana::Polygon& own = outline.emplace_back();
        own.outer = ring_of(polygon.outer);
        for (const Ring& hole : polygon.holes) own.holes.push_back(ring_of(hole));
    }
    return outline;
}

bool check_outline(const MultiPolygon& outline, const GridSpec& grid, const std::string& where, Problems& problems) {
    for (const frana::Polygon& polygon : outline) {
        const bool finite = std::all_of(polygon.outer.begin(), polygon.outer.end(),
                                        [](const frana::Point& p) { return std::isfinite(p.x) && std::isfinite(p.y); });
        if (finite && polygon.outer.size() >= 3 && area(polygon) > 0) continue;
        problems.add({"has an outline without area", where, "", "", "Give at least three points that are not in line"});
        return false;
    }
    const Bounds box = bounds(outline), map = grid.bounds();
    if (box.west >= map.west && box.east <= map.east && box.south >= map.south && box.north <= map.north) return true;
    problems.add({"reaches beyond the terrain", where, extent_of(box), extent_of(map),
                  "Check the coordinates of both, or give a larger terrain"});
    return false;
}

/// A number of the scene by the rule of the key that gives it in a file.
bool check_number(const std::string& key, double value, const std::string& where, Problems& problems) {
    std::optional<frana::Problem> problem = problem_of_key(key, shortest_text(value));
    if (!problem) return true;
    problem->where = where;
    problems.add(*problem);
    return false;
}

void check_thickness(double thickness, const std::string& where, Problems& problems) {
    if (thickness >= k_least_thickness && thickness <= k_most_thickness) return;
    problems.add(
        {std::string("would be ") + (thickness > k_most_thickness ? "thicker" : "thinner") + " than any landslide",
         where, shortest_text(thickness) + " m",
         shortest_text(k_least_thickness) + " to " + shortest_text(k_most_thickness) + " m",
         "Check the unit and the sign"});
}

bool check_thicknesses(std::span<const double> cells, const std::string& where, Problems& problems) {
    double least = 0, greatest = 0;
    for (const double t : cells) {
        if (t < least) least = t;
        if (t > greatest) greatest = t;
    }
    if (least < 0) {
        problems.add({"the thickness is negative", where, shortest_text(least) + " m", "0 or more",
                      "The difference after minus before has the wrong sign; where there is no data give NaN"});
    } else if (!(greatest > 0)) {
        problems.add({"nothing is released: the thickness is nowhere positive", where, "", "", "Check its cells"});
    } else {
        if (greatest > k_most_thickness) check_thickness(greatest, where, problems);
        return greatest <= k_most_thickness;
    }
    return false;
}

}  // namespace

std::vector<ReleaseArea> release_areas(const Scene::Data& data, const SceneSpec& spec, const GridSpec& grid,
                                       Problems& problems) {
    std::vector<ReleaseArea> areas;
    if (data.release.empty() && data.inflows.empty())
        problems.add({"nothing is released", "scene", "", "", "Add an area of release or an inflow"});
    for (std::size_t i = 0; i < data.release.size(); ++i) {
        const Release& release = data.release[i];
        const std::string where = name_of(release, i);
        ReleaseArea own;
        own.name = release.name;
        own.volume = release.volume;
        set_uniform_details(spec.release, own);
        if (release.volume && release_volume_of(spec.release))
            problems.add({"contradicts release.volume, the volume of all areas", where + ": volume",
                          shortest_text(*release.volume) + " m3", "", "Keep one of the two"});
        const bool has_volume =
            release.volume && check_number("release.volume", *release.volume, where + ": volume", problems);
        if (release.thicknesses.empty()) {
            if (check_number("release.thickness", release.thickness, where, problems))
                check_thickness(release.thickness, where, problems);
            own.thickness = release.thickness;
        } else if (check_thicknesses(release.thicknesses.cells, where, problems)) {
            own.thickness_raster = raster_in_place(grid, release.thicknesses);
        } else {
            continue;
        }
        own.outline = outline_of(release, grid);
        if (own.outline.empty()) problems.add({"has no outline", where, "", "", "Give one, or thicknesses by cell"});
        if (own.outline.empty() || !check_outline(own.outline, grid, where, problems)) continue;
        if (has_volume) check_thickness(*release.volume / area(own.outline), where + ": volume", problems);
        check_particle_count(area(own.outline) * spec.numerics.particles_per_cell / grid.cell_area(), where, problems);
        if (own.thickness_raster && !own.volume && !spec.release.volume && !own.normal_to_bed) {
            // Interpolated at its edge, a raster would lose volume.
            MultiPolygon local = own.outline;
            const auto move = [&](frana::Ring& ring) {
                for (frana::Point& p : ring) p = grid.local_from_map(p);
            };
            for (frana::Polygon& polygon : local) {
                move(polygon.outer);
                for (frana::Ring& hole : polygon.holes) move(hole);
            }
            if (const double volume = volume_in_cells(*own.thickness_raster, grid.cell_size, local); volume > 0)
                own.volume = volume;
        }
        areas.push_back(std::move(own));
    }
    return areas;
}

MaterialZones material_zones(const Scene::Data& data, const SceneSpec& spec, const GridSpec& grid, Problems& problems) {
    MaterialZones zones;
    const std::vector<const Law*> laws = laws_of(spec);
    for (const ZoneKey& key : zone_keys()) {
        const auto found = data.by_place.find(key.name);
        if (found == data.by_place.end()) continue;
        const Values& values = found->second;
        if (readers_of(key.name, laws).empty())
            problems.add({"gives the " + key.what + ", which the scene's laws do not use", key.name, "", "",
                          "Set " + selected_by(readers_of(key.name)) + ", or remove the values"});
        double greatest = -HUGE_VAL;
        for (const double value : values.cells) {
            if (std::isnan(value)) continue;
            greatest = std::max(greatest, value);
            if (key.range.has(value)) continue;
            problems.add({"is out of range", key.name, shortest_text(value) + " " + key.unit, key.range.text(),
                          "NaN where the value of the material applies"});
            break;
        }
        const auto tangent = [](double degrees) { return std::tan(degrees * std::numbers::pi / 180); };
        for (const Law* law : laws) {
            const double friction = key.degrees() ? tangent(greatest) : greatest;
            if (key.what != "friction" || !(friction > law->greatest_friction)) continue;
            problems.add({"the friction is too large for the law " + law->word, key.name, shortest_text(friction),
                          "0 to " + shortest_text(law->greatest_friction), "The law is not defined above that"});
        }
        const auto* const zone = std::find_if(std::begin(k_zone_rasters), std::end(k_zone_rasters),
                                              [&](const ZoneRaster& raster) { return raster.what == key.what; });
        std::optional<frana::Raster>& target = zones.*zone->raster;
        if (target)
            problems.add({"contradicts another key of [zones]: both give the " + key.what, key.name, "", "",
                          "Keep one of the two"});
        const Change to_tangents = [tangent](const CellWindow& window, double* of) {
            for (std::int64_t cell = 0; cell < window.rows * window.columns; ++cell) of[cell] = tangent(of[cell]);
        };
        target = raster_in_place(grid, values, key.degrees() ? to_tangents : Change());
    }
    return zones;
}

}  // namespace frana::facade
