// SPDX-License-Identifier: Apache-2.0
// Of a large DTM only the part below the energy line is read, if a law of the scene allows one.
#include "app/input/flow_window.h"

#include "app/input/share_directory.h"
#include "gis/raster/raster_in.h"
#include "params/keys/laws.h"
#include "tiny_scene.h"

namespace frana::test {
namespace {

class FlowWindow : public TinyScene {
  protected:
    FlowWindow() { write_scene(k_numbers_only); }
    [[nodiscard]] bool cuts(const std::vector<std::string>& sets) const {
        const SceneReading reading = read_scene(path("scene.ini"), sets, app::materials_directory());
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

}  // namespace
}  // namespace frana::test
