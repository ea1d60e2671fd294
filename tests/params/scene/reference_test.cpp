// SPDX-License-Identifier: Apache-2.0
#include "params/scene/read_scene.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "core/json.h"
#include "params/keys/scene_parameters.h"
#include "params/keys/used_keys.h"
#include "physics/laws.h"
#include "scene_fixture.h"

namespace frana {
namespace {

TEST(Parameters, EveryDefaultIsWithinItsOwnLimitsAndEveryKeyHasAMeaning) {
    std::set<std::string> names;
    for (const Parameter& parameter : scene_parameters()) {
        EXPECT_TRUE(names.insert(parameter.name()).second) << parameter.name() << " is declared twice";
        EXPECT_FALSE(parameter.meaning.empty()) << parameter.name();
        const std::string text = parameter.default_text();
        if (text.empty()) {
            EXPECT_FALSE(parameter.absent.empty())
                << parameter.name() << " has no default and no description of its absence";
            continue;
        }
        SceneSpec scene;
        EXPECT_FALSE(parameter.read(scene, text)) << parameter.name() << " refuses its own default " << text;
        EXPECT_EQ(parameter.write(scene), text) << parameter.name();
    }
}

TEST(Parameters, ResetRestoresTheDefault) {
    SceneSpec scene;
    scene.material.density = 1;
    scene.material.of<CoulombFriction>().friction_angle = 3;
    scene.terrain.bounds = Bounds{1, 2, 3, 4};
    for (const Parameter& parameter : scene_parameters()) {
        parameter.reset(scene);
        EXPECT_EQ(parameter.write(scene), parameter.write(SceneSpec{})) << parameter.name();
    }
}

TEST(Reference, NamesEveryKeyInEveryForm) {
    const std::string ini = reference_ini(), markdown = reference_markdown();
    const Json json = Json::parse(reference_json());
    ASSERT_EQ(json.size(), scene_parameters().size());
    std::size_t at = 0;
    for (const Parameter& parameter : scene_parameters()) {
        EXPECT_NE(ini.find("# " + parameter.key + " = "), std::string::npos) << parameter.name();
        EXPECT_EQ(json[at++]["name"], parameter.name());
        EXPECT_NE(markdown.find("| `" + parameter.key + "` |"), std::string::npos) << parameter.name();
    }
}

TEST(Reference, TheJsonFormTellsWhatEachFileContains) {
    const std::set<std::string> contents{
        "raster", "polygons", "lines", "points", "lines or points", "points, lines or polygons", "raster or polygons",
        "table"};
    int files = 0;
    for (const Json& key : Json::parse(reference_json())) {
        ASSERT_EQ(key["type"] == "file", key.contains("content")) << key["name"];
        if (!key.contains("content")) continue;
        ++files;
        EXPECT_TRUE(contents.contains(key["content"].get<std::string>())) << key["name"];
    }
    EXPECT_GT(files, 10);
}

TEST(Reference, TheJsonFormMarksTheTwentyMainKeys) {
    int marked = 0;
    for (const Json& key : Json::parse(reference_json())) {
        EXPECT_EQ(key.at("main").get<bool>(), is_main_key(key.at("name").get<std::string>())) << key["name"];
        marked += key.at("main").get<bool>() ? 1 : 0;
    }
    EXPECT_EQ(marked, 20);  // each is a key: a misspelt one would be missing here
}

TEST(Reference, TheJsonFormNamesKeysInALanguageAndPlacesEightInADialogue) {
    std::set<std::size_t> places;
    int translated = 0, titled = 0;
    const Json german = Json::parse(reference_json(Language::german));
    for (const Json& key : german) {
        EXPECT_FALSE(key.at("title").get<std::string>().empty()) << key["name"];
        if (key.contains("place")) {
            EXPECT_TRUE(places.insert(key["place"].get<std::size_t>()).second) << key["name"];
        }
        if (key["name"] == "release.perimeter") {
            EXPECT_EQ(key["title"], "Anrissgebiet");
            EXPECT_EQ(key["section_title"], "Anrissgebiet");
            EXPECT_TRUE(key.at("required").get<bool>());
        }
        const Parameter& own = *find_parameter(scene_parameters(), key["name"]);
        if (title_of(own) == own.key) continue;  // shown by its name
        ++titled;
        translated += key["title"] != title_of(own) ? 1 : 0;
    }
    EXPECT_EQ(places.size(), 8U);
    EXPECT_EQ(*places.rbegin(), 7U) << "each row of the table is a key";
    EXPECT_GE(titled, 40);
    EXPECT_GT(translated, titled * 9 / 10);
}

TEST(Reference, TheDocumentInShareIsWhatTheProgramPrints) {
    std::ifstream file(FRANA_SOURCE_SHARE "/doc/parameters.md");
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    EXPECT_EQ(text, reference_markdown()) << "run: frana params --markdown > share/doc/parameters.md";
}

// A key costs a row, texts in five languages and refusals: one that nobody is told of goes.
TEST(Reference, EveryKeyIsInASceneOrADocumentOfATask) {
    namespace fs = std::filesystem;
    std::string told;
    for (const char* folder : {"", "/../sample_data"})
        for (const fs::directory_entry& entry :
             fs::recursive_directory_iterator(FRANA_SOURCE_SHARE + std::string(folder))) {
            const fs::path& path = entry.path();
            if ((path.extension() != ".md" && path.extension() != ".ini") || path.filename() == "parameters.md")
                continue;
            std::ifstream file(path);
            told += ' ' + std::string{std::istreambuf_iterator<char>(file), {}};
        }
    for (const Parameter& key : scene_parameters())
        EXPECT_TRUE(std::regex_search(told, std::regex("(\\n *|`|" + key.section + "\\.)" + key.key + "[^a-z-]")))
            << key.name();
}

using ReferenceFile = SceneFixture;

TEST_F(ReferenceFile, TheIniFormIsAValidSceneFileOfDefaults) {
    const SceneReading reading = read(reference_ini());
    for (const Problem& problem : reading.problems.list())
        EXPECT_TRUE(problem.what == "is missing" || problem.what == "no bed friction is given") << describe(problem);
}

}  // namespace
}  // namespace frana
