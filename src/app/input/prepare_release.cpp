// SPDX-License-Identifier: Apache-2.0
#include "app/input/prepare_release.h"

#include <algorithm>
#include <cmath>

#include "app/input/check_release.h"
#include "app/input/layer_choice.h"
#include "app/input/layer_values.h"
#include "app/input/release_areas.h"
#include "app/input/thickness_on_demand.h"
#include "app/input/thickness_volume.h"
#include "app/input/transform_report.h"
#include "app/input/zones_on_demand.h"
#include "app/text/number_text.h"
#include "core/shortest_text.h"
#include "core/words/words.h"
#include "gis/crs/crs.h"
#include "gis/raster/rasterize.h"

namespace frana::app {
namespace {

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
                       const gis::RasterInfo& info, const std::string& where) {
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

/// Returns the thickness raster on the working grid: the file itself, the sum of two, or the positive part of before
/// minus after or of the ground minus the slip surface.
std::optional<Raster> thickness_raster(const SceneReading& reading, const ThicknessSpec& spec,
                                       const TerrainInput* ground, ReleaseInput& release, std::vector<UsedFile>& files,
                                       RunLog& log, Problems& problems) {
    const std::string where = reading.where("release.thickness");
    // A thickness has its own unit; the others contain elevations.
    const bool elevations = spec.kind != ThicknessSpec::Kind::raster && spec.kind != ThicknessSpec::Kind::phases;
    const std::string unit = elevations ? reading.scene.terrain.vertical_unit : "auto";
    const std::optional<double> nodata = elevations ? reading.scene.terrain.nodata_value : std::nullopt;
    std::vector<std::string> names{spec.raster};
    if (!spec.post.empty()) names.push_back(spec.post);
    std::vector<Raster> rasters;
    std::vector<std::shared_ptr<const gis::RasterOnDemand>> unread;
    for (const std::string& file : names) {
        try {
            gis::RasterInfo info = gis::inspect_raster(file, where);
            if (reading.scene.release.thickness_crs) {
                info.crs_wkt =
                    gis::crs_from_user(*reading.scene.release.thickness_crs, reading.where("release.thickness-crs"));
                info.crs_label = gis::crs_name(info.crs_wkt);
            }
            if (ground == nullptr) continue;
            const bool local = ground->terrain.grid.crs_wkt.empty();
            if (!local && info.crs_wkt.empty()) {
                problems.add({"has no coordinate reference system", where, file, "",
                              "State it with release.thickness-crs = EPSG:..."});
                continue;
            }
            gis::RasterRead read;
            if (ground->on_demand) {
                unread.push_back(std::make_shared<const gis::RasterOnDemand>(
                    file, ground->terrain.grid, info.crs_wkt, gis::Resampling::automatic, unit, nodata, where));
                read = unread.back()->known();
            } else {
                read = gis::read_raster_on(file, ground->terrain.grid, info.crs_wkt, gis::Resampling::automatic, unit,
                                           nodata, where);
            }
            log.warn_of(worded("thickness"), read.warnings);
            report_transform(worded("thickness {1}", {file}), read.transform, ground->terrain.grid.cell_size, log);
            log.note("thickness " + file + ": resampling " + read.resampling_used);
            release.rasters.push_back(info);
            files.push_back(used_raster(worded("Release thickness"), info, read));
            if (ground->on_demand) do_not_count_nodata(files.back());
            if (ground->on_demand && spec.kind == ThicknessSpec::Kind::phases)
                read.raster = phase_on_demand(ground->terrain.grid, unread.back(), info, where);
            rasters.push_back(std::move(read.raster));
        } catch (const Error& error) {
            problems.add(error);
        }
    }
    if (rasters.size() != names.size()) return std::nullopt;
    if (ground->on_demand && spec.kind == ThicknessSpec::Kind::phases)
        return sum_of_phases(rasters[0], rasters[1], release);
    if (ground->on_demand && spec.kind == ThicknessSpec::Kind::difference)
        release.before = raster_values_on_demand(ground->terrain.grid, unread[0], [](double z) { return z; });
    if (ground->on_demand) return thickness_on_demand(spec.kind, ground->terrain.grid, unread, ground->on_demand);
    if (spec.kind == ThicknessSpec::Kind::raster) return std::move(rasters.front());
    if (spec.kind == ThicknessSpec::Kind::phases) {
        for (std::size_t i = 0; i < names.size(); ++i) {
            const double least =
                *std::min_element(rasters[i].values.begin(), rasters[i].values.end(),
                                  [](double a, double b) { return (std::isnan(a) ? 0 : a) < (std::isnan(b) ? 0 : b); });
            if (!(least < 0)) continue;
            problems.add({k_negative_depth, where, names[i] + ": " + shortest_text(least) + " m", "0 or more",
                          "Correct the raster"});
            return std::nullopt;
        }
        return sum_of_phases(rasters[0], rasters[1], release);
    }
    const Raster& above = spec.kind == ThicknessSpec::Kind::difference ? rasters[0] : ground->terrain;
    const Raster& below = spec.kind == ThicknessSpec::Kind::difference ? rasters[1] : rasters[0];
    Raster thickness(above.grid);
    for (std::size_t i = 0; i < thickness.values.size(); ++i) {
        const double lowered = above.values[i] - below.values[i];
        thickness.values[i] = std::isnan(lowered) ? k_no_data : std::max(lowered, 0.0);
    }
    if (spec.kind == ThicknessSpec::Kind::difference) release.before = std::move(rasters[0]);
    return thickness;
}

void read_perimeter(const SceneReading& reading, const TerrainInput* ground, std::vector<UsedFile>& files, RunLog& log,
                    Problems& problems, ReleaseInput& release) {
    if (!reading.scene.release.perimeter) return;
    try {
        release.perimeter = gis::read_polygons(
            *reading.scene.release.perimeter, target_crs(reading, ground), reading.where("release.perimeter"),
            layer_choice(reading, reading.scene.release.perimeter_layer, "release.perimeter"));
    } catch (const Error& error) {
        problems.add(error);
        return;
    }
    const gis::PolygonLayer& layer = *release.perimeter;
    files.push_back(used_polygons(worded("Release perimeter"), *reading.scene.release.perimeter, layer));
    log.note("perimeter " + *reading.scene.release.perimeter + ": " + std::to_string(layer.features.size()) +
             " features in " + (layer.crs_label.empty() ? "plain metres" : layer.crs_label));
    log.warn_of(worded("perimeter"), layer.warnings);
    if (ground != nullptr) report_transform(worded("perimeter"), layer.transform, ground->terrain.grid.cell_size, log);
}

}  // namespace

ReleaseInput prepare_release(const SceneReading& reading, const TerrainInput* ground, std::vector<UsedFile>& files,
                             RunLog& log, Problems& problems) {
    ReleaseInput release;
    read_perimeter(reading, ground, files, log, problems, release);
    if (!reading.scene.release.thickness) return release;  // reported when the scene was read
    const ThicknessSpec& spec = *reading.scene.release.thickness;
    if (spec.by_raster()) {
        std::optional<Raster> thickness = thickness_raster(reading, spec, ground, release, files, log, problems);
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
        release.areas = areas_above_slip_surfaces(reading, *release.perimeter, ground->terrain, log, problems);
    } else if (release.perimeter) {
        release.areas = areas_by_feature(reading, *release.perimeter, problems);
    }
    for (const ReleaseArea& area : release.areas) release.area_m2 += frana::area(area.outline);
    if (ground != nullptr) {
        check_release(reading, *ground, release, log, problems);
        release.before.reset();
        // What was read on demand is that under the outlines, which were looked at just now.
        if (ground->on_demand && spec.by_raster() && !release.areas.empty())
            files.back().checksum.add(*release.areas.front().thickness_raster);
        // Interpolated at its edge, a raster would lose volume; the released volume is that of the file.
        if (problems.empty() && spec.kind == ThicknessSpec::Kind::raster && !reading.scene.release.volume)
            match_file_volume(release, ground->terrain.grid, files.back());
    }
    return release;
}

}  // namespace frana::app
