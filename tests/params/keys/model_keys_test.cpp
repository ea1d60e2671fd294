// SPDX-License-Identifier: Apache-2.0
#include "params/keys/laws.h"

#include "params/keys/scene_parameters.h"
#include "params/scene/write_scene.h"
#include "physics/laws.h"
#include "scene_fixture.h"

namespace frana {
namespace {

using ModelKeys = SceneFixture;

const std::string k_fluid =
    "[terrain]\ndtm = dtm.tif\n[release]\nperimeter = area.shp\nthickness = 2\n[material]\nmodel = "
    "structured\n"
    "[structured]\nphases = fluid\n";
const std::string k_solids =
    "[terrain]\ndtm = dtm.tif\n[release]\nperimeter = area.shp\nthickness = 2\n[material]\nmodel = "
    "structured\n"
    "[numerics]\nparticles-per-cell = 9\n[structured]\nphases = solids-and-fluid\ncohesion = 1e4\n"
    "internal-friction-angle = 28\n";

TEST_F(ModelKeys, StructuredScenesNeedNoFrictionAndNameTheirPhases) {
    EXPECT_TRUE(no_problem(problems(k_fluid)));
    EXPECT_TRUE(no_problem(problems(k_solids)));
    EXPECT_TRUE(has_problem(
        problems("[terrain]\ndtm = d\n[release]\nperimeter = a\nthickness = 2\n[material]\nmodel = structured\n"),
        "structured.phases", "", "fluid, solids-and-fluid"));
}

TEST_F(ModelKeys, EachModelRefusesTheOthersKeysByName) {
    const std::vector<const char*> keys{"material.density", "zones.turbulence",       "entrainment.erosion",
                                        "numerics.scheme",  "terrain.friction-zones", "material.preset"};
    const std::vector<Problem> all =
        problems(k_fluid, {"material.density=2000", "zones.turbulence=raster:x.tif", "entrainment.erosion=growth",
                           "numerics.scheme=paper", "terrain.friction-zones=z.shp", "material.preset=mudflow"});
    for (const char* key : keys) EXPECT_TRUE(has_problem(all, key));
    EXPECT_EQ(all.size(), keys.size()) << "what the preset brought is not named";
    EXPECT_TRUE(has_problem(problems(k_least + "[structured]\nmanning = 0.05\n"), "structured.manning"));
}

TEST_F(ModelKeys, SolidsNeedStrengthAndNeighbours) {
    const std::vector<Problem> all = problems(k_fluid, {"structured.phases=solids-and-fluid"});
    EXPECT_TRUE(has_problem(all, "structured.cohesion"));
    EXPECT_TRUE(has_problem(all, "structured.internal-friction-angle"));
    EXPECT_TRUE(has_problem(all, "numerics.particles-per-cell", "4", "9, 16"));
    EXPECT_TRUE(has_problem(problems(k_solids, {"structured.bulk-modulus=1e6"}), "structured.young-modulus",
                            "1.2e+07 Pa", "less than 9 times structured.bulk-modulus, 9e+06 Pa"));
}

TEST_F(ModelKeys, SolidsReadTheirMaterialByPlace) {
    EXPECT_TRUE(no_problem(problems(k_solids, {"structured.zones=lithology.gpkg", "structured.cohesion=attribute:c",
                                               "structured.solid-fraction=raster:alpha.tif", "release.start=3",
                                               "structured.initial-fluid-depth=raster:lake.tif"})));
    EXPECT_TRUE(has_problem(problems(k_solids, {"structured.solid-fraction=1.5"}), "structured.solid-fraction", "1.5"));
    EXPECT_TRUE(no_problem(problems(k_solids, {"release.thickness=phases:solids.tif,fluid.tif"})));
    EXPECT_TRUE(has_problem(problems(k_fluid, {"release.thickness=phases:solids.tif,fluid.tif"}), "release.thickness"));
    EXPECT_TRUE(has_problem(problems(k_solids, {"release.thickness=phases:solids.tif"}), "release.thickness",
                            "phases:solids.tif"));
    EXPECT_TRUE(has_problem(problems(k_fluid, {"output.formats=particles-gpkg"}), "output.formats", "particles-gpkg"));
}

TEST_F(ModelKeys, SolidsReadPorePressure) {
    EXPECT_TRUE(
        no_problem(problems(k_solids, {"material.pore-pressure-ratio=0.4", "material.hydraulic-diffusivity=1e-3",
                                       "material.compressibility=1e-6", "material.critical-solid-fraction=0.55"})));
    EXPECT_TRUE(has_problem(problems(k_fluid, {"material.pore-pressure-ratio=0.4"}), "material.pore-pressure-ratio"));
    // What [structured] has of its own.
    EXPECT_TRUE(has_problem(problems(k_solids, {"material.pore-pressure-ratio=0.4", "material.pore-fluid-density=1000",
                                                "material.pore-dissipation-time=5"}),
                            "material.pore-fluid-density"));
    EXPECT_TRUE(
        has_problem(problems(k_solids, {"material.compressibility=1e-6", "material.critical-solid-fraction=0.55",
                                        "material.solid-fraction=0.5"}),
                    "material.solid-fraction"));
    // Without effect or incomplete.
    EXPECT_TRUE(
        has_problem(problems(k_solids, {"material.hydraulic-diffusivity=1"}), "material.hydraulic-diffusivity"));
    EXPECT_TRUE(has_problem(problems(k_solids, {"material.compressibility=1e-6"}), "material.compressibility"));
    EXPECT_TRUE(
        has_problem(problems(k_solids, {"material.pore-pressure-ratio=0.4", "material.hydraulic-diffusivity=1e-3",
                                        "material.pore-dissipation-time=5"}),
                    "material.pore-dissipation-time"));
}

TEST_F(ModelKeys, TheEchoContainsOnlyWhatTheModelReads) {
    for (const std::string& scene : {k_fluid + "manning = 0.03\n", k_solids + "drag-exponent = 1\n"}) {
        const SceneReading first = read(scene);
        const std::string text = scene_text(first.scene, {});
        EXPECT_EQ(text.find("friction-coefficient"), std::string::npos);
        EXPECT_EQ(text.find("[entrainment]"), std::string::npos);
        const SceneReading again = read_scene(write(text, "echo.ini"), {}, FRANA_SOURCE_SHARE);
        ASSERT_TRUE(again.problems.empty()) << describe(again.problems.list().front());
        for (const Parameter& parameter : scene_parameters())
            EXPECT_EQ(parameter.write(first.scene), parameter.write(again.scene)) << parameter.name();
    }
}

TEST(CourantNumber, IsSmallerWhereStepsAreOfFirstOrder) {
    const auto number = [](const auto& change) {
        SceneSpec scene;
        change(scene);
        return courant_number(scene.numerics, scene.material);
    };
    EXPECT_EQ(number([](SceneSpec&) {}), 0.8);
    EXPECT_EQ(number([](SceneSpec& scene) { scene.numerics.scheme = Scheme::paper; }), 0.5);
    EXPECT_EQ(number([](SceneSpec& scene) { scene.material.model = "structured"; }), 0.9);
    EXPECT_EQ(number([](SceneSpec& scene) { scene.material.of<BinghamStress>().yield_stress = 100; }), 0.8);
    EXPECT_EQ(number([](SceneSpec& scene) { scene.numerics.cfl = 0.3; }), 0.3);
}

}  // namespace
}  // namespace frana
