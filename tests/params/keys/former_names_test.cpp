// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "scene_fixture.h"

namespace frana {
namespace {

class FormerNamesInScenes : public SceneFixture {};

TEST_F(FormerNamesInScenes, BesideThePresentOneAreGivenTwice) {
    EXPECT_TRUE(has_problem(problems(k_least + "[scar]\nthreshold = 0.1\n[observed]\nthreshold = 0.2\n"),
                            "observed.threshold", "0.2"));
}

// What went names what to use in its place.
TEST_F(FormerNamesInScenes, KeysThatWentSayWhatToUse) {
    for (const auto& [line, remedy] : std::vector<std::pair<std::string, std::string>>{
             {"[time]\nstop-energy-fraction = 0.1\n", "Use time.stop-momentum"},
             {"[numerics]\ngravity = 9\n", "9.81 m/s2"},
             {"[structured]\nvirtual-mass = none\n", "Pudasaini 2012"},
             {"[material]\nyield-ratio = quadratic\n", "exact"},
             {"[output]\nclasses = fixed\n", "follow the values"},
             {"[output]\nclasses-strain = 1\n", "follow the values"}}) {
        const std::vector<Problem> all = problems(k_least + line);
        const auto gone =
            std::find_if(all.begin(), all.end(), [](const Problem& one) { return one.what == "is no longer a key"; });
        ASSERT_NE(gone, all.end()) << line;
        EXPECT_NE(gone->remedy.find(remedy), std::string::npos) << gone->remedy;
    }
}

}  // namespace
}  // namespace frana
