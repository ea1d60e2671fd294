// SPDX-License-Identifier: Apache-2.0
// What a report says of a key, in each language.
#include "params/keys/used_keys.h"

#include <gtest/gtest.h>

#include "params/keys/scene_parameters.h"

namespace frana {
namespace {

TEST(KeyWords, EnglishIsAsDeclared) {
    for (const Parameter& key : scene_parameters()) {
        EXPECT_EQ(meaning_in(key, Words()), key.meaning) << key.name();
        EXPECT_EQ(absent_in(key, Words()), key.absent) << key.name();
    }
}

TEST(KeyWords, EveryKeyIsExplainedInEveryLanguage) {
    for (const Parameter& key : scene_parameters()) {
        for (const LanguageRow& language : languages().subspan(1)) {
            const Words words(language_of_code(language.code).value());
            EXPECT_NE(meaning_in(key, words), key.meaning) << key.name() << " in " << language.code;
            EXPECT_EQ(meaning_in(key, words).find("Used by"), std::string::npos) << key.name();
            if (rows_of(key).size() > 2 || key.absent.starts_with("required with")) {
                EXPECT_NE(absent_in(key, words), key.absent) << key.name() << " in " << language.code;
            }
        }
    }
}

TEST(KeyWords, LawsAndNumbersStandInTheLanguagesSentence) {
    const std::vector<Parameter>& keys = scene_parameters();
    const Words german(Language::german), french(Language::french);
    EXPECT_EQ(meaning_in(*find_parameter(keys, "material.manning"), german),
              "n nach Manning. Benutzt von material.bed-friction = obrien-julien oder manning.");
    EXPECT_EQ(absent_in(*find_parameter(keys, "material.friction-beta"), german), "0,136, Glaskugeln");
    EXPECT_EQ(absent_in(*find_parameter(keys, "structured.cohesion"), french), "obligatoire avec des solides");
    EXPECT_EQ(absent_in(*find_parameter(keys, "entrainment.erodible-depth"), french),
              "obligatoire avec entrainment.erosion = shear-stress ou growth ou mechanical");
}

}  // namespace
}  // namespace frana
