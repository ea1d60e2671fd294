// SPDX-License-Identifier: Apache-2.0
#include "app/input/check_inputs.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <utility>
#include <vector>

#include "analysis/ground_statistics.h"
#include "analysis/runout.h"
#include "analysis/touched_cells.h"
#include "app/input/layer_values.h"
#include "app/input/survey_input.h"
#include "app/text/number_text.h"
#include "core/reached_raster.h"
#include "core/text.h"
#include "gis/raster/footprint.h"
#include "params/grammar/value_text.h"
#include "params/keys/laws.h"
#include "simulation/release.h"
#include "simulation/run_warnings.h"
#include "simulation/scene_values.h"

namespace frana::app {
namespace {

// A few cells suffice to locate the problem; all would hide the message.
constexpr int k_cells_named = 5;

/// Counts the covered cells that satisfy a test, and lists the first few by row, column and coordinates.
struct CellList {
    std::int64_t count = 0;
    std::vector<Sentence> first;
};

CellList cells_where(const Raster& cover, const std::function<bool(std::size_t)>& test) {
    CellList list;
    cover.values.for_each_stored([&](std::size_t cell, double covered) {
        if (covered == 0 || !test(cell) || ++list.count > k_cells_named) return;
        const std::int64_t row = static_cast<std::int64_t>(cell) / cover.grid.columns,
                           column = static_cast<std::int64_t>(cell) % cover.grid.columns;
        const Point centre = cover.grid.cell_centre(row, column);
        list.first.push_back(worded(
            "row {1} column {2} at {3}",
            {std::to_string(row), std::to_string(column), number_text(centre.x, 9) + ", " + number_text(centre.y, 9)}));
    });
    if (list.count > k_cells_named) list.first.emplace_back(std::string("..."));
    return list;
}

Sentence cells_of(const CellList& list) {
    return worded("cells: {1} ({2})", {numeral(grouped(list.count)), listed(list.first)});
}

void check_ground(const SceneReading& reading, const TerrainInput& ground, const Raster& cover, Problems& problems) {
    const CellList holes = cells_where(cover, [&](std::size_t i) { return std::isnan(ground.terrain.values[i]); });
    if (holes.count == 0) return;
    problems.add({"the DTM has no elevation under the release", reading.where("terrain.dtm"), cells_of(holes).text(),
                  "", "Repair the DTM, change the perimeter, or set terrain.nodata-policy = fill to interpolate"});
}

void check_thickness_raster(const SceneReading& reading, const Raster& thickness, const Raster& cover, Findings found,
                            Problems& problems) {
    const Place where = reading.where("release.thickness");
    const CellList negative = cells_where(cover, [&](std::size_t i) { return thickness.values[i] < 0; });
    if (negative.count > 0) {
        problems.add({"the thickness raster is negative inside the perimeter", where, cells_of(negative).text(),
                      "0 or more",
                      "A raster of after minus before has the wrong sign: use difference:PRE,POST or negate it"});
        return;
    }
    const CellList empty = cells_where(cover, [&](std::size_t i) { return std::isnan(thickness.values[i]); });
    const CellList filled = cells_where(cover, [&](std::size_t i) { return thickness.values[i] > 0; });
    if (filled.count == 0 && reading.scene.release.level) {
        problems.add({"nothing is released: the level lies below the ground of a polygon",
                      reading.where("release.level"), "", "", "Correct the level, its height system or the perimeter"});
    } else if (filled.count == 0) {
        problems.add({"nothing is released: the thickness raster is nowhere positive inside the perimeter", where, "",
                      "", "Check the raster's position and coordinate reference system"});
    } else if (empty.count > 0) {
        found.warn(worded("no thickness on part of the perimeter, nothing released: {1}", {cells_of(empty)}));
    }
}

/// A DTM of before the failure contains the release, one of after does not: the other choice would lay the mass on top
/// of itself, or dig it out of the ground that it has left.
void check_difference(const SceneReading& reading, const TerrainInput& ground, const ReleaseInput& release,
                      const Raster& cover, Findings found, Problems& problems) {
    constexpr double k_most_doubt = 0.25;
    if (!release.before || release.areas.empty() || !release.areas.front().thickness_raster) return;
    // How far the ground is from "after" towards "before", over the mass: 1 before, 0 after.
    const Raster& thickness = *release.areas.front().thickness_raster;
    double above = 0, all = 0;
    cover.values.for_each_stored([&](std::size_t cell, double covered) {
        const double t = thickness.values[cell];
        if (covered == 0 || !(t > 0)) return;
        const double after = release.before->values[cell] - t, z = ground.terrain.values[cell];
        if (std::isnan(after) || std::isnan(z)) return;
        above += (z - after) * t;
        all += t * t;
    });
    if (!(all > 0)) return;
    const double fraction = above / all;
    const bool contains = reading.scene.release.dtm_contains_release;
    const Place where = reading.where("release.dtm-contains-release");
    if (!contains && std::abs(fraction - 1) < k_most_doubt) {
        problems.add(
            {"would lay the release on top of the slope that contains it: the DTM is that of before the failure", where,
             "off", "on", "Set it to on, or take the DTM of after the failure as terrain.dtm"});
    } else if (contains && std::abs(fraction) < k_most_doubt) {
        problems.add({"would dig the release out of ground that it has left: the DTM is that of after the failure",
                      where, "on", "off", "Set it to off, or take the DTM of before the failure as terrain.dtm"});
    } else if (std::abs(fraction - (contains ? 1 : 0)) > k_most_doubt) {
        found.warn(worded("DTM {1} % from after to before failure: check position and datum",
                          {numeral(number_text(100 * fraction, 3))}));
    }
}

/// Areas whose thickness rasters must be checked: a raster file is common to all, a fitted surface belongs to one area.
std::vector<const ReleaseArea*> different_rasters(const SceneReading& reading, const ReleaseInput& release) {
    std::vector<const ReleaseArea*> areas;
    for (const ReleaseArea& area : release.areas) {
        if (!area.thickness_raster) continue;
        areas.push_back(&area);
        if (!area.level && !reading.scene.release.thickness->fitted()) break;
    }
    return areas;
}

// The thickest landslides have an eighth of their width where they are deepest, and less than a tenth on average.
constexpr double k_thick = 30, k_of_width = 0.25, k_thick_mean = 20, k_mean_of_width = 0.1;

/// Warns of a raster that is unusually thick for its width.
void question_raster(std::vector<double> thicknesses, double width, Findings found) {
    constexpr double k_over_median = 20;  // part of a rim of values that mean no data, also where a volume scales all
    if (thicknesses.empty()) return;
    const double greatest = *std::max_element(thicknesses.begin(), thicknesses.end()),
                 median = percentile(std::move(thicknesses), 0.5);
    if (greatest > k_over_median * median)
        found.warn(worded("release up to {1} m thick, median {2} m: declare nodata",
                          {numeral(number_text(greatest, 3)), numeral(number_text(median, 3))}));
    if (!(greatest > std::max(k_thick, k_of_width * width))) return;
    const bool is_mark = std::abs(greatest - 255) < 1 || std::abs(greatest - 999) < 1;  // of no data
    found.warn(worded(is_mark ? worded("release up to {1} m thick: declare {1} as nodata")
                              : worded("release up to {1} m thick, {2} m wide: in cm?"),
                      {numeral(number_text(greatest, 3)), numeral(number_text(width, 3))}));
}

/// The same of the first area of one thickness; it may be the elevation of the ground there.
void question_mean(const ReleaseInput& release, const TerrainInput& ground, Findings found) {
    for (const ReleaseArea& one : release.areas) {
        const double width = std::sqrt(area(one.outline)), thickness = one.thickness;
        if (one.thickness_raster || one.volume || !(thickness > std::max(k_thick_mean, k_mean_of_width * width)))
            continue;
        double least = HUGE_VAL, greatest = -HUGE_VAL;
        gis::visit_cells(one.outline, ground.terrain.grid, gis::Cover::closed,
                         [&](std::int64_t row, std::int64_t column) {
                             least = std::min(least, std::as_const(ground.terrain).at(row, column));
                             greatest = std::max(greatest, std::as_const(ground.terrain).at(row, column));
                         });
        const bool is_elevation = thickness >= least && thickness <= greatest;
        const bool is_mm = thickness / 100 > k_mean_of_width * width;
        found.warn(worded(is_elevation ? worded("release {1} m thick: that is the ground's elevation")
                                       : worded("release {1} m thick, {2} m wide: if in {4}, write {3}"),
                          {numeral(number_text(thickness, 4)), numeral(number_text(width, 3)),
                           numeral(number_text(thickness / (is_mm ? 1000 : 100), 3)), is_mm ? "mm" : "cm"}));
        return;
    }
}

/// A volume and a thickness that differ by a power of ten; a thickness of 1 only stands for a shape.
void question_volume(const SourceSpec& given, const ReleaseInput& release, Findings found) {
    constexpr double k_least = 5, k_about = 0.097;  // 25 % off a power of ten: slopes, thickness along the normal
    double stated = 0, outlined = 0;
    for (const ReleaseArea& one : release.areas) {
        if (one.thickness_raster || one.thickness == 1) return;
        outlined += area(one.outline) * one.thickness;
        stated += one.volume.value_or(0);
    }
    if (given.kind == SourceSpec::Kind::number) stated = given.number;
    const double ratio = stated / outlined, decades = std::log10(ratio);
    if (!(std::max(ratio, 1 / ratio) > k_least) || std::abs(decades - std::round(decades)) > k_about) return;
    found.warn(worded(k_volume_warning, {numeral(number_text(std::pow(10, std::round(decades)), 3))}));
}

/// Refuses a thickness greater than that of any landslide: a raster of elevations, nodata that no file declares, a
/// volume in other units.
void check_greatest(const SceneReading& reading, const TerrainInput& ground, const ReleaseInput& release,
                    const MultiPolygon& outlines, const Raster& cover, Findings found, Problems& problems) {
    double least = k_most_thickness, greatest = 0, mean = 0;
    std::vector<double> of_raster;
    for (const ReleaseArea* release_area : different_rasters(reading, release)) {
        const Raster& raster = *release_area->thickness_raster;
        raster.values.for_each_stored([&](std::size_t cell, double thickness) {
            if (cover.values[cell] != 0) greatest = std::max(greatest, thickness);
        });
        // A rim is also in the cells that the outline only touches.
        gis::visit_cells(outlines, raster.grid, gis::Cover::closed, [&](std::int64_t row, std::int64_t column) {
            if (const double here = raster.at(row, column); here > 0) of_raster.push_back(here);
        });
    }
    for (const ReleaseArea& release_area : release.areas) {
        if (!release_area.thickness_raster) {
            least = std::min(least, release_area.thickness);
            greatest = std::max(greatest, release_area.thickness);
        }
        if (release_area.volume) mean = std::max(mean, *release_area.volume / area(release_area.outline));
    }
    const auto& volume = reading.scene.release.volume;
    if (volume && volume->kind == SourceSpec::Kind::number) mean = std::max(mean, volume->number / area(outlines));
    if (least < k_least_thickness) greatest = least;
    const bool level = reading.scene.release.level.has_value();
    if (greatest > 0) check_thickness(greatest, reading.where(level ? "release.level" : "release.thickness"), problems);
    if (problems.empty() && !level) question_raster(std::move(of_raster), std::sqrt(area(outlines)), found);
    if (problems.empty() && !volume) question_mean(release, ground, found);
    if (problems.empty() && volume) question_volume(*volume, release, found);
    if (mean > 0) check_thickness(mean, reading.where("release.volume"), problems);
}

/// Refuses elevations of the ground given as thicknesses.
void refuse_elevations(const SceneReading& reading, const TerrainInput& ground, const ReleaseInput& release,
                       const Raster& cover, Problems& problems) {
    constexpr double k_alike = 0.05, k_least_mean = 30;
    const auto& given = reading.scene.release.thickness;
    if (!given || !given->as_in_file()) return;
    double apart = 0, all = 0, cells = 0;
    for (const ReleaseArea* area : different_rasters(reading, release)) {
        cover.values.for_each_stored([&](std::size_t cell, double covered) {
            const double t = area->thickness_raster->values[cell], z = ground.terrain.values[cell];
            if (covered == 0 || !(t > 0) || std::isnan(z)) return;
            apart += std::abs(t - z);
            all += t;
            cells += 1;
        });
    }
    if (!(all > k_least_mean * cells) || apart > k_alike * all) return;
    problems.add({"contains elevations, no thicknesses", reading.where("release.thickness"),
                  number_text(all / cells, 4) + " m on average, as the DTM", "",
                  "Give the thickness, or the surfaces before and after: difference:PRE,POST"});
}

/// A lake ends at its shore but where its dam breaks: a level of another height system drowns the whole perimeter.
void question_level(const ReleaseInput& release, const TerrainInput& ground, Findings found) {
    constexpr double k_drowned = 0.25, k_deep = 0.5;  // of the perimeter; [m]
    double all = 0, drowned = 0;
    for (const ReleaseArea& one : release.areas) {
        for (std::size_t i = 0; one.level && i < one.outline.size(); ++i) {
            for (const Station& station : stations(one.outline[i].outer, ground.terrain.grid.cell_size)) {
                const double z = cell_value(ground.terrain, station.place);
                all += std::isnan(z) ? 0 : 1;
                drowned += *one.level - z > k_deep ? 1 : 0;
            }
        }
    }
    if (drowned > k_drowned * all)
        found.warn(worded("release.level is above {1} % of the perimeter: check it",
                          {numeral(number_text(100 * drowned / all, 2))}));
}

/// The least that a map shows is the release; the flow, of which nothing is known yet, needs more.
void check_map_scale(const SceneReading& reading, const MultiPolygon& outlines, Problems& problems) {
    const OutputSpec& output = reading.scene.output;
    std::optional<Size> page = size_from_text(output.map_size);
    if (!output.map_scale || !page || !is_paper(*page) || output.maps == std::vector<std::string>{"off"}) return;
    constexpr double k_inch = 0.0254;
    const Bounds box = bounds(outlines);
    page = size_for_ground(*page, box.width(), box.height());
    const double metre = page->dots_per_inch / k_inch;  // pixels on paper
    const double least = metre * std::max((box.east - box.west) / page->width, (box.north - box.south) / page->height);
    if (least <= *output.map_scale) return;
    problems.add({"not even the release fits " + page->paper + " at this scale", reading.where("output.map-scale"),
                  "1 : " + grouped(*output.map_scale), "more than 1 : " + grouped(std::ceil(least)),
                  "Choose a smaller scale with room for the flow, or remove the key for a round one"});
}

/// Polygons that overlap release their thickness twice.
void check_overlap(const SceneReading& reading, const ReleaseInput& release, const GridSpec& grid, Findings found,
                   Problems& problems) {
    if (release.areas.size() < 2) return;
    Raster times(grid);
    for (const ReleaseArea& area : release.areas) {
        gis::visit_cells(area.outline, grid, gis::Cover::centres,
                         [&](std::int64_t row, std::int64_t column) { times.at(row, column) += 1; });
    }
    const CellList twice = cells_where(times, [&](std::size_t i) { return times.values[i] > 1; });
    if (twice.count > 0 && reading.scene.release.level)
        problems.add({"polygons of still water overlap", reading.where("release.perimeter"), cells_of(twice).text(), "",
                      "Draw them apart: one level has no depth on top of another"});
    else if (twice.count > 0)
        found.warn(worded("polygons of the perimeter overlap, their thicknesses add up there: {1}", {cells_of(twice)}));
}

/// Where ground is read on demand the map may be far larger than the release.
Raster cover_of(const MultiPolygon& outlines, const Raster& ground) {
    Raster cover = ground.values.is_tiled() ? reached_raster(ground.grid, 0) : Raster(ground.grid, 0.0);
    gis::visit_cells(outlines, ground.grid, gis::Cover::centres,
                     [&](std::int64_t row, std::int64_t column) { cover.at(row, column) = 1; });
    return cover;
}

}  // namespace

MultiPolygon all_outlines(const ReleaseInput& release) {
    MultiPolygon all;
    for (const ReleaseArea& area : release.areas) all.insert(all.end(), area.outline.begin(), area.outline.end());
    return all;
}

void question_outline(const MultiPolygon& released, const MultiPolygon& outline, const GridSpec& grid,
                      const Place& where, Findings found) {
    constexpr double k_nearly = 0.8;  // of all cells of either; two surveyors differ by as much
    const auto cells_of = [&](const MultiPolygon& polygons) {
        std::vector<std::int64_t> cells;
        gis::visit_cells(polygons, grid, gis::Cover::centres,
                         [&](std::int64_t row, std::int64_t column) { cells.push_back(row * grid.columns + column); });
        std::sort(cells.begin(), cells.end());
        return cells;
    };
    const std::vector<std::int64_t> source = cells_of(released), observed = cells_of(outline);
    std::vector<std::int64_t> both;
    std::set_intersection(source.begin(), source.end(), observed.begin(), observed.end(), std::back_inserter(both));
    const auto all = static_cast<double>(source.size() + observed.size() - both.size());
    const double alike = all > 0 ? static_cast<double>(both.size()) / all : 0;
    if (alike > k_nearly)
        found.warn(worded("{1} matches the release to {2} %: give the whole event's outline",
                          {where.text, numeral(number_text(100 * alike, 3))}));
}

void check_release(const SceneReading& reading, const TerrainInput& ground, const ReleaseInput& release, Findings found,
                   Problems& problems) {
    const MultiPolygon outlines = all_outlines(release);
    if (outlines.empty()) {
        if (problems.empty())
            problems.add({"nothing is released", reading.where("release.thickness"), "", "",
                          "Check the thickness raster and its position"});
        return;
    }
    const char* const key = reading.scene.release.perimeter ? "release.perimeter" : "release.thickness";
    if (!is_on_ground(reading, key, bounds(outlines), ground, false, problems)) return;
    const Raster cover = cover_of(outlines, ground.terrain);
    check_ground(reading, ground, cover, problems);
    for (const ReleaseArea* area : different_rasters(reading, release))
        check_thickness_raster(reading, *area->thickness_raster, cover, found, problems);
    check_greatest(reading, ground, release, outlines, cover, found, problems);
    refuse_elevations(reading, ground, release, cover, problems);
    question_level(release, ground, found);
    check_map_scale(reading, outlines, problems);
    check_difference(reading, ground, release, cover, found, problems);
    check_overlap(reading, release, ground.terrain.grid, found, problems);
}

double released_area(const Scene& scene) {
    double all = 0;
    for (const ReleaseArea& one : scene.release) {
        if (!one.thickness_raster) all += area(one.outline);
        if (!one.thickness_raster) continue;
        gis::visit_cells(one.outline, scene.grid, gis::Cover::centres, [&](std::int64_t row, std::int64_t column) {
            all += std::as_const(*one.thickness_raster).at(row, column) > 0 ? scene.grid.cell_area() : 0;
        });
    }
    return all;
}

Warnings doubt_release(const Scene& scene) {
    if (scene.release.empty()) return {};
    const Release release = make_release(scene);
    Warnings warnings = thin_release_warnings(release.depth, scene);
    std::size_t particles = release.particles.size();
    for (const Entry& entry : release.later) particles += entry.particles.size();
    return warnings +=
           release_warnings(scene, release.bed, release.depth, release.areas, static_cast<std::int64_t>(particles));
}

namespace {

bool has_ground(const MixedShape& shape, const Raster& terrain) {
    const std::vector<std::size_t> cells = touched_cells(shape, terrain.grid);
    return cells.empty() ||
           std::any_of(cells.begin(), cells.end(), [&](std::size_t cell) { return !std::isnan(terrain.values[cell]); });
}

}  // namespace

Warnings doubt_exposure(const Prepared& prepared, bool on_ground) {
    const auto& layer = prepared.extra.exposure;
    if (!layer) return {};
    const Raster& terrain = prepared.scene.terrain;
    std::size_t unknown = 0;
    std::string first;
    for (const Feature& feature : layer->features) {
        const bool is_outside =
            feature.shape.empty() || place_of(feature.shape, prepared.scene.grid.bounds()) == MapPlace::outside;
        if (!is_outside && (!on_ground || terrain.values.is_tiled() || has_ground(feature.shape, terrain))) continue;
        if (unknown++ == 0) first = feature.name;
    }
    if (unknown == 0) return {};
    const auto whole = [](std::size_t count) { return numeral(grouped(static_cast<double>(count))); };
    return {worded("{1} of {2} exposed features not on mapped ground, first: {3}",
                   {whole(unknown), whole(layer->features.size()), first})};
}

std::optional<GroundStatistics> ground_of_release(const Scene& scene) {
    GroundSum sum(scene.terrain);
    for (const ReleaseArea& area : scene.release)
        for (const Polygon& polygon : area.outline)  // one at a time: memory is that of the window round it
            gis::visit_cells({polygon}, scene.grid, gis::Cover::centres,
                             [&](std::int64_t row, std::int64_t column) { sum.add(row, column); });
    return sum.statistics();
}

}  // namespace frana::app
