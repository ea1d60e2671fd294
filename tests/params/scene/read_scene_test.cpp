// SPDX-License-Identifier: Apache-2.0
#include "params/scene/read_scene.h"
#include "params/grammar/ini_file.h"

#include <cmath>

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
    EXPECT_NEAR(reading.scene.material.bed_friction_coefficient(), 0.36397023426620236, 1e-15);
}

TEST_F(ReadScene, EveryProblemInOnePass) {
    const std::string all = messages(
        "[terrain]\ncell-sise = 5\nnodata-policy = ignore\n[release]\nthickness = -3\n[material]\n"
        "density = heavy\nfriction-coefficient = 7\n[time]\nend = 0\n");
    EXPECT_NE(all.find("scene.ini: terrain.cell-sise: unknown key. Did you mean terrain.cell-size?"),
              std::string::npos);
    EXPECT_NE(all.find("terrain.nodata-policy: is not one of the choices (value ignore; allowed stop, wall, fill)"),
              std::string::npos);
    EXPECT_NE(all.find("release.thickness: is not a thickness (value -3"), std::string::npos);
    EXPECT_NE(all.find("material.density: is not a number (value heavy; allowed 10 to 10000 [kg/m3])"),
              std::string::npos);
    EXPECT_NE(all.find("material.friction-coefficient: is out of range (value 7; allowed 0 to 2)"), std::string::npos);
    EXPECT_NE(all.find("time.end: is out of range (value 0"), std::string::npos);
    EXPECT_NE(all.find("terrain.dtm: is missing"), std::string::npos);
    EXPECT_NE(all.find("release.perimeter: is missing"), std::string::npos);
    // a key with an invalid value is present, not missing
    EXPECT_EQ(all.find("release.thickness: is missing"), std::string::npos);
    EXPECT_EQ(all.find("no bed friction"), std::string::npos);
}

TEST_F(ReadScene, FrictionIsRequired) {
    EXPECT_NE(
        messages("[terrain]\ndtm = a\n[release]\nperimeter = b\nthickness = 1\n").find("no bed friction is given"),
        std::string::npos);
}

TEST_F(ReadScene, FrictionGivenTwiceIsAContradiction) {
    EXPECT_NE(messages(k_least + "friction-coefficient = 0.3\n").find("contradicts material.friction-coefficient"),
              std::string::npos);
}

TEST_F(ReadScene, LaterSourcesOverrideEarlierOnes) {
    const SceneReading from_preset = read(
        "[terrain]\ndtm = a\n[release]\nperimeter = b\nthickness = 1\n[material]\npreset = bindo\ndensity = "
        "1500\n");
    EXPECT_TRUE(from_preset.problems.empty());
    EXPECT_EQ(from_preset.scene.material.friction_angle, 34);
    EXPECT_EQ(from_preset.scene.material.yield_stress, 50);
    EXPECT_EQ(from_preset.scene.material.density, 1500);
    EXPECT_EQ(from_preset.scene.origin_of("material.friction-angle"), Origin::preset);

    // The command line gives friction by the other key: it replaces, it does not contradict.
    const SceneReading overridden = read(k_least, {"material.friction-coefficient=0.25", "time.end = 12.5"});
    EXPECT_TRUE(overridden.problems.empty());
    EXPECT_FALSE(overridden.scene.material.friction_angle);
    EXPECT_EQ(overridden.scene.material.bed_friction_coefficient(), 0.25);
    EXPECT_EQ(overridden.scene.time.end, 12.5);
    EXPECT_EQ(overridden.scene.origin_of("time.end"), Origin::command_line);
}

TEST_F(ReadScene, UnknownPresetNamesThePresets) {
    const std::string all = messages(k_least + "preset = bindoo\n");
    EXPECT_NE(all.find("material.preset: is not a material preset (value bindoo; allowed bindo, debris-flow"),
              std::string::npos);
    const std::string longer_than_file_names(300, 'x');
    EXPECT_NE(messages(k_least + "preset = " + longer_than_file_names + "\n").find("is not a material preset"),
              std::string::npos);
}

TEST_F(ReadScene, SlopeCorrectionFollowsTheScheme) {
    EXPECT_EQ(slope_correction(read(k_least).scene.numerics), SlopeCorrection::normal);
    EXPECT_EQ(slope_correction(read(k_least + "[numerics]\nscheme = paper\n").scene.numerics), SlopeCorrection::none);
    EXPECT_EQ(
        slope_correction(read(k_least + "[numerics]\nscheme = paper\nslope-correction = surface\n").scene.numerics),
        SlopeCorrection::surface);
    EXPECT_NE(messages(k_least + "[numerics]\nscheme = paper\nwell-balanced = on\n").find("are part of scheme default"),
              std::string::npos);
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
    EXPECT_EQ(messages(head + "thickness = raster:d.tif\n"), "");
    EXPECT_NE(messages(head + "thickness = 3\n").find("release.perimeter: is missing"), std::string::npos);
    EXPECT_NE(messages(head + "perimeter = b\nthickness = difference:pre.tif\n").find("is not understood"),
              std::string::npos);
}

TEST_F(ReadScene, RepeatedKeysEmptyValuesAndStrayWords) {
    EXPECT_NE(messages(k_least + "density = 1\ndensity = 2\n").find("is given more than once"), std::string::npos);
    EXPECT_NE(messages(k_least + "density =\n").find("material.density: has no value"), std::string::npos);
    EXPECT_THROW(read(k_least + "just words\n"), Error);
    EXPECT_NE(messages("dtm = x\n" + k_least).find("dtm: unknown key. Did you mean terrain.dtm?"), std::string::npos);
    EXPECT_NE(messages(k_least, {"time.end"}).find("--set time.end: is not section.key=value"), std::string::npos);
}

TEST_F(ReadScene, DecimalCommaIsExplained) {
    EXPECT_NE(messages(k_least + "density = 1800,5\n").find("after a point, not a comma"), std::string::npos);
}

TEST_F(ReadScene, ByteOrderMarkAndWindowsLineEndsAreFine) {
    std::string windows = "\xEF\xBB\xBF";
    for (const char c : k_least) windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
    EXPECT_EQ(messages(windows), "");
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

TEST_F(ReadScene, FrameIntervalIsRoundAndOnlyWithFrames) {
    EXPECT_EQ(frame_interval(read(k_least + "[time]\nend = 300\n").scene), 5);
    EXPECT_EQ(frame_interval(read(k_least + "[time]\nend = 20\n").scene), 0.5);
    EXPECT_EQ(frame_interval(read(k_least + "[output]\nframes = off\nanimation = off\n").scene), 0);
    EXPECT_NE(messages(k_least + "[time]\nframe-interval = 0.001\n").find("more than 10000 frames"), std::string::npos);
}

TEST_F(ReadScene, OutputsThatContradictAreRefusedTogether) {
    const std::string all = messages(k_least +
                                     "[output]\nformats = netcdf, ascii\nframes = off\nanimation = off\n"
                                     "sample-interval = 1\nmap-scale = 5000\nmap-background-licence = CC\n"
                                     "[hazard]\nscheme = custom\n");
    for (const std::string words :
         {"output.formats: netcdf and zarr contain the frames, but the scene writes none",
          "output.formats: ascii is a format of the AvaFrame rasters",
          "output.sample-interval: has no effect: there are no gauges or cross-sections",
          "output.map-scale: needs a paper size: pixels have no scale until they are printed (value "
          "5000; allowed A4, A3",
          "output.map-background-licence: has no effect: there is no output.map-background",
          "hazard.scheme: scheme custom needs limits"})
        EXPECT_NE(all.find(words), std::string::npos) << words << " in\n" << all;
    EXPECT_EQ(messages(k_least + "[output]\nmap-scale = 5000\nmap-size = A3-portrait@300\n"), "");
    EXPECT_EQ(messages(k_least + "[output]\nformats = netcdf\n"), "") << "GeoTIFFs need not be asked for";
}

TEST_F(ReadScene, LimitsRiseFromAboveZero) {
    const SceneReading reading =
        read(k_least + "[hazard]\nscheme = custom\ndepth-limits = 0.5 2\npressure-limits = 3, 30\n");
    EXPECT_TRUE(reading.problems.empty());
    EXPECT_EQ(reading.scene.hazard.depth_limits, (std::vector<double>{0.5, 2}));
    EXPECT_EQ(reading.scene.hazard.pressure_limits, (std::vector<double>{3, 30}));
    for (const std::string limits : {"0 1", "2 1", "1 1", "1 x"})
        EXPECT_NE(messages(k_least + "[hazard]\nscheme = custom\ndepth-limits = " + limits + "\n")
                      .find("hazard.depth-limits"),
                  std::string::npos)
            << limits;
    const auto limits_of = [](int count) {  // one class more, and classes are bytes from 1
        std::string limits;
        for (int i = 1; i <= count; ++i) limits += std::to_string(i) + " ";
        return limits;
    };
    for (const char* key : {"depth-limits", "velocity-limits", "flux-limits", "pressure-limits"}) {
        const std::string custom = k_least + "[hazard]\nscheme = custom\n" + key + " = ";
        EXPECT_TRUE(read(custom + limits_of(254)).problems.empty()) << key;
        EXPECT_NE(messages(custom + limits_of(255)).find("more numbers than there can be classes"), std::string::npos);
    }
    EXPECT_NE(messages(k_least + "[hazard]\nscheme = swiss\n").find("hazard.scheme: is not one of the choices"),
              std::string::npos);
}

}  // namespace
}  // namespace frana
