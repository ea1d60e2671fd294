// SPDX-License-Identifier: Apache-2.0
#include "params/keys/laws.h"

#include "params/keys/scene_parameters.h"
#include "params/scene/write_scene.h"
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
    EXPECT_EQ(messages(k_fluid), "");
    EXPECT_EQ(messages(k_solids), "");
    EXPECT_NE(messages("[terrain]\ndtm = d\n[release]\nperimeter = a\nthickness = 2\n[material]\nmodel = structured\n")
                  .find("structured.phases: is missing"),
              std::string::npos);
}

TEST_F(ModelKeys, EachModelRefusesTheOthersKeysByName) {
    const std::string all =
        messages(k_fluid, {"material.density=2000", "zones.turbulence=raster:x.tif", "entrainment.erosion=growth",
                           "numerics.scheme=paper", "terrain.friction-zones=z.shp", "material.preset=mudflow"});
    for (const char* key : {"material.density", "zones.turbulence", "entrainment.erosion", "numerics.scheme",
                            "terrain.friction-zones", "material.preset"})
        EXPECT_NE(all.find(std::string(key) + ": is given, but material.model = structured does not use it"),
                  std::string::npos)
            << key << " in\n"
            << all;
    EXPECT_EQ(all.find("material.yield-stress"), std::string::npos) << "what the preset brought is not named\n" << all;
    EXPECT_NE(messages(k_least + "[structured]\nmanning = 0.05\n")
                  .find("structured.manning: is given, but material.model = voellmy-bingham does not use it"),
              std::string::npos);
}

TEST_F(ModelKeys, FluidAloneRefusesKeysOfSolids) {
    EXPECT_NE(messages(k_fluid + "cohesion = 1e4\n").find("structured.phases = fluid does not use it"),
              std::string::npos);
    EXPECT_EQ(
        messages(k_fluid + "manning = 0.03\nfluid-viscosity = 0.001\ndry-depth = 1e-5\nvelocity-profile-factor = 2\n"),
        "");
}

TEST_F(ModelKeys, SolidsNeedStrengthAndNeighbours) {
    const std::string all = messages(k_fluid, {"structured.phases=solids-and-fluid"});
    for (const char* words : {"structured.cohesion: is missing", "structured.internal-friction-angle: is missing",
                              "numerics.particles-per-cell: is too small"})
        EXPECT_NE(all.find(words), std::string::npos) << words << " in\n" << all;
    EXPECT_NE(messages(k_solids, {"structured.bulk-modulus=1e6"}).find("structured.young-modulus"), std::string::npos);
    EXPECT_NE(messages(k_solids, {"structured.drag-exponent=1.5"}).find("1, 2"), std::string::npos);
}

TEST_F(ModelKeys, SolidsReadTheirMaterialByPlace) {
    EXPECT_EQ(messages(k_solids, {"structured.zones=lithology.gpkg", "structured.cohesion=attribute:c",
                                  "structured.solid-fraction=raster:alpha.tif", "structured.placement=r2",
                                  "release.start=3", "structured.initial-fluid-depth=raster:lake.tif"}),
              "");
    EXPECT_NE(messages(k_solids, {"structured.solid-fraction=1.5"}).find("structured.solid-fraction: is out of range"),
              std::string::npos);
    EXPECT_EQ(messages(k_solids, {"release.thickness=phases:solids.tif,fluid.tif"}), "");
    EXPECT_NE(
        messages(k_fluid, {"release.thickness=phases:solids.tif,fluid.tif"}).find("gives solids and fluid separately"),
        std::string::npos);
    EXPECT_NE(messages(k_solids, {"release.thickness=phases:solids.tif"}).find("is not understood"), std::string::npos);
    EXPECT_NE(messages(k_fluid, {"output.formats=particles-gpkg"}).find("fluid alone has no particles"),
              std::string::npos);
}

TEST_F(ModelKeys, StepsAndFormsNotAvailableForFluid) {
    EXPECT_NE(messages(k_fluid, {"numerics.cfl=0.9"}).find("numerics.cfl"), std::string::npos);
    EXPECT_NE(messages(k_fluid, {"numerics.slope-correction=surface"}).find("numerics.slope-correction"),
              std::string::npos);
}

TEST_F(ModelKeys, TheEchoContainsOnlyWhatTheModelReads) {
    for (const std::string& scene : {k_fluid + "manning = 0.03\n", k_solids + "drag-exponent = 1\n"}) {
        const SceneReading first = read(scene);
        const std::string text = scene_text(first.scene, {});
        EXPECT_EQ(text.find("friction-coefficient"), std::string::npos);
        EXPECT_EQ(text.find("[entrainment]"), std::string::npos);
        const SceneReading again = read_scene(write(text, "echo.ini"), {}, FRANA_SOURCE_SHARE "/materials");
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
    EXPECT_EQ(number([](SceneSpec& scene) { scene.material.model = "structured"; }), 0.5);
    EXPECT_EQ(number([](SceneSpec& scene) { scene.material.yield_stress = 100; }), 0.5);
    EXPECT_EQ(number([](SceneSpec& scene) { scene.numerics.cfl = 0.3; }), 0.3);
}

}  // namespace
}  // namespace frana
