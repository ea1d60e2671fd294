// SPDX-License-Identifier: Apache-2.0
// A result that has its name survives a power failure: each of its files and folders was synced to the disk before.
#include <algorithm>

#include "trial_ground.h"

namespace frana::test {
namespace {

class OnDisk : public TrialGround {
  protected:
    /// Whether a path was synced to the disk before the last call that satisfies `then`.
    template <class Then>
    static bool is_synced_before(const std::vector<SystemCall>& calls, const std::string& path, const Then& then) {
        const auto last = std::find_if(calls.rbegin(), calls.rend(), then);
        EXPECT_NE(last, calls.rend());
        return std::any_of(last, calls.rend(),
                           [&](const SystemCall& call) { return call.name == "fsync" && call.path == path; });
    }
};

TEST_F(OnDisk, IsEveryFileOfAResultBeforeItHasItsName) {
    if (!can_watch_calls()) GTEST_SKIP() << "this system does not let a program's calls be watched (seccomp)";
    restore("inputs");
    const Ending ending = run({{"run", "in/scene.ini", "--out", "out/r", "--set",
                                "output.formats=geotiff, particles-gpkg", "--set", "output.animation=on"}},
                              {}, [](const SystemCall&) { return Answer{}; });
    ASSERT_EQ(ending.exit_code, 0) << ending.err;
    const auto takes_name = [](const SystemCall& call) {
        return call.name.rfind("rename", 0) == 0 && call.path == "out/r";
    };
    int files = 0;
    for (const auto& [name, content] :
         part_of(state(), [](const auto& path) { return path.rfind("out/r/", 0) == 0; })) {
        std::string made = "out/r.partial/" + name.substr(std::string("out/r/").size());
        if (made.ends_with("/")) made.pop_back();
        if (made.ends_with("/manifest.json")) continue;  // without a name until it is complete
        EXPECT_TRUE(is_synced_before(ending.calls, made, takes_name)) << name;
        ++files;
    }
    EXPECT_GT(files, 20);
    EXPECT_TRUE(is_synced_before(ending.calls, "out/r.partial", takes_name));
    EXPECT_FALSE(is_synced_before(ending.calls, "out", takes_name));  // the name itself: after that
    EXPECT_TRUE(std::any_of(ending.calls.begin(), ending.calls.end(),
                            [](const SystemCall& call) { return call.name == "fsync" && call.path == "out"; }));
}

TEST_F(OnDisk, IsAPictureBeforeTheResultListsIt) {
    if (!can_watch_calls()) GTEST_SKIP() << "this system does not let a program's calls be watched (seccomp)";
    restore("older");
    const Ending ending = run({{"render", "out/r", "--map", "max_velocity", "--size", "640x480"}}, {},
                              [](const SystemCall&) { return Answer{}; });
    ASSERT_EQ(ending.exit_code, 0) << ending.err;
    EXPECT_TRUE(is_synced_before(ending.calls, "out/r/maps/max_velocity.png", [](const SystemCall& call) {
        return call.name.rfind("rename", 0) == 0 && call.path == "out/r/manifest.json";
    }));
}

}  // namespace
}  // namespace frana::test
