// SPDX-License-Identifier: Apache-2.0
#include "app/input/fragility_input.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace frana::app {
namespace {

class ReadFragility : public ::testing::Test {
  protected:
    ~ReadFragility() override { std::filesystem::remove(file_); }
    std::vector<FragilityClass> read(const std::string& text) {
        std::ofstream(file_) << text;
        problems_ = {};
        return read_fragility(file_, "scene.ini: exposure.fragility", problems_);
    }
    /// Whether a table is refused, with all of these words in one problem.
    bool refused(const std::string& text, const std::vector<std::string>& words) {
        read(text);
        return std::any_of(problems_.list().begin(), problems_.list().end(), [&](const Problem& one) {
            const std::string told = describe(one);
            return std::all_of(words.begin(), words.end(),
                               [&](const std::string& word) { return told.find(word) != std::string::npos; });
        });
    }

    std::string file_ =
        (std::filesystem::temp_directory_path() / ("frana_fragility_" + std::to_string(::getpid()) + ".csv")).string();
    Problems problems_;
};

const std::string k_normal = "state,loss_ratio,quantity,unit,median,beta\n";

TEST_F(ReadFragility, ReadsClassesOfStates) {
    const auto one = read(k_normal + "light,0.1,pressure,kPa,5,0.4\nheavy,1,pressure,kPa,30,0\n");
    ASSERT_TRUE(problems_.empty()) << describe(problems_.list().front());
    ASSERT_EQ(one.size(), 1U);
    EXPECT_EQ(one[0].by->quantity, HazardQuantity::pressure);
    ASSERT_EQ(one[0].states.size(), 2U);
    EXPECT_EQ(one[0].states[1].median, 30);
    EXPECT_EQ(one[0].states[1].beta, 0);
    const auto two = read("class," + k_normal + "brick,lost,1,depth,m,2,0.3\nwood,lost,1,momentum-flux,m3/s2,4,0.3\n");
    ASSERT_TRUE(problems_.empty()) << describe(problems_.list().front());
    ASSERT_EQ(two.size(), 2U);
    EXPECT_EQ(two[1].name, "wood");
}

TEST_F(ReadFragility, PlausibleMistakesAreRefused) {
    EXPECT_TRUE(refused(k_normal + "light,30,depth,m,0.5,0.4\n", {"loss_ratio", "write 0.3 for 30 %"}));
    EXPECT_TRUE(refused(k_normal + "light,0.3,depth,m,50,0.4\n", {"median", "not in cm"}));
    EXPECT_TRUE(refused(k_normal + "light,0.3,depth,cm,50,0.4\n", {"unit", "depth in cm", "depth in m"}));
    EXPECT_TRUE(refused(k_normal + "light,0.3,deph,m,0.5,0.4\n", {"not known", "momentum-flux in m3/s2"}));
    EXPECT_TRUE(refused(k_normal + "light,0.3,depth,m,0.5,40\n", {"beta", "0.2 and 1"}));
    EXPECT_TRUE(refused(k_normal + "light,0.3,depth,m,0,0.4\n", {"median", "out of range"}));
    EXPECT_TRUE(refused(k_normal + "light,0.3,depth,m,?,0.4\n", {"median", "out of range"}));
    EXPECT_TRUE(refused(k_normal + "heavy,1,depth,m,0.5,0.4\nlight,0.1,depth,m,2,0.4\n", {"not worse than heavy"}));
    EXPECT_TRUE(refused(k_normal + "light,0.1,depth,m,2,0.4\nheavy,1,depth,m,0.5,0.4\n", {"not worse than light"}));
    EXPECT_TRUE(refused(k_normal + "light,0.1,depth,m,1,0.4\nheavy,1,velocity,m/s,4,0.4\n", {"second quantity"}));
    EXPECT_TRUE(refused("state,loss_ratio,quantity,median,beta\nlight,0.1,depth,1,0.4\n", {"has no column unit"}));
    EXPECT_TRUE(
        refused("state,loss_ratio,quantity,unit,median,beta,cost\nlight,0.1,depth,m,1,0.4,5\n", {"not known", "cost"}));
}

}  // namespace
}  // namespace frana::app
