// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "support/checked_scene.h"

namespace frana::test {
namespace {

using New = CheckedScene;

TEST_F(New, ASceneOfTheSamplePassesTheCheck) {
    const std::string sample = std::string(FRANA_SOURCE_DIR) + "/sample_data/bindo/";
    const Outcome made = succeeded(frana({"new", sample + "dtm.tif", sample + "perimeter.shp", "--thickness", "4",
                                          "--preset", "debris-flow", "--out", "my.ini"}));
    EXPECT_EQ(made.out, "");
    succeeded(frana({"check", "my.ini"}));
    const std::string text = read_text(path("my.ini"));
    expect_words(text,
                 {"\nthickness = 4\n", "\n# dtm-contains-release = on\n", "# Found: 1 polygon in the layer perimeter"});
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
    succeeded(frana({"new", "dtm.asc", "perimeter.geojson", "--thickness", "2", "--preset", "debris-flow", "--out",
                     "my.ini", "--study", "study.ini"}));
    refusal_of(refused({"check", "study.ini"}), {"vary: has no key"});
    write("study.ini", read_text(path("study.ini")) + "material.turbulence = log-uniform(300, 600)\n");
    EXPECT_NE(read_text(path("study.ini")).find("\nscheme = finite-volume\n"), std::string::npos);
    succeeded(frana({"check", "study.ini"}));
    refusal_of(refused({"new", "dtm.asc", "perimeter.geojson", "--out", "b.ini", "--study", "study.ini"}));
}

// Every line after # that a region may have is one that it accepts.
TEST_F(New, ARegionToBeginWithIsReadAsItIsAndWithItsFrequency) {
    succeeded(frana({"new", "dtm.asc", "perimeter.geojson", "--thickness", "2", "--preset", "debris-flow", "--out",
                     "my.ini", "--region", "region.ini"}));
    succeeded(frana({"check", "region.ini"}));
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
    const Outcome frequency = succeeded(frana({"check", "region.ini"}));
    EXPECT_NE(frequency.out.find("64 of each slope"), std::string::npos) << frequency.out;
}

TEST_F(New, ARegionFindsItsColumnsByTheirNames) {
    const std::string sample = std::string(FRANA_SOURCE_DIR) + "/sample_data/fan/";
    succeeded(frana({"new", sample + "dtm.tif", sample + "slopes.geojson", "--thickness", "1", "--preset",
                     "debris-flow", "--out", "my.ini", "--region", "region.ini", "--study", "study.ini"}));
    const std::string text = read_text(path("region.ini"));
    expect_words(text,
                 {"\nname = NAME\n", "\nscenario = SCENARIO\n", "\n# return-period = YEARS\n",
                  "\nrelease.volume = VOLUME\n", "\n# frequency.rate = RATE\n", "\n# frequency.volumes = VOLUMES\n"});
    const Outcome checked = succeeded(frana({"check", "region.ini"}));
    EXPECT_NE(checked.out.find("Rio Bianco, scenario T300"), std::string::npos) << checked.out;
    write("study.ini", read_text(path("study.ini")) + "material.turbulence = log-uniform(150, 300)\n");
    succeeded(frana({"check", "study.ini"}));
}

TEST_F(New, AnOpenPresetIsAskedForWithTheChoicesAndRefusedByTheCheck) {
    succeeded(frana({"new", "dtm.asc", "perimeter.geojson", "--thickness", "2", "--out", "my.ini"}));
    const std::string text = read_text(path("my.ini"));
    expect_words(text, {"\npreset =\n", "# One of bindo, debris-flow"});
    refusal_of(refused({"check", "my.ini"}), {"my.ini: material.preset: has no value"});
    refusal_of(refused({"new", "dtm.asc", "perimeter.geojson", "--preset", "granite", "--out", "wrong.ini"}),
               {"--preset: is not a material preset (value granite"});
}

TEST_F(New, AnOpenThicknessIsAskedForAndRefusedByTheCheck) {
    succeeded(frana({"new", "dtm.asc", "perimeter.geojson", "--out", "my.ini"}));
    const std::string text = read_text(path("my.ini"));
    expect_words(text, {"\nthickness =\n", "# Is the column depth (2 to 2) the thickness in metres?"});
    refusal_of(refused({"check", "my.ini"}), {"my.ini: release.thickness: has no value"});
}

TEST_F(New, ReplacesNothingAndRefusesWhatDoesNotFit) {
    write("my.ini", "mine");
    refusal_of(refused({"new", "dtm.asc", "perimeter.geojson", "--out", "my.ini"}));
    EXPECT_EQ(read_text(path("my.ini")), "mine");
    succeeded(frana({"new", "dtm.asc", "perimeter.geojson", "--out", "my.ini", "--overwrite"}));
    write_polygon("far", {{5000, 0}, {5100, 0}, {5100, 100}});
    const Outcome far =
        refusal_of(refused({"new", "dtm.asc", "far.geojson", "--out", "far.ini"}), {"lies outside the DTM"});
    refusal_of(refused({"new", "dtm.asc"}));
    refusal_of(refused({"new", "dtm.asc", "perimeter.geojson", "--thickness", "-1", "--out", "b.ini"}));
    EXPECT_FALSE(std::filesystem::exists(path("far.ini")) || std::filesystem::exists(path("b.ini")));
}

TEST_F(New, NamesFilesFromTheFolderOfTheScene) {
    std::filesystem::create_directory(folder_ / "scenes");
    succeeded(frana({"new", "dtm.asc", "perimeter.geojson", "--thickness", "attribute:depth", "--preset", "debris-flow",
                     "--out", "scenes/my.ini"}));
    const std::string text = read_text(path("scenes/my.ini"));
    expect_words(text, {"\ndtm = ../dtm.asc\n", "\nperimeter = ../perimeter.geojson\n"});
    succeeded(frana({"check", "scenes/my.ini"}));
}

}  // namespace
}  // namespace frana::test
