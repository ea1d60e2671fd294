// SPDX-License-Identifier: Apache-2.0
#include "params/grammar/value_text.h"

#include <gtest/gtest.h>

#include "params/keys/scene_parameters.h"

namespace frana {
namespace {

TEST(EditDistance, ByHand) {
    EXPECT_EQ(edit_distance("", ""), 0);
    EXPECT_EQ(edit_distance("abc", ""), 3);
    EXPECT_EQ(edit_distance("density", "desnity"), 1);  // neighbours swapped
    EXPECT_EQ(edit_distance("density", "densty"), 1);
    EXPECT_EQ(edit_distance("kitten", "sitting"), 3);
}

TEST(NearestName, FindsWhatWasMeant) {
    const auto known = names_of(scene_parameters());
    EXPECT_EQ(nearest_name("material.frictionangle", known), "material.friction-angle");
    EXPECT_EQ(nearest_name("material.desnity", known), "material.density");
    EXPECT_EQ(nearest_name("release.dtm", known), "terrain.dtm");
    EXPECT_EQ(nearest_name("thicknes", known), "release.thickness");
    EXPECT_EQ(nearest_name("times.end", known), "time.end");
    EXPECT_EQ(nearest_name("material.colour-of-the-sky", known), "");
}

}  // namespace
}  // namespace frana
