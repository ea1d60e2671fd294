// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "support/tiny_scene.h"

namespace frana::test {
namespace {

using New = TinyScene;

TEST_F(New, ASceneOfTheSamplePassesTheCheck) {
    const std::string sample = std::string(FRANA_SOURCE_DIR) + "/sample_data/bindo/";
    const Outcome made = frana({"new", sample + "dtm.tif", sample + "perimeter.shp", "--thickness", "4", "--preset",
                                "debris-flow", "--out", "my.ini"});
    ASSERT_EQ(made.exit_code, 0) << made.err;
    EXPECT_EQ(made.out, "");
    const Outcome checked = frana({"check", "my.ini"});
    EXPECT_EQ(checked.exit_code, 0) << checked.err;
    const std::string text = read_text(path("my.ini"));
    EXPECT_NE(text.find("\nthickness = 4\n"), std::string::npos) << text;
    EXPECT_NE(text.find("\n# dtm-contains-release = on\n"), std::string::npos) << text;
    EXPECT_NE(text.find("# Found: 1 polygon in the layer perimeter"), std::string::npos) << text;
    // Twenty keys, each a line with " = ", active or not.
    int keys = 0;
    std::size_t begin = 0;
    for (std::size_t end; (end = text.find('\n', begin)) != std::string::npos; begin = end + 1) {
        std::string line = text.substr(begin, end - begin);
        if (line.rfind("# ", 0) == 0) line.erase(0, 2);
        const auto equals = line.find(" =");
        keys += equals != std::string::npos && line.find(' ') == equals ? 1 : 0;
    }
    EXPECT_EQ(keys, 20) << text;
}

TEST_F(New, AStudyToBeginWithUsesFiniteVolumes) {
    ASSERT_EQ(frana({"new", "dtm.asc", "perimeter.geojson", "--thickness", "2", "--preset", "debris-flow", "--out",
                     "my.ini", "--study", "study.ini"})
                  .exit_code,
              0);
    const Outcome open = frana({"check", "study.ini"});
    EXPECT_EQ(open.exit_code, 2);
    EXPECT_NE(open.err.find("vary: has no key"), std::string::npos) << open.err;
    write("study.ini", read_text(path("study.ini")) + "material.turbulence = log-uniform(300, 600)\n");
    EXPECT_NE(read_text(path("study.ini")).find("\nscheme = finite-volume\n"), std::string::npos);
    const Outcome checked = frana({"check", "study.ini"});
    EXPECT_EQ(checked.exit_code, 0) << checked.err;
    EXPECT_EQ(frana({"new", "dtm.asc", "perimeter.geojson", "--out", "b.ini", "--study", "study.ini"}).exit_code, 2);
}

// Every line after # that a region may have is one that it accepts.
TEST_F(New, ARegionToBeginWithIsReadAsItIsAndWithItsFrequency) {
    ASSERT_EQ(frana({"new", "dtm.asc", "perimeter.geojson", "--thickness", "2", "--preset", "debris-flow", "--out",
                     "my.ini", "--region", "region.ini"})
                  .exit_code,
              0);
    const Outcome scenario = frana({"check", "region.ini"});
    EXPECT_EQ(scenario.exit_code, 0) << scenario.err;
    std::string text = read_text(path("region.ini"));
    const auto use = [&](const std::string& line, const std::string& as) {
        const std::size_t at = text.find("# " + line);
        ASSERT_NE(at, std::string::npos) << line;
        text.replace(at, 2 + line.size(), as);
    };
    use("[frequency]", "[frequency]");
    use("volumes = M3: YEARS, M3: YEARS", "volumes = 2000: 20, 4000: 100");
    use("[vary]", "[vary]");
    use("material.friction-angle = triangular(LEAST, LIKELIEST, GREATEST)",
        "material.friction-angle = triangular(12, 15, 20)");
    write("region.ini", text);
    const Outcome frequency = frana({"check", "region.ini"});
    EXPECT_EQ(frequency.exit_code, 0) << frequency.err;
    EXPECT_NE(frequency.out.find("64 of each slope"), std::string::npos) << frequency.out;
}

TEST_F(New, ARegionFindsItsColumnsByTheirNames) {
    const std::string sample = std::string(FRANA_SOURCE_DIR) + "/sample_data/fan/";
    ASSERT_EQ(frana({"new", sample + "dtm.tif", sample + "slopes.geojson", "--thickness", "1", "--preset",
                     "debris-flow", "--out", "my.ini", "--region", "region.ini", "--study", "study.ini"})
                  .exit_code,
              0);
    const std::string text = read_text(path("region.ini"));
    for (const char* line :
         {"\nname = NAME\n", "\nscenario = SCENARIO\n", "\n# return-period = YEARS\n", "\nrelease.volume = VOLUME\n",
          "\n# frequency.rate = RATE\n", "\n# frequency.volumes = VOLUMES\n"})
        EXPECT_NE(text.find(line), std::string::npos) << line << text;
    const Outcome checked = frana({"check", "region.ini"});
    EXPECT_EQ(checked.exit_code, 0) << checked.err;
    EXPECT_NE(checked.out.find("Rio Bianco, scenario T300"), std::string::npos) << checked.out;
    write("study.ini", read_text(path("study.ini")) + "material.turbulence = log-uniform(150, 300)\n");
    const Outcome study = frana({"check", "study.ini"});
    EXPECT_EQ(study.exit_code, 0) << study.err;
}

TEST_F(New, AnOpenPresetIsAskedForWithTheChoicesAndRefusedByTheCheck) {
    ASSERT_EQ(frana({"new", "dtm.asc", "perimeter.geojson", "--thickness", "2", "--out", "my.ini"}).exit_code, 0);
    const std::string text = read_text(path("my.ini"));
    EXPECT_NE(text.find("\npreset =\n"), std::string::npos) << text;
    EXPECT_NE(text.find("# One of bindo, debris-flow"), std::string::npos) << text;
    const Outcome checked = frana({"check", "my.ini"});
    EXPECT_EQ(checked.exit_code, 2);
    EXPECT_NE(checked.err.find("my.ini: material.preset: has no value"), std::string::npos) << checked.err;
    const Outcome wrong = frana({"new", "dtm.asc", "perimeter.geojson", "--preset", "granite", "--out", "wrong.ini"});
    EXPECT_EQ(wrong.exit_code, 2);
    EXPECT_NE(wrong.err.find("--preset: is not a material preset (value granite"), std::string::npos) << wrong.err;
}

TEST_F(New, AnOpenThicknessIsAskedForAndRefusedByTheCheck) {
    ASSERT_EQ(frana({"new", "dtm.asc", "perimeter.geojson", "--out", "my.ini"}).exit_code, 0);
    const std::string text = read_text(path("my.ini"));
    EXPECT_NE(text.find("\nthickness =\n"), std::string::npos) << text;
    EXPECT_NE(text.find("# Is the column depth (2 to 2) the thickness in metres?"), std::string::npos) << text;
    const Outcome checked = frana({"check", "my.ini"});
    EXPECT_EQ(checked.exit_code, 2);
    EXPECT_NE(checked.err.find("my.ini: release.thickness: has no value"), std::string::npos) << checked.err;
}

TEST_F(New, ReplacesNothingAndRefusesWhatDoesNotFit) {
    write("my.ini", "mine");
    EXPECT_EQ(frana({"new", "dtm.asc", "perimeter.geojson", "--out", "my.ini"}).exit_code, 2);
    EXPECT_EQ(read_text(path("my.ini")), "mine");
    EXPECT_EQ(frana({"new", "dtm.asc", "perimeter.geojson", "--out", "my.ini", "--overwrite"}).exit_code, 0);
    write_polygon("far", {{5000, 0}, {5100, 0}, {5100, 100}});
    const Outcome far = frana({"new", "dtm.asc", "far.geojson", "--out", "far.ini"});
    EXPECT_EQ(far.exit_code, 2);
    EXPECT_NE(far.err.find("lies outside the DTM"), std::string::npos) << far.err;
    EXPECT_EQ(frana({"new", "dtm.asc"}).exit_code, 2);
    EXPECT_EQ(frana({"new", "dtm.asc", "perimeter.geojson", "--thickness", "-1", "--out", "b.ini"}).exit_code, 2);
    EXPECT_FALSE(std::filesystem::exists(path("far.ini")) || std::filesystem::exists(path("b.ini")));
}

TEST_F(New, NamesFilesFromTheFolderOfTheScene) {
    std::filesystem::create_directory(folder_ / "scenes");
    ASSERT_EQ(frana({"new", "dtm.asc", "perimeter.geojson", "--thickness", "attribute:depth", "--preset", "debris-flow",
                     "--out", "scenes/my.ini"})
                  .exit_code,
              0);
    const std::string text = read_text(path("scenes/my.ini"));
    EXPECT_NE(text.find("\ndtm = ../dtm.asc\n"), std::string::npos) << text;
    EXPECT_NE(text.find("\nperimeter = ../perimeter.geojson\n"), std::string::npos) << text;
    EXPECT_EQ(frana({"check", "scenes/my.ini"}).exit_code, 0);
}

}  // namespace
}  // namespace frana::test
