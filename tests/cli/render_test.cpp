// SPDX-License-Identifier: Apache-2.0
#include "tiny_scene.h"

namespace frana::test {
namespace {

namespace fs = std::filesystem;

/// Width and height from a PNG's header.
std::pair<int, int> png_size(const std::string& path) {
    const std::string bytes = read_text(path);
    if (bytes.size() < 24 || bytes.compare(1, 3, "PNG") != 0) return {0, 0};
    const auto number = [&](std::size_t at) {
        int value = 0;
        for (std::size_t i = 0; i < 4; ++i) value = value * 256 + static_cast<unsigned char>(bytes[at + i]);
        return value;
    };
    return {number(16), number(20)};
}

class Render : public TinyScene {
  protected:
    void SetUp() override {
        write_scene("frame-interval = 1\n[output]\nmaps = off\nanimation = off\n");
        ASSERT_EQ(frana({"run", "scene.ini", "--out", "result", "--quiet"}).exit_code, 0);
    }
};

TEST_F(Render, MapsOfAnExistingResult) {
    const Outcome outcome =
        frana({"render", "result", "--map", "max_depth", "--map", "max_velocity", "--size", "800x600"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "result/maps/max_depth.png\nresult/maps/max_velocity.png\n");
    EXPECT_EQ(png_size(path("result/maps/max_depth.png")), (std::pair{800, 600}));
    EXPECT_FALSE(fs::exists(path("result/maps/final_depth.png")));
}

TEST_F(Render, ViewAndFilm) {
    EXPECT_EQ(
        frana({"render", "result", "--view", "3d", "--map", "max_depth", "--size", "800x600"}).exit_code, 0);
    EXPECT_EQ(png_size(path("result/maps/max_depth_3d.png")), (std::pair{800, 600}));
    EXPECT_EQ(frana({"render", "result", "--animation", "film.gif", "--size", "640x480"}).exit_code, 0);
    EXPECT_EQ(read_text(path("film.gif")).substr(0, 3), "GIF");
}

TEST_F(Render, MistakesAreRefused) {
    const Outcome unknown = frana({"render", "result", "--map", "depth_max"});
    EXPECT_EQ(unknown.exit_code, 2);
    EXPECT_NE(unknown.err.find("max_depth, max_velocity"), std::string::npos) << unknown.err;
    EXPECT_EQ(frana({"render", "result", "--view", "4d"}).exit_code, 2);
    EXPECT_EQ(frana({"render", "result", "--size", "12"}).exit_code, 2);
    EXPECT_EQ(frana({"render", "result", "--animation", "film.avi"}).exit_code, 2);
    EXPECT_FALSE(fs::exists(path("film.avi")));
}

}  // namespace
}  // namespace frana::test
