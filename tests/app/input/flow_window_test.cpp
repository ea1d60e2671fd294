// SPDX-License-Identifier: Apache-2.0
// Of a large DTM only the part below the energy line is read, if a law of the scene allows one.
#include "app/input/flow_window.h"

#include <algorithm>
#include <map>

#include "app/input/share_directory.h"
#include "gis/raster/raster_in.h"
#include "params/keys/laws.h"
#include "params/keys/material_parameters.h"
#include "params/keys/scene_parameters.h"
#include "support/files.h"
#include "support/tiny_scene.h"

namespace frana::test {
namespace {

class FlowWindow : public TinyScene {
  protected:
    FlowWindow() { write_scene(k_numbers_only); }
    [[nodiscard]] bool cuts(const std::vector<std::string>& sets) const {
        const SceneReading reading = read_scene(path("scene.ini"), sets, app::share_directory());
        const gis::RasterInfo dtm = gis::inspect_raster(path("dtm.asc"), "terrain.dtm");
        return app::flow_window(reading, dtm, dtm.crs_wkt).has_value();
    }
};

const std::string k_no_xi = "material.turbulence=off";

TEST_F(FlowWindow, IsCutByFrictionOnly) {
    EXPECT_TRUE(cuts({}));
    EXPECT_TRUE(cuts({"material.bed-friction=coulomb, ramms-yield", k_no_xi, "material.ramms-yield-stress=1000"}));
    EXPECT_TRUE(cuts({"material.bed-friction=pouliquen-forterre", k_no_xi, "material.fast-friction-angle=30",
                      "material.friction-length=1"}));
    EXPECT_FALSE(cuts({"material.bed-friction=ramms-yield", k_no_xi, "material.ramms-yield-stress=1000"}));
    // The angle is then the internal one's limit, not the bed's.
    EXPECT_FALSE(cuts({"material.bed-friction=turbulence", "material.in-plane-stress=earth-pressure",
                       "material.internal-friction-angle=30"}));
    EXPECT_FALSE(cuts({"terrain.friction-zones=perimeter.geojson", "zones.friction-angle=attribute:depth"}));
    EXPECT_FALSE(cuts({"material.pore-pressure-ratio=0.99"}));
}

// Every law specifies whether it bounds the run-out; the others never cut the terrain.
TEST_F(FlowWindow, IsCutAsEveryLawSpecifies) {
    for (const Law& law : laws()) {
        if (law.kind != LawKind::bed_friction) continue;
        std::vector<std::string> sets{"material.bed-friction=" + law.word, "material.cohesion=100", "material.chezy=20",
                                      "material.manning=0.1"};
        EXPECT_EQ(cuts(sets), law.resists_with_friction) << law.word;
    }
}

// Keys whose files give values by place, start or bound the flow elsewhere in flow_window.cpp, or are only drawn.
const std::vector<std::string> k_not_on_map{
    "terrain.dtm",      "release.perimeter",     "release.thickness",
    "inflow.line",      "inflow.hydrograph",     "structured.initial-fluid-depth",
    "structured.zones", "output.map-background", "output.map-logo",
    "hazard.scheme",    "output.exposure",       "material.friction-table",
    "material.forest"};  // all buildings of a canton, of which most are far away

bool is_value_by_place(const Parameter& key) {
    return key.section == "zones" || std::any_of(solid_keys().begin(), solid_keys().end(),
                                                 [&](const SolidKey& solid) { return solid.name == key.name(); });
}

// Whatever a key's file contains, polygons, lines, points or cells: the part of the terrain that is read contains it.
TEST_F(FlowWindow, ContainsTheFilesThatMustLieOnTheMap) {
    // 1 km east of the terrain's own cells: far beyond what the flow reaches.
    const double x = k_west + 1000, y = k_south + 60;
    const auto at = [&](double dx, double dy) { return std::to_string(x + dx) + " " + std::to_string(y + dy); };
    const std::map<std::string, std::string> shapes{
        {"polygon.gpkg", "POLYGON((" + at(0, 0) + "," + at(20, 0) + "," + at(20, 20) + "," + at(0, 0) + "))"},
        {"line.gpkg", "LINESTRING(" + at(0, 0) + "," + at(20, 20) + ")"},
        {"point.gpkg", "POINT(" + at(20, 20) + ")"}};
    for (const auto& [file, wkt] : shapes) gis::test::make_vector(path(file), "GPKG", "EPSG:32632", {wkt});
    gis::test::TestRaster cells;
    cells.columns = cells.rows = 4;
    cells.west = x;
    cells.north = y + 20;
    cells.cell_x = cells.cell_y = 5;
    cells.crs = "EPSG:32632";
    cells.values.assign(16, 1);
    gis::test::make_raster(path("cells.tif"), cells);

    const auto window = [&](const std::vector<std::string>& sets) {
        const SceneReading reading = read_scene(path("scene.ini"), sets, app::share_directory());
        const gis::RasterInfo dtm = gis::inspect_raster(path("dtm.asc"), "terrain.dtm");
        return app::flow_window(reading, dtm, dtm.crs_wkt);
    };
    ASSERT_LT(window({})->east, x);
    for (const Parameter& key : scene_parameters()) {
        if (!key.reads_files() || is_value_by_place(key)) continue;
        const bool listed = std::find(k_not_on_map.begin(), k_not_on_map.end(), key.name()) != k_not_on_map.end();
        EXPECT_NE(key.is_on_map, listed) << key.name();
        // Zones are values by place, for which nothing is cut.
        if (!key.is_on_map || key.name() == "terrain.friction-zones") continue;
        for (const char* file : {"polygon.gpkg", "line.gpkg", "point.gpkg", "cells.tif"}) {
            const auto found = window({key.name() + "=" + file});
            ASSERT_TRUE(found) << key.name() << " " << file;
            EXPECT_GE(found->east, x + 20) << key.name() << " " << file;
        }
    }
}

}  // namespace
}  // namespace frana::test
