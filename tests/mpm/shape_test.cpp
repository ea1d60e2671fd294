// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "mpm/shape.h"

namespace frana {
namespace {

template <class Shape>
class ShapeFunctions : public testing::Test {};
using Shapes = testing::Types<HatShape, QuadraticSplineShape>;
TYPED_TEST_SUITE(ShapeFunctions, Shapes);

TYPED_TEST(ShapeFunctions, PartitionUnityAndReproduceLinearFields) {
    double w[TypeParam::width], g[TypeParam::width];
    for (double s = -0.4; s < 7; s += 0.0371) {
        const std::int64_t first = TypeParam::evaluate(s, w, g);
        double one = 0, place = 0, flat = 0, slope = 0;
        for (int a = 0; a < TypeParam::width; ++a) {
            const auto node = static_cast<double>(first + a);
            one += w[a];
            place += w[a] * node;
            flat += g[a];
            slope += g[a] * node;
            EXPECT_GE(w[a], -1e-16);
        }
        EXPECT_NEAR(one, 1, 1e-15);
        EXPECT_NEAR(place, s, 1e-14);
        EXPECT_NEAR(flat, 0, 1e-15);
        EXPECT_NEAR(slope, 1, 1e-14);
    }
}

}  // namespace
}  // namespace frana
