// SPDX-License-Identifier: Apache-2.0
#include "app/store/layers.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "core/error.h"
#include "params/keys/scene_parameters.h"

namespace frana::app {
namespace {

TEST(Layers, DepthClassesAreFineWhereFlowsAreThin) {
    const auto classes = [](double maximum) { return layer_classes(layer_named("max_depth"), maximum); };
    EXPECT_EQ(classes(38.2), (std::vector<double>{0, 0.5, 1, 2, 5, 10, 20, 30, 40}));
    EXPECT_EQ(classes(14.8), (std::vector<double>{0, 0.1, 0.2, 0.5, 1, 2, 5, 10, 15}));
    EXPECT_EQ(classes(8),
              (std::vector<double>{0, 0.1, 0.2, 0.5, 1, 2, 3, 5, 8}));  // a bound may be the maximum
}

TEST(Layers, ClassesHoldEveryMaximum) {
    for (const Layer& layer : result_layers()) {
        for (const double maximum : {1e-7, 0.01, 0.3, 1.0, 2.0, 5.0, 9.99, 10.0, 123.0, 9e9}) {
            const std::vector<double> bounds = layer_classes(layer, maximum);
            ASSERT_GE(bounds.size(), 2U) << layer.name << ' ' << maximum;
            EXPECT_EQ(bounds.front(), 0) << layer.name << ' ' << maximum;
            // a bound may fall short of the maximum by the rounding of one product
            EXPECT_GE(bounds.back() * (1 + 1e-9), maximum) << layer.name;
            for (std::size_t i = 1; i < bounds.size(); ++i) EXPECT_GT(bounds[i], bounds[i - 1]) << layer.name;
        }
        for (const double nothing : {0.0, std::numeric_limits<double>::quiet_NaN()})
            EXPECT_GE(layer_classes(layer, nothing).size(), 2U) << layer.name;
    }
}

TEST(Layers, EveryMapOfTheSceneKeysIsALayer) {
    // Rasters that only some runs write are drawn as their files say.
    const std::set<std::string> of_some_runs{"hazard"};
    for (std::string name : map_names()) {
        if (name.ends_with("_3d")) name.resize(name.size() - 3);
        if (of_some_runs.count(name) == 0) {
            EXPECT_NO_THROW(layer_named(name)) << name;
        }
    }
    EXPECT_THROW(layer_named("view"), Error);
}

}  // namespace
}  // namespace frana::app
