// SPDX-License-Identifier: Apache-2.0
// A single read of the file with a map's outlines fails: the map is drawn completely or not at all.
#include <cerrno>

#include "trial_ground.h"
#include "trials.h"

namespace frana::test {
namespace {

constexpr const char* k_outlines = "extent.gpkg";

class ReadError : public TrialGround {
  protected:
    /// A command that draws a map, and the path of the map.
    struct Drawing {
        std::vector<std::string> arguments;
        std::string begins_in, map;
    };
    [[nodiscard]] Ending draw(const Drawing& drawing, const Judge& judge) const {
        restore(drawing.begins_in);
        return run({drawing.arguments}, {false, true, false}, judge);
    }
    [[nodiscard]] std::string map_of(const Drawing& drawing) const { return read_text(at(drawing.map)); }
    void attempt(const Drawing& drawing, const SystemCall& read, int error, const std::string& expected,
                 Trials& trials) const {
        SCOPED_TRACE(drawing.arguments.front() + ", " + read.text() + ": " + std::to_string(error));
        const Ending ending = draw(drawing, [&](const SystemCall& now) {
            return now == read ? Answer{Answer::Kind::fail, error} : Answer{};
        });
        trials.ended(ending.exit_code);
        if (ending.exit_code != 0) {
            EXPECT_NE(ending.err.find(k_outlines), std::string::npos) << ending.err;
        } else if (!fs::exists(at(drawing.map))) {  // a picture fails no run
            EXPECT_NE(read_text(at("out/r/log.txt")).find("could not be drawn"), std::string::npos);
        } else {
            EXPECT_TRUE(map_of(drawing) == expected) << "exit code 0, and another map";
        }
    }

    RandomNumbers random_{trial_seed(), 9};
};

TEST_F(ReadError, InOutlinesNeverRemovesThemFromAMap) {
    if (!can_watch_calls()) GTEST_SKIP() << "this system does not let a program's calls be watched (seccomp)";
    Trials trials;
    for (const Drawing& drawing :
         {Drawing{{"render", "out/r", "--map", "max_depth", "--size", "640x480", "--out", "out/drawn"},
                  "older",
                  "out/drawn/max_depth.png"},
          Drawing{{"run", "in/scene.ini", "--out", "out/r", "--quiet", "--overwrite"},
                  "older alone",
                  "out/r/maps/max_depth.png"}}) {
        const Ending whole = draw(drawing, [](const SystemCall&) { return Answer{}; });
        ASSERT_EQ(whole.exit_code, 0) << whole.err;
        const std::string expected = map_of(drawing);
        std::vector<SystemCall> reads;
        for (const SystemCall& call : whole.calls)
            if (call.path.ends_with(k_outlines)) reads.push_back(call);
        ASSERT_GT(reads.size(), 10U);
        for (int k = 0; k < trial_count(4); ++k) {
            trials.begin("errors while outlines are read for a map");
            attempt(drawing, reads[random_.below(reads.size())], random_.once_in(2) ? EIO : EINTR, expected, trials);
        }
    }
}

}  // namespace
}  // namespace frana::test
