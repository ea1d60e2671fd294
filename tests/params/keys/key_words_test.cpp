// SPDX-License-Identifier: Apache-2.0
// What a report says of a key, in each language.
#include "params/keys/used_keys.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace frana
