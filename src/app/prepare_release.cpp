// SPDX-License-Identifier: Apache-2.0
#include "app/prepare_release.h"

#include <cmath>

#include "app/check_release.h"
#include "app/layer_choice.h"
#include "app/number_text.h"
#include "app/thickness_volume.h"
#include "app/transform_report.h"
#include "core/json.h"
#include "gis/crs.h"
#include "gis/rasterize.h"

namespace frana::app {
namespace {

using Kind = ThicknessSpec::Kind;

/// The working CRS; geographic coordinates stand in where the ground is not known, so that the file is still
/// checked.
std::string target_crs(const SceneReading& reading, const TerrainInput* ground) {
    if (ground != nullptr) return ground->terrain.grid.crs_wkt;
    return reading.scene.terrain.crs == "local" ? "" : gis::crs_from_user("EPSG:4326", "");
}

/// The thickness raster on the working grid: the file itself, or the positive part of before less after.
std::optional<Raster> thickness_raster(const SceneReading& reading, const ThicknessSpec& spec,
                                       const TerrainInput* ground, ReleaseInput& release, RunLog& log,
                                       Problems& problems) {
    const std::string where = reading.where("release.thickness");
    // The two of a difference are terrain models; a thickness has its own unit.
    const bool terrain_models = spec.kind == Kind::difference;
    const std::string unit = terrain_models ? reading.scene.terrain.vertical_unit : "auto";
    const std::optional<double> nodata = terrain_models ? reading.scene.terrain.nodata_value : std::nullopt;
    std::vector<std::string> files{spec.raster};
    if (spec.kind == Kind::difference) files.push_back(spec.post);
    std::vector<Raster> rasters;
    for (const std::string& file : files) {
        try {
            gis::RasterInfo info = gis::inspect_raster(file, where);
            if (reading.scene.release.thickness_crs) {
                info.crs_wkt = gis::crs_from_user(*reading.scene.release.thickness_crs,
                                                  reading.where("release.thickness-crs"));
                info.crs_label = gis::crs_name(info.crs_wkt);
            }
            release.thickness_files.push_back(info);
            if (ground == nullptr) continue;
            const bool local = ground->terrain.grid.crs_wkt.empty();
            if (!local && info.crs_wkt.empty()) {
                problems.add({"has no coordinate reference system", where, file, "",
                              "Say which one it is in with release.thickness-crs = EPSG:..."});
                continue;
            }
            gis::RasterRead read = gis::read_raster_on(file, ground->terrain.grid, info.crs_wkt,
                                                       gis::Resampling::automatic, unit, nodata, where);
            for (const std::string& warning : read.warnings) log.warn("thickness: " + warning);
            report_transform("thickness " + file, read.transform, ground->terrain.grid.cell_size, log);
            log.note("thickness " + file + ": resampling " + read.resampling_used);
            release.thickness_uses.push_back({info, read.transform, read.resampling_used, read.nodata_cells});
            rasters.push_back(std::move(read.raster));
        } catch (const Error& error) {
            problems.add(error);
        }
    }
    if (rasters.size() != files.size()) return std::nullopt;
    Raster thickness = std::move(rasters.front());
    if (spec.kind == Kind::difference) {
        for (std::size_t i = 0; i < thickness.values.size(); ++i) {
            const double lowered = thickness.values[i] - rasters[1].values[i];
            thickness.values[i] = std::isnan(lowered) ? k_no_data : std::max(lowered, 0.0);
        }
    }
    return thickness;
}

/// One area per feature, its thickness the scene's number or the feature's own attribute.
std::vector<ReleaseArea> areas_by_feature(const SceneReading& reading, const ThicknessSpec& spec,
                                          const gis::PolygonLayer& layer, Problems& problems) {
    const std::string where = reading.where("release.thickness");
    std::vector<ReleaseArea> areas;
    for (std::size_t i = 0; i < layer.features.size(); ++i) {
        const PolygonFeature& feature = layer.features[i];
        const std::string name = "feature " + std::to_string(i + 1) + " of " + layer.layer_name;
        ReleaseArea area;
        area.outline = feature.parts;
        area.thickness = spec.metres;
        if (spec.kind == Kind::attribute) {
            const auto found = feature.numbers.find(spec.attribute);
            if (found == feature.numbers.end()) {
                std::string known;
                for (const auto& number : feature.numbers)
                    known += (known.empty() ? "" : ", ") + number.first;
                problems.add({name + " has no number in the attribute " + spec.attribute, where, "",
                              known.empty() ? "the layer has no numeric attribute" : known,
                              "Name one of its attributes"});
                continue;
            }
            area.thickness = found->second;
            if (!(area.thickness > 0) || !std::isfinite(area.thickness)) {
                problems.add({name + " has a thickness that is not positive", where,
                              shortest_text(area.thickness) + " m", "greater than 0",
                              "Correct the attribute " + spec.attribute});
                continue;
            }
        }
        areas.push_back(std::move(area));
    }
    return areas;
}

void read_perimeter(const SceneReading& reading, const TerrainInput* ground, RunLog& log, Problems& problems,
                    ReleaseInput& release) {
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
    log.note("perimeter " + *reading.scene.release.perimeter + ": " + std::to_string(layer.features.size()) +
             " features in " + (layer.crs_label.empty() ? "plain metres" : layer.crs_label));
    for (const std::string& warning : layer.warnings) log.warn("perimeter: " + warning);
    if (ground != nullptr)
        report_transform("perimeter", layer.transform, ground->terrain.grid.cell_size, log);
}

}  // namespace

ReleaseInput prepare_release(const SceneReading& reading, const TerrainInput* ground, RunLog& log,
                             Problems& problems) {
    ReleaseInput release;
    read_perimeter(reading, ground, log, problems, release);
    if (!reading.scene.release.thickness) return release;  // reported when the scene was read
    const ThicknessSpec& spec = *reading.scene.release.thickness;
    const bool by_raster = spec.kind == Kind::raster || spec.kind == Kind::difference;

    if (by_raster) {
        std::optional<Raster> thickness = thickness_raster(reading, spec, ground, release, log, problems);
        if (!thickness || (reading.scene.release.perimeter && !release.perimeter)) return release;
        ReleaseArea area;
        if (release.perimeter) {
            for (const PolygonFeature& feature : release.perimeter->features)
                area.outline.insert(area.outline.end(), feature.parts.begin(), feature.parts.end());
        } else {
            Raster positive(thickness->grid);
            for (std::size_t i = 0; i < positive.values.size(); ++i)
                positive.values[i] = thickness->values[i] > 0;
            area.outline = gis::polygonise(positive);
        }
        area.thickness_raster = std::move(thickness);
        release.areas.push_back(std::move(area));
    } else if (release.perimeter) {
        release.areas = areas_by_feature(reading, spec, *release.perimeter, problems);
    }
    for (ReleaseArea& area : release.areas) {
        area.normal_to_bed = reading.scene.release.thickness_direction == "normal";
        release.area_m2 += frana::area(area.outline);
    }
    if (ground != nullptr) {
        check_release(reading, *ground, release, log, problems);
        if (problems.empty()) release.file_volume_m3 = thickness_volume(release, ground->terrain.grid);
        // Interpolated at the rim, a raster would lose volume; what the file holds is what is released.
        if (release.file_volume_m3) release.areas.front().volume = release.file_volume_m3;
    }
    return release;
}

}  // namespace frana::app
