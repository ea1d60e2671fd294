// SPDX-License-Identifier: Apache-2.0
#include "params/scene/write_scene.h"

#include "params/keys/scene_parameters.h"
#include "scene_fixture.h"

namespace frana {
namespace {

using WriteScene = SceneFixture;

TEST_F(WriteScene, ReadingItBackGivesTheSameScene) {
    const SceneReading first = read(
        "[terrain]\ndtm = dtm.tif\ncell-size = 2.5\nbounds = 1 2.25, 3 4e3\n[release]\nperimeter = "
        "a.gpkg|layer=x\n"
        "thickness = raster:thick.tif\nthickness-direction = normal\ndtm-contains-release = "
        "on\n[material]\n"
        "preset = bindo\nfriction-coefficient = 0.1\nturbulence = off\n[numerics]\nwell-balanced = off\ncfl "
        "= 0.3\n"
        "[output]\nmaps = max_depth, max_depth_3d\n[scar]\nperimeter = s.shp\nthreshold = 0.7\n",
        {"numerics.minimum-depth=0.0123"});
    ASSERT_TRUE(first.problems.empty()) << describe(first.problems.list().front());
    const std::string path = write(scene_text(first.scene, {{"terrain.crs", "EPSG:32632"}}), "echo.ini");
    const SceneReading again = read_scene(path, {}, FRANA_SOURCE_SHARE);
    ASSERT_TRUE(again.problems.empty());
    for (const Parameter& parameter : scene_parameters())
        EXPECT_EQ(parameter.write(first.scene), parameter.write(again.scene)) << parameter.name();
}

TEST_F(WriteScene, NamesTheSourceOfEachValue) {
    const std::string text =
        scene_text(read(k_least + "preset = debris-flow\n", {"time.end=9"}).scene, {{"terrain.cell-size", "5"}});
    EXPECT_NE(text.find("[degrees] From: scene file\nfriction-angle = 20\n"), std::string::npos);
    EXPECT_NE(text.find("[m/s2] From: preset\nturbulence = 200\n"), std::string::npos);
    EXPECT_NE(text.find("[s] From: command line\nend = 9\n"), std::string::npos);
    EXPECT_NE(text.find("[m] From: default\nminimum-depth = 0.01\n"), std::string::npos);
    EXPECT_NE(text.find("[m] From: default; used: 5\n# cell-size = (the DTM's own)\n"), std::string::npos);
    // The preset's coefficient was replaced by the scene's angle: one of the two, never both.
    EXPECT_EQ(text.find("\nfriction-coefficient = "), std::string::npos);
}

}  // namespace
}  // namespace frana
