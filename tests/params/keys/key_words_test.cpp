// SPDX-License-Identifier: Apache-2.0
// What a report says of a key, in each language.
#include "params/keys/used_keys.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "params/keys/result_rasters.h"
#include "params/keys/scene_parameters.h"

namespace frana {
namespace {

TEST(KeyWords, EnglishIsAsDeclared) {
    for (const Parameter& key : scene_parameters()) EXPECT_EQ(meaning_in(key, Words()), key.meaning) << key.name();
}

TEST(KeyWords, EveryKeyIsExplainedInEveryLanguage) {
    for (const Parameter& key : scene_parameters()) {
        for (const LanguageRow& language : languages().subspan(1)) {
            const Words words(language_of_code(language.code).value());
            EXPECT_NE(meaning_in(key, words), key.meaning) << key.name() << " in " << language.code;
            EXPECT_EQ(meaning_in(key, words).find("Used by"), std::string::npos) << key.name();
        }
    }
}

TEST(KeyWords, LawsStandInTheLanguagesSentence) {
    const std::vector<Parameter>& keys = scene_parameters();
    const Words german(Language::german);
    EXPECT_EQ(meaning_in(*find_parameter(keys, "material.manning"), german),
              "n nach Manning. Benutzt von material.bed-friction = obrien-julien, manning.");
}

TEST(UsualMaps, AreThoseThatNeedNotBeNamed) {
    const std::vector<std::string> usual = usual_maps(), known = map_names();
    const auto has = [](const std::vector<std::string>& list, const std::string& name) {
        return std::find(list.begin(), list.end(), name) != list.end();
    };
    EXPECT_TRUE(has(usual, RasterName::max_depth) && has(usual, RasterName::max_velocity));
    for (const char* name : {RasterName::outside_depth, RasterName::jump_height}) {
        EXPECT_FALSE(has(usual, name)) << name;
        EXPECT_TRUE(has(known, name)) << name;
    }
}

}  // namespace
}  // namespace frana
