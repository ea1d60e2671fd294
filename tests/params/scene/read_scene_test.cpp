// SPDX-License-Identifier: Apache-2.0
#include "params/scene/read_scene.h"
#include "params/grammar/ini_file.h"

#include <cmath>

#include "physics/laws.h"
#include "scene_fixture.h"

namespace frana {
namespace {

using ReadScene = SceneFixture;

TEST_F(ReadScene, LeastSceneIsEnoughAndDefaultsAreTheDeclaredOnes) {
    const SceneReading reading = read(k_least);
    EXPECT_TRUE(reading.problems.empty());
    EXPECT_EQ(reading.scene.terrain.dtm, (folder_ / "dtm.tif").string());
    EXPECT_EQ(reading.scene.release.perimeter, (folder_ / "area.shp").string());
    EXPECT_EQ(reading.scene.release.thickness->metres, 2);
    EXPECT_EQ(reading.scene.material.density, Material{}.density);
    EXPECT_EQ(reading.scene.origin_of("material.density"), Origin::default_value);
    EXPECT_EQ(reading.scene.origin_of("terrain.dtm"), Origin::scene_file);
    // tan 20 degrees = 0.36397023426620236 (twenty digits from tables); one rounding of pi and one of tan
    EXPECT_NEAR(reading.scene.material.of<CoulombFriction>().bed_friction_coefficient(), 0.36397023426620236, 1e-15);
}

TEST_F(ReadScene, EveryProblemInOnePass) {
    const std::vector<Problem> all = problems(
        "[terrain]\ncell-sise = 5\nnodata-policy = ignore\n[release]\nthickness = -3\n[material]\n"
        "density = heavy\nfriction-coefficient = 7\n[time]\nend = 0\n");
    EXPECT_TRUE(has_problem(all, "scene.ini: terrain.cell-sise"));
    EXPECT_EQ(all.front().remedy, "Did you mean terrain.cell-size?");
    EXPECT_TRUE(has_problem(all, "terrain.nodata-policy", "ignore", "stop, wall, fill"));
    EXPECT_TRUE(has_problem(all, "release.thickness", "-3"));
    EXPECT_TRUE(has_problem(all, "material.density", "heavy", "10 to 10000 [kg/m3]"));
    EXPECT_TRUE(has_problem(all, "material.friction-coefficient", "7", "0 to 2"));
    EXPECT_TRUE(has_problem(all, "time.end", "0"));
    EXPECT_TRUE(has_problem(all, "terrain.dtm"));
    EXPECT_TRUE(has_problem(all, "release.perimeter"));
    // One each: a key with an invalid value is present, not missing.
    EXPECT_EQ(all.size(), 8U);
}

TEST_F(ReadScene, AKeyThatMayBeMissingSaysWhatThenIs) {
    const std::vector<Problem> all = problems(k_least + "[observed]\nperimeter = a.shp\nperimeter-error = 0\n");
    ASSERT_EQ(all.size(), 1U);
    EXPECT_TRUE(has_problem(all, "observed.perimeter-error", "0", "0.001 to 1e+05 [m]"));
    EXPECT_EQ(all.front().remedy, "Without the key: the best agreement sets the scale");
}

TEST_F(ReadScene, LaterSourcesOverrideEarlierOnes) {
    const SceneReading from_preset = read(
        "[terrain]\ndtm = a\n[release]\nperimeter = b\nthickness = 1\n[material]\npreset = bindo\ndensity = "
        "1500\n");
    EXPECT_TRUE(from_preset.problems.empty());
    EXPECT_EQ(from_preset.scene.material.of<CoulombFriction>().friction_angle, 34);
    EXPECT_EQ(from_preset.scene.material.of<BinghamStress>().yield_stress, 50);
    EXPECT_EQ(from_preset.scene.material.density, 1500);
    EXPECT_EQ(from_preset.scene.origin_of("material.friction-angle"), Origin::preset);

    // The command line gives friction by the other key: it replaces, it does not contradict.
    const SceneReading overridden = read(k_least, {"material.friction-coefficient=0.25", "time.end = 12.5"});
    EXPECT_TRUE(overridden.problems.empty());
    EXPECT_FALSE(overridden.scene.material.of<CoulombFriction>().friction_angle);
    EXPECT_EQ(overridden.scene.material.of<CoulombFriction>().bed_friction_coefficient(), 0.25);
    EXPECT_EQ(overridden.scene.time.end, 12.5);
    EXPECT_EQ(overridden.scene.origin_of("time.end"), Origin::command_line);
}

TEST_F(ReadScene, UnknownPresetNamesThePresets) {
    EXPECT_TRUE(
        has_problem(problems(k_least + "preset = bindoo\n"), "material.preset", "bindoo",
                    "bindo, debris-flow, earthflow, lahar, mudflow, rock-avalanche, snow-avalanche, snow-slab"));
    const std::string longer_than_file_names(300, 'x');
    EXPECT_TRUE(has_problem(problems(k_least + "preset = " + longer_than_file_names + "\n"), "material.preset"));
}

TEST_F(ReadScene, SlopeCorrectionFollowsTheScheme) {
    EXPECT_EQ(slope_correction(read(k_least).scene.numerics), SlopeCorrection::normal);
    EXPECT_EQ(slope_correction(read(k_least + "[numerics]\nscheme = paper\n").scene.numerics), SlopeCorrection::none);
    EXPECT_EQ(
        slope_correction(read(k_least + "[numerics]\nscheme = paper\nslope-correction = surface\n").scene.numerics),
        SlopeCorrection::surface);
    EXPECT_TRUE(has_problem(problems(k_least + "[numerics]\nscheme = paper\nwell-balanced = on\n"),
                            "numerics.well-balanced", "on", "off with scheme paper"));
}

TEST_F(ReadScene, ThicknessInEveryForm) {
    const std::string head = "[terrain]\ndtm = a\n[material]\nfriction-angle = 20\n[release]\n";
    const auto thickness = [&](const std::string& text) {
        return *read(head + "perimeter = b\nthickness = " + text + "\n").scene.release.thickness;
    };
    EXPECT_EQ(thickness("attribute:D_MEAN").names.front(), "D_MEAN");
    EXPECT_EQ(thickness("raster:sub/d.tif").names.front(), (folder_ / "sub/d.tif").string());
    EXPECT_EQ(thickness("difference:pre.tif, /data/post.tif").names.front(), (folder_ / "pre.tif").string());
    EXPECT_EQ(thickness("difference:pre.tif, /data/post.tif").names.back(), "/data/post.tif");
    // A raster specifies place as well as thickness; a number does not.
    EXPECT_TRUE(no_problem(problems(head + "thickness = raster:d.tif\n")));
    EXPECT_TRUE(has_problem(problems(head + "thickness = 3\n"), "release.perimeter"));
    EXPECT_TRUE(has_problem(problems(head + "perimeter = b\nthickness = difference:pre.tif\n"), "release.thickness",
                            "difference:pre.tif"));
}

TEST_F(ReadScene, RepeatedKeysEmptyValuesAndStrayWords) {
    EXPECT_TRUE(has_problem(problems(k_least + "density = 1\ndensity = 2\n"), "material.density", "2"));
    EXPECT_TRUE(has_problem(problems(k_least + "density =\n"), "material.density", "", "10 to 10000"));
    EXPECT_THROW(read(k_least + "just words\n"), Error);
    const std::vector<Problem> before_sections = problems("dtm = x\n" + k_least);
    EXPECT_TRUE(has_problem(before_sections, "scene.ini: dtm"));
    EXPECT_EQ(before_sections.front().remedy, "Did you mean terrain.dtm?");
    EXPECT_TRUE(has_problem(problems(k_least, {"time.end"}), "--set time.end"));
}

TEST_F(ReadScene, ByteOrderMarkAndWindowsLineEndsAreFine) {
    std::string windows = "\xEF\xBB\xBF";
    for (const char c : k_least) windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
    EXPECT_TRUE(no_problem(problems(windows)));
}

TEST_F(ReadScene, MissingFileAndFolder) {
    EXPECT_THROW(read_scene((folder_ / "none.ini").string(), {}, ""), Error);
    EXPECT_THROW(read_scene(folder_.string(), {}, ""), Error);
}

TEST_F(ReadScene, PathsOfEveryKind) {
    EXPECT_EQ(absolute_path("a.gpkg|layer=x", "/d/e"), "/d/e/a.gpkg|layer=x");
    EXPECT_EQ(absolute_path("../a.tif", "/d/e"), "/d/a.tif");
    EXPECT_EQ(absolute_path("/d/a b.tif", "/e"), "/d/a b.tif");
    EXPECT_EQ(absolute_path("/vsizip/x.zip/a.tif", "/d"), "/vsizip//d/x.zip/a.tif");
    EXPECT_EQ(absolute_path("/vsizip//e/x.zip/a.tif", "/d"), "/vsizip//e/x.zip/a.tif");
    EXPECT_EQ(absolute_path("/vsigzip/../a.asc.gz", "/d/e"), "/vsigzip//d/a.asc.gz");
    EXPECT_EQ(absolute_path("NETCDF:\"a.nc\":z", "/d"), "NETCDF:\"/d/a.nc\":z");
    EXPECT_EQ(absolute_path("NETCDF:a.nc:z", "/d"), "NETCDF:/d/a.nc:z");
    EXPECT_EQ(absolute_path("GTIFF_DIR:2:a.tif", "/d"), "GTIFF_DIR:2:/d/a.tif");
    EXPECT_EQ(absolute_path("PG:dbname=x", "/d"), "PG:dbname=x");
}

TEST_F(ReadScene, FramesFollowTheMotionUnlessAnIntervalIsGiven) {
    EXPECT_TRUE(std::isinf(frame_interval(read(k_least).scene)));
    EXPECT_EQ(frame_interval(read(k_least + "[time]\nframe-interval = 7\n").scene), 7);
    EXPECT_EQ(frame_interval(read(k_least + "[output]\nframes = off\nanimation = off\n").scene), 0);
    EXPECT_TRUE(has_problem(problems(k_least + "[time]\nframe-interval = 0.001\n"), "time.frame-interval", "0.001 s",
                            "at least 0.03 s for time.end = 300"));
}

TEST_F(ReadScene, OutputsThatContradictAreRefusedTogether) {
    const std::vector<Problem> all = problems(k_least +
                                              "[output]\nformats = particles-gpkg\nframes = off\nanimation = off\n"
                                              "sample-interval = 1\nmap-scale = 5000\nmap-size = 800x600\n");
    EXPECT_TRUE(has_problem(all, "output.formats", "particles-gpkg"));
    EXPECT_TRUE(has_problem(all, "output.sample-interval", "1"));
    EXPECT_TRUE(
        has_problem(all, "output.map-scale", "5000",
                    "A4, A3, A4-portrait, A4-landscape, A3-portrait, A3-landscape; output.map-size is 800x600"));
    EXPECT_EQ(all.size(), 3U);
    EXPECT_TRUE(no_problem(problems(k_least + "[output]\nmap-scale = 5000\nmap-size = A3-portrait@300\n")));
    EXPECT_TRUE(no_problem(problems(k_least + "[output]\nformats = particles-gpkg\n")))
        << "GeoTIFFs need not be asked for";
}

TEST_F(ReadScene, FormatsThatAreGoneAreRefusedWithWhatMakesThem) {
    for (const std::string gone : {"netcdf", "zarr", "ascii", "particles-vtp"}) {
        const std::vector<Problem> all = problems(k_least + "[output]\nformats = geotiff, " + gone + "\n");
        ASSERT_EQ(all.size(), 1U) << gone;
        EXPECT_NE(all[0].what.find("'" + gone + "' is no longer written"), std::string::npos);
        EXPECT_NE(all[0].remedy.find(gone == "particles-vtp" ? "particles-gpkg" : "gdal_translate"), std::string::npos);
    }
    EXPECT_TRUE(
        has_problem(problems(k_least + "[output]\nmap-formats = png, tif\n"), "output.map-formats", "png, tif"));
}

// Pressures of snow with the density of debris were seven times too great.
TEST_F(ReadScene, ClassesOfPressureNeedADensity) {
    for (const std::string scheme : {"austrian-avalanche", "swiss-avalanche"}) {
        const std::string hazard = "[hazard]\nscheme = " + scheme + "\n";
        EXPECT_TRUE(has_problem(problems(k_least + hazard), "material.density", "2000 kg/m3, the default")) << scheme;
        EXPECT_TRUE(problems(k_least + "density = 300\n" + hazard).empty()) << scheme;
        EXPECT_TRUE(problems(k_least + "preset = snow-avalanche\n" + hazard).empty()) << scheme;
    }
    EXPECT_TRUE(problems(k_least + "[hazard]\nscheme = swiss-flood\n").empty());
}

TEST_F(ReadScene, HazardSchemesOfOldKeysAreRefused) {
    const std::vector<Problem> all = problems(k_least + "[hazard]\nscheme = custom\ndepth-limits = 0.5, 2\n");
    EXPECT_TRUE(has_problem(all, "hazard.scheme", "custom"));
    EXPECT_TRUE(has_problem(all, "hazard.depth-limits"));
    EXPECT_TRUE(has_problem(problems(k_least + "[hazard]\nscheme = swiss\n"), "hazard.scheme", "swiss",
                            "austrian-avalanche, austrian-torrent, italian-avalanche, swiss-avalanche, "
                            "swiss-debris-flow, swiss-flood, swiss-hillslope-debris-flow, or a file FILE.ini"));
}

}  // namespace
}  // namespace frana
