// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <regex>
#include <sstream>

#include "app/pictures/animation.h"
#include "app/pictures/map_source.h"
#include "params/grammar/value_text.h"
#include "support/checked_scene.h"
#include "support/problems.h"

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

class Render : public CheckedScene {
  protected:
    void SetUp() override {
        write_scene("frame-interval = 1\n[output]\nmaps = off\nanimation = off\nreport = off\n");
        ran();
    }
};

TEST_F(Render, MapsOfAnExistingResult) {
    const Outcome outcome =
        succeeded(frana({"render", "result", "--map", "max_depth", "--map", "max_velocity", "--size", "640x480"}));
    EXPECT_EQ(outcome.out, "result/maps/max_depth.png\nresult/maps/max_velocity.png\n");
    EXPECT_EQ(png_size(path("result/maps/max_depth.png")), (std::pair{640, 480}));
    EXPECT_FALSE(fs::exists(path("result/maps/final_depth.png")));
}

TEST_F(Render, ViewAndAnimation) {
    succeeded(frana({"render", "result", "--view", "3d", "--map", "max_depth", "--size", "640x480"}));
    EXPECT_EQ(png_size(path("result/maps/max_depth_3d.png")), (std::pair{640, 480}));
    succeeded(frana({"render", "result", "--animation", "film.gif", "--size", "640x480"}));
    EXPECT_EQ(read_text(path("film.gif")).substr(0, 3), "GIF");
}

// The figures beside a map of one time are those of that time, not of the end.
TEST_F(Render, AFrameShowsItsOwnFigures) {
    const Outcome outcome = succeeded(frana({"render", "result", "--map", "depth@2", "--map", "max_depth", "--format",
                                             "svg", "--size", "1600x1200", "--out", "frame"}));
    std::smatch found;
    ASSERT_TRUE(std::regex_search(outcome.out, found, std::regex("depth_t([0-9.]+)\\.svg"))) << outcome.out;
    const double time = std::stod(found[1]);
    // time_s, step, dt_s, volume_m3, volume_left_m3, max_depth_m, max_speed_ms, front_distance_m, energy, area
    double nearest = 1e9, front = 0, last_front = 0;
    std::istringstream rows(read_text(path("result/timeseries.csv")));
    std::string row;
    std::getline(rows, row);
    while (std::getline(rows, row)) {
        std::vector<double> cells;
        std::istringstream columns(row);
        for (std::string cell; std::getline(columns, cell, ',');) cells.push_back(std::stod(cell));
        if (std::abs(cells.at(0) - time) < nearest) front = cells.at(7);
        nearest = std::min(nearest, std::abs(cells.at(0) - time));
        last_front = cells.at(7);
    }
    ASSERT_LT(nearest, 0.01) << "the name of the file has six digits of the time";
    ASSERT_GT(last_front, front + 2);
    const std::string page = read_text(path("frame/depth_t" + found[1].str() + ".svg"));
    EXPECT_NE(page.find(">Front distance: " + std::to_string(std::lround(front)) + " m</text>"), std::string::npos);
    EXPECT_EQ(page.find(">Run-out"), std::string::npos);
    const std::string whole = read_text(path("frame/max_depth.svg"));
    EXPECT_NE(whole.find(">Run-out"), std::string::npos);
    EXPECT_EQ(whole.find(">Front distance"), std::string::npos);
}

TEST_F(Render, AFilmAndItsLegendAreNamedAfterWhatItShows) {
    const app::ResultReader result(path("result"));
    for (const auto& [quantity, title] : {std::pair{"depth", "Flow depth"}, {"velocity", "Flow velocity"}}) {
        const app::MapLayer layer = app::animation_source(result, result.map_source(), quantity, {640, 480}).layer;
        EXPECT_EQ(layer.title, title);
        EXPECT_TRUE(layer.legend_title.starts_with(title)) << layer.legend_title;
    }
}

/// A flow of the given length and width, its axis turned anticlockwise from east.
render::MapSpec map_of_flow(double length, double width, double deg, const std::string& size = "auto") {
    static app::MapSource source;
    static app::MapLayer layer;
    source = {};
    layer = {};
    source.style.size = *size_from_text(size);
    layer.values = Raster(GridSpec{0, 2000, 10, 200, 200, ""}, k_no_data);
    for (std::int64_t row = 0; row < 200; ++row)
        for (std::int64_t column = 0; column < 200; ++column) {
            const Point at = layer.values.grid.cell_centre(row, column);
            const double turn = deg * 3.14159265 / 180, x = at.x - 1000, y = at.y - 1000;
            if (std::abs(x * std::cos(turn) + y * std::sin(turn)) < length / 2 &&
                std::abs(y * std::cos(turn) - x * std::sin(turn)) < width / 2)
                layer.values.at(row, column) = 1;
        }
    source.extent = layer.values;
    return app::map_spec(source, layer);
}

// The page stands or lies as the flow does.
TEST(PageOfAFlow, FollowsTheFlow) {
    const render::MapSpec across = map_of_flow(1600, 500, 0), upright = map_of_flow(1600, 500, 90),
                          round = map_of_flow(900, 800, 42);
    EXPECT_EQ((std::pair{across.width, across.height}), (std::pair{1754, 1240}));
    EXPECT_EQ((std::pair{upright.width, upright.height}), (std::pair{1240, 1754}));
    EXPECT_EQ(upright.print.sheet, "A4-portrait");
    EXPECT_GT(round.width, round.height);
    EXPECT_EQ(map_of_flow(1600, 500, 90, "800x600").width, 800) << "a size in pixels stays";
}

TEST(FilmPace, IsTheMotionNotTheClock) {
    // Twice as much moves before the third frame as before the second; after the fourth nothing that could be seen.
    const std::vector<double> moved{0, 10, 30, 40, 40, 40.01};
    const std::vector<int> pictures = app::pictures_of_frames(moved, 201);
    EXPECT_EQ(pictures, (std::vector<int>{50, 100, 50, 0, 0, 1}));
    EXPECT_EQ(app::pictures_of_frames({0, 0, 0}, 200), (std::vector<int>{0, 0, 1})) << "nothing moves";
    EXPECT_EQ(app::pictures_of_frames({0}, 6), std::vector<int>{1});
    // Whatever the frames, equal parts of the film have equal parts of the motion, to a picture.
    std::vector<double> uneven{0};
    for (int i = 1; i < 60; ++i) uneven.push_back(uneven.back() + 1.0 / (1 + (i * 37) % 11));
    const std::vector<int> counts = app::pictures_of_frames(uneven, 200);
    double played = 0;
    for (std::size_t i = 0; i < uneven.size(); ++i) {
        EXPECT_NEAR(played / 199, uneven[i] / uneven.back(), 0.5 / 199 + 1e-12);
        played += counts[i];
    }
    EXPECT_EQ(played, 200);
}

TEST_F(Render, AnyRasterOfTheResultAndAnyTime) {
    const Outcome outcome =
        succeeded(frana({"render", "result", "--map", "release", "--map", "depth@2.1", "--size", "640x480"}));
    // The first state at or after 2 s, with its true time.
    EXPECT_TRUE(std::regex_match(outcome.out,
                                 std::regex("result/maps/release\\.png\nresult/maps/depth_t2(\\.[0-9]+)?\\.png\n")))
        << outcome.out;
    const Outcome all = succeeded(frana({"render", "result", "--size", "640x480", "--out", "all"}));
    for (const std::string name :
         {"max_depth", "max_velocity", "final_depth", "arrival_time", "max_pressure", "release"})
        EXPECT_TRUE(fs::exists(path("all/" + name + ".png"))) << name;
    EXPECT_FALSE(fs::exists(path("all/dtm.png")));
}

TEST_F(Render, WithoutAMapDrawsTheRunsRastersAndNoUsersOnes) {
    for (const char* name : {"mine.tif", "max_depth_mine.tif"})
        fs::copy_file(path("result/max_depth.tif"), path(std::string("result/") + name));
    write("result/photo.tif", "no raster at all");
    const Outcome all = succeeded(frana({"render", "result", "--size", "640x480", "--out", "all"}));
    EXPECT_TRUE(fs::exists(path("all/max_depth.png")));
    for (const char* name : {"mine.png", "max_depth_mine.png", "photo.png"})
        EXPECT_FALSE(fs::exists(path(std::string("all/") + name))) << name;
    // Requested by its name it is drawn.
    succeeded(frana({"render", "result", "--map", "mine", "--size", "640x480", "--out", "all"}));
    EXPECT_TRUE(fs::exists(path("all/mine.png")));
}

TEST_F(Render, PagesAndFormats) {
    succeeded(frana({"render", "result", "--map", "max_depth", "--size", "A4", "--format", "png", "--format", "pdf",
                     "--attribution", "Terrain: survey of 2019", "--out", "page"}));
    EXPECT_EQ(png_size(path("page/max_depth.png")), (std::pair{1754, 1240}));
    EXPECT_EQ(read_text(path("page/max_depth.pdf")).substr(0, 5), "%PDF-");
}

TEST_F(Render, Charts) {
    const Outcome charts = succeeded(frana({"render", "result", "--charts", "--size", "640x480"}));
    expect_words(charts.out, {"result/charts/profile_flow_path.png", "result/charts/timeseries.png"});
}

TEST_F(Render, AnimationsOfMapsAndViews) {
    const Outcome map = succeeded(frana({"render", "result", "--animation", "map.mp4", "--size", "640x480"}));
    EXPECT_EQ(read_text(path("map.mp4")).substr(4, 4), "ftyp");
    const Outcome view = succeeded(frana(
        {"render", "result", "--animation", "view.gif", "--view", "3d", "--map", "velocity", "--size", "640x480"}));
    EXPECT_EQ(read_text(path("view.gif")).substr(0, 3), "GIF");
}

TEST_F(Render, RastersOfOtherProgramsOverATerrain) {
    const Outcome outcome = succeeded(
        frana({"render", "result/max_velocity.tif", "--dtm", "dtm.asc", "--size", "640x480", "--out", "foreign"}));
    EXPECT_EQ(outcome.out, "foreign/max_velocity.png\n");
}

TEST_F(Render, ErrorsAreRefused) {
    expect_words(describe(refusal({"render", "result", "--map", "depth_max"}).at(0)), {"max_depth, max_velocity"});
    EXPECT_TRUE(has_problem(refusal({"render", "result", "--view", "4d"}), "--view", "4d", "2d, 3d"));
    EXPECT_TRUE(has_problem(refusal({"render", "result", "--animation", "film.avi"}), "--animation", "film.avi",
                            "FILE.mp4, FILE.gif"));
    EXPECT_FALSE(fs::exists(path("film.avi")));
    // All at once.
    const std::vector<Problem> several = refusal({"render", "result", "--size", "12", "--format", "bmp", "--camera",
                                                  "up", "--exaggeration", "99", "--background", "none.tif"});
    for (const std::string option : {"--size", "--format", "--camera", "--exaggeration"})
        EXPECT_TRUE(has_problem(several, option)) << option;
    EXPECT_TRUE(std::any_of(several.begin(), several.end(),
                            [](const Problem& one) { return one.where.text.starts_with("--background"); }));
    EXPECT_TRUE(has_problem(refusal({"render", "result", "--charts", "--map", "max_depth"}), "--charts"));
    EXPECT_TRUE(has_problem(refusal({"render", "result", "--map", "depth@soon"}), "--map", "depth@soon"));
    expect_words(describe(refusal({"render", "result", "--map", "particles@1"}).at(0)), {"particles-gpkg"});
    EXPECT_TRUE(has_problem(refusal({"render", "result/max_velocity.tif", "--view", "3d"}), "--view", "3d"));
    EXPECT_TRUE(has_problem(refusal({"render", "result/max_velocity.tif", "--map", "max_depth"}), "--map"));
}

TEST_F(Render, MapsOfOneResultShareTheirWindow) {
    // A map drawn alone or in a series is the same, byte for byte.
    succeeded(frana({"render", "result", "--size", "640x480", "--map", "max_depth", "--map", "max_velocity", "--map",
                     "depth@1", "--out", "series"}));
    succeeded(frana({"render", "result", "--size", "640x480", "--map", "max_velocity", "--out", "alone"}));
    succeeded(frana({"render", "result", "--size", "640x480", "--map", "depth@1", "--out", "alone"}));
    EXPECT_EQ(read_text(path("series/max_velocity.png")), read_text(path("alone/max_velocity.png")));
    EXPECT_EQ(read_text(path("series/depth_t1.png")), read_text(path("alone/depth_t1.png")));
}

}  // namespace
}  // namespace frana::test
