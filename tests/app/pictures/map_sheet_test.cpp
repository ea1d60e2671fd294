// SPDX-License-Identifier: Apache-2.0
// Maps as they are handed over: scale on paper, title block, one frame for all pages, differences of results.
#include <gdal.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <regex>

#include "gis/raster/raster_in.h"
#include "support/files.h"
#include "support/pdf_check.h"
#include "support/tiny_scene.h"

namespace frana::test {
namespace {

namespace fs = std::filesystem;

using Words = std::vector<std::string>;

/// Size in pixels and geotransform of a raster or of a geospatial PDF drawn at 150 dots per inch.
struct Placed {
    int columns = 0, rows = 0;
    std::array<double, 6> geo{};
};
Placed placed(const std::string& file) {
    GDALAllRegister();
    const std::unique_ptr<void, decltype(&GDALClose)> data(GDALOpen(file.c_str(), GA_ReadOnly), &GDALClose);
    Placed result;
    EXPECT_TRUE(data) << file;
    if (!data) return result;
    EXPECT_EQ(GDALGetGeoTransform(data.get(), result.geo.data()), CE_None) << file;
    result.columns = GDALGetRasterXSize(data.get());
    result.rows = GDALGetRasterYSize(data.get());
    return result;
}

class MapSheet : public TinyScene {
  protected:
    void run(const std::string& more, const std::string& result = "result") const {
        write_scene("frame-interval = 1\n[output]\nmaps = off\nanimation = off\ncharts = off\nreport = off\n" + more);
        ran(result);
    }
    [[nodiscard]] Outcome render(Words more, const std::string& result = "result") const {
        return frana(with_more({"render", result}, more));
    }
    [[nodiscard]] std::string svg_of(Words more, const std::string& name = "max_depth") const {
        more.insert(more.end(), {"--map", name, "--format", "svg", "--out", "svg"});
        succeeded(render(std::move(more)));
        return read_text(path("svg/" + name + ".svg"));
    }
};

TEST_F(MapSheet, MetresPerMillimetreAreExact) {
    run("");
    succeeded(render({"--map", "max_depth", "--size", "A4", "--scale", "2000", "--format", "pdf", "--format", "svg",
                      "--out", "sheet"}));
    constexpr double k_dots_per_millimetre = 150 / 25.4;
    // The page is a whole number of pixels: 1754 of them are 297.0 mm within a pixel in ten thousand.
    const Placed map = placed(path("sheet/max_depth.pdf"));
    EXPECT_NEAR(map.geo[1] * k_dots_per_millimetre, 2, 2e-4);
    EXPECT_NEAR(-map.geo[5] * k_dots_per_millimetre, 2, 2e-4);
    expect_words(read_text(path("sheet/max_depth.svg")), {">1 : 2 000</text>", ">on A4</text>"});
}

// GDAL reads from a turned map's geospatial PDF where its pixels are on the ground.
TEST_F(MapSheet, ATurnedMapIsWhereItsFilesSay) {
    run("");
    for (const double turn : {30.0, -100.0}) {
        succeeded(render({"--map", "max_depth", "--size", "A4", "--turn", std::to_string(turn), "--format", "pdf",
                          "--format", "png", "--out", "turned"}));
        const Placed page = placed(path("turned/max_depth.pdf"));
        const double angle = turn * std::numbers::pi / 180, metre = std::hypot(page.geo[1], page.geo[4]);
        // A step to the right on the page goes `turn` anticlockwise from east on the ground, a step down at right
        // angles. PDFs keep degrees with few digits.
        EXPECT_NEAR(page.geo[1], metre * std::cos(angle), 1e-3 * metre);
        EXPECT_NEAR(page.geo[4], metre * std::sin(angle), 1e-3 * metre);
        EXPECT_NEAR(page.geo[2], metre * std::sin(angle), 1e-3 * metre);
        EXPECT_NEAR(page.geo[5], -metre * std::cos(angle), 1e-3 * metre);
        std::array<double, 6> to_page{};
        ASSERT_EQ(GDALInvGeoTransform(const_cast<double*>(page.geo.data()), to_page.data()), 1);
        // Where the flow was deep, the pixel has the colour of a class; far from it, the grey of the relief.
        const Raster depth = gis::read_result_raster(path("result/max_depth.tif"));
        const auto pixels = gis::test::pixels_of(path("turned/max_depth.png"));
        int coloured = 0, checked = 0;
        for (std::int64_t row = 1; row + 1 < depth.grid.rows; ++row)
            for (std::int64_t column = 1; column + 1 < depth.grid.columns; ++column) {
                bool is_deep = true, is_dry = true;
                for (int i = -1; i <= 1; ++i)
                    for (int j = -1; j <= 1; ++j) {
                        const double value = depth.at(row + i, column + j);
                        is_deep = is_deep && value > 0.1;
                        is_dry = is_dry && std::isnan(value);
                    }
                if (!is_deep && !is_dry) continue;
                const Point place = depth.grid.cell_centre(row, column);
                double x = 0, y = 0;
                GDALApplyGeoTransform(to_page.data(), place.x, place.y, &x, &y);
                x *= static_cast<double>(pixels.width) / page.columns;
                y *= static_cast<double>(pixels.height) / page.rows;
                if (x < 0 || y < 0 || x >= pixels.width || y >= pixels.height) continue;
                const std::uint8_t* p =
                    pixels.rgb.data() + 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(pixels.width) +
                                             static_cast<std::size_t>(x));
                const bool is_grey = std::max({p[0], p[1], p[2]}) - std::min({p[0], p[1], p[2]}) < 16;
                ++checked;
                coloured += is_grey != is_deep;
            }
        EXPECT_GT(checked, 200);
        // Outlines and their names stand over some cells.
        EXPECT_GT(coloured, 0.9 * checked) << turn;
    }
    succeeded(render({"--map", "max_depth", "--turn", "auto", "--out", "along"}));
    refusal_of(render({"--map", "max_depth", "--view", "3d", "--turn", "30", "--out", "none"}),
               {"--turn: is for maps only"});
    for (const char* wrong : {"north", "181"}) {
        refusal_of(render({"--map", "max_depth", "--turn", wrong, "--out", "none"}), {"--turn: is not a turn"});
    }
    EXPECT_FALSE(fs::exists(path("none")));
}

TEST_F(MapSheet, EveryPageStatesItsScale) {
    run("");
    const std::string svg = svg_of({"--size", "A4-portrait"});
    EXPECT_TRUE(std::regex_search(svg, std::regex(">1 : [0-9 ]+</text>")));
    EXPECT_NE(svg.find(">on A4</text>"), std::string::npos);
    // Pixels have the scale of their print size.
    const std::string pixels = svg_of({"--size", "1600x1200"});
    EXPECT_NE(pixels.find(">printed 27.1 \u00D7 20.3 cm</text>"), std::string::npos);
    EXPECT_TRUE(std::regex_search(pixels, std::regex(">1 : [0-9 ]+</text>")));
}

TEST_F(MapSheet, ScalesThatCannotBeAreRefusedBeforeAnythingIsDrawn) {
    run("");
    const struct {
        Words words;
        std::vector<const char*> said;
    } cases[] = {
        {{"--scale", "5000", "--size", "800x600"}, {"needs a paper size", "Add --size A4@300"}},
        {{"--scale", "50", "--size", "A4"}, {"is not a scale", "the n of 1 : n, 100"}},
        {{"--scale", "x", "--size", "A4"}, {"is not a scale"}},
        {{"--scale", "200", "--size", "A4-portrait"},
         {"the flow does not fit A4-portrait at this scale", "--scale", "at least 1 : ", "Take 1 : "}},
    };
    for (const auto& one : cases) {
        Words words{"--map", "max_depth", "--out", "none"};
        words.insert(words.end(), one.words.begin(), one.words.end());
        const Outcome outcome = refusal_of(render(words));
        for (const char* said : one.said) EXPECT_NE(outcome.err.find(said), std::string::npos) << said << outcome.err;
    }
    EXPECT_FALSE(fs::exists(path("none")));
}

TEST_F(MapSheet, AScaleAtWhichNotEvenTheReleaseFitsIsRefusedByCheck) {
    write_scene("[output]\nmaps = on\n");
    const auto check = [&](const std::string& scale) {
        return frana({"check", "scene.ini", "--set", "output.map-size=A4", "--set", "output.map-scale=" + scale});
    };
    const Outcome outcome = check("100");  // a sheet of 30 m by 21 m
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_NE(outcome.err.find("output.map-scale: not even the release fits A4 at this scale (value 1 : 100"),
              std::string::npos)
        << outcome.err;
    succeeded(check("5000"));
}

// That is known only after the run: the maps are there all the same, and a warning says at which scale.
TEST_F(MapSheet, AScaleThatDoesNotHoldTheFlowIsReplacedAfterTheRun) {
    write_scene(
        "[output]\nmaps = max_depth, max_velocity\nanimation = off\ncharts = off\nmap-size = A4\n"
        "map-scale = 400\nmap-formats = svg\n");
    succeeded(frana({"check", "scene.ini"}));
    const Outcome outcome = succeeded(frana({"run", "scene.ini", "--out", "result"}));
    const std::string start = "output.map-scale = 400 does not hold the flow; drawn at ";
    const std::regex said(start + "(1 : [0-9 ]*[0-9])");
    std::smatch scale;
    ASSERT_TRUE(std::regex_search(outcome.err, scale, said)) << outcome.err;
    for (const char* map : {"max_depth", "max_velocity"})
        EXPECT_NE(read_text(path("result/maps/" + std::string(map) + ".svg")).find(">" + scale[1].str() + "</text>"),
                  std::string::npos)
            << map << " at " << scale[1];
    for (const char* file : {"result/summary.json", "result/report.html"}) {
        const std::string text = read_text(path(file));
        const std::size_t at = text.find(start);
        EXPECT_NE(at, std::string::npos) << file;
    }
    // The next round one above: a result is drawn at that scale, and refused at the one before.
    refusal_of(render({"--map", "max_depth", "--out", "none"}), {"Take " + scale[1].str()});
}

TEST_F(MapSheet, TitleBlockAndSources) {
    gis::test::TestRaster raster;
    raster.columns = 40;
    raster.rows = 20;
    raster.bytes = true;
    raster.values.assign(800, 90);
    gis::test::make_raster(path("logo.tif"), raster);
    gis::test::copy_as(path("logo.tif"), path("logo.png"), "PNG");
    gis::test::copy_as(path("logo.tif"), path("logo.jpg"), "JPEG");
    run("map-author = A. Rossi\nmap-logo = logo.png\n"
        "[terrain]\nsource = Lidar 2019, CC BY 4.0\n[material]\n");
    const std::string svg = svg_of({"--size", "A4"});
    const std::string summary = read_text(path("result/summary.json"));
    std::smatch date;
    ASSERT_TRUE(std::regex_search(summary, date, std::regex("\"date\": \"([0-9]{4}-[0-9]{2}-[0-9]{2})\"")));
    expect_words(svg, {std::string(">A. Rossi<"), std::string("Terrain: Lidar 2019, CC BY 4.0"),
                       std::string("friction"), std::string("density"), std::string("Voellmy-Bingham")});
    const std::regex day(">20[0-9]{2}-[0-9]{2}-[0-9]{2}<");
    EXPECT_TRUE(std::regex_search(svg, day));
    EXPECT_EQ(svg_of({"--size", "A4"}), svg) << "redrawn it has the same bytes";
    const std::string other =
        svg_of({"--size", "A4", "--author", "B. Bianchi", "--date", "12 May 2031", "--logo", "logo.jpg"});
    expect_words(other, {">B. Bianchi<", ">12 May 2031<"});
    EXPECT_EQ(other.find("A. Rossi"), std::string::npos);
    const std::string none = svg_of({"--size", "A4", "--date", "none", "--logo", "none"});
    EXPECT_FALSE(std::regex_search(none, day));
    for (const char* bad : {"missing.png", "scene.ini", "logo.tif"}) {
        refusal_of(render({"--map", "max_depth", "--logo", bad}), {"--logo"});
    }
}

TEST_F(MapSheet, AllPagesOfAResultShareTheFrame) {
    write_polygon("seen", {{20, 50}, {160, 50}, {160, 100}, {20, 100}});
    run("[hazard]\nscheme = swiss-flood\n[observed]\nperimeter = seen.geojson\n");
    for (const char* size : {"800x600", "A4-portrait"}) {
        succeeded(render({"--map",        "max_depth", "--map",  "max_velocity", "--map",
                          "arrival_time", "--map",     "hazard", "--map",        "comparison",
                          "--map",        "depth@2",   "--map",  "release",      "--format",
                          "pdf",          "--size",    size,     "--out",        std::string("pages") + size}));
        std::optional<Placed> first;
        for (const std::string& file : files()) {
            if (!file.starts_with(std::string("pages") + size) || !file.ends_with(".pdf")) continue;
            const Placed page = placed(path(file));
            if (!first) first = page;
            EXPECT_EQ(page.geo, first->geo) << file;
            EXPECT_EQ(page.columns, first->columns) << file;
            EXPECT_EQ(page.rows, first->rows) << file;
        }
    }
}

TEST_F(MapSheet, HazardMapsGiveTheNumbersOfTheirLimits) {
    write("own.ini", own_scheme("depth > ", "0.5 m", "2 m"));
    run("[hazard]\nscheme = own.ini\n");
    const std::string svg = svg_of({"--size", "1600x1200"}, "hazard");
    expect_words(svg, {"0.5 m", "2 m", ", Own"});
    EXPECT_EQ(svg.find("Class 1"), std::string::npos);
}

TEST_F(MapSheet, ADifferenceIsCentredOnZeroAndOnTheGround) {
    run("title = First\n", "a");
    run("title = Second\n[release]\nvolume = 2000\n", "b");
    succeeded(render({"--difference", "b", "--map", "max_depth", "--format", "svg", "--out", "sheet"}, "a"));
    const std::string svg = read_text(path("sheet/difference_max_depth.svg"));
    expect_words(
        svg, {"-0.2 \u2026 0.2", "&gt; ", "&lt; -", ">A: First<", ">B: Second<", "A − B", "Difference: Maximum depth"});
    // A result minus itself is zero: one colour, that of the middle.
    succeeded(render({"--difference", "a", "--map", "max_depth", "--out", "none"}, "a"));
    const auto same = gis::test::pixels_of(path("none/difference_max_depth.png"));
    int middle = 0, other = 0;
    for (std::size_t i = 0; i + 2 < same.rgb.size(); i += 3) {
        middle += same.rgb[i] == 249 && same.rgb[i + 1] == 248 && same.rgb[i + 2] == 243 ? 1 : 0;
        other += same.rgb[i] == 211 && same.rgb[i + 1] == 115 && same.rgb[i + 2] == 55 ? 1 : 0;
    }
    EXPECT_GT(middle, 2000);
    EXPECT_LT(other, 1000);  // the legend's field alone
}

TEST_F(MapSheet, ADifferenceIsInOneLanguageAndTellsTwoRunsOfOneSceneApart) {
    run("title = Slope\n", "a");
    run("title = Slope\nlanguage = de\n[release]\nvolume = 2000\n", "b");
    for (const auto& [language, release, other_release] :
         {std::tuple{"", "Release: ", "Anrissgebiet: "}, std::tuple{"it", "Area di distacco: ", "Release: "}}) {
        std::vector<std::string> options{"--difference", "b",   "--map", "max_depth",
                                         "--format",     "svg", "--out", "sheet"};
        if (*language != '\0') options.insert(options.end(), {"--language", language});
        succeeded(render(options, "a"));
        const std::string svg = read_text(path("sheet/difference_max_depth.svg"));
        std::string plain;  // a line may be broken anywhere
        for (std::size_t i = 0; i < svg.size(); ++i) {
            if (svg[i] == '<')
                i = svg.find('>', i);
            else if (svg[i] != '\n' || (!plain.empty() && plain.back() != ' '))
                plain += svg[i] == '\n' ? ' ' : svg[i];
        }
        expect_words(plain, {"A: " + std::string(release), "B: " + std::string(release)});
        EXPECT_EQ(svg.find(other_release), std::string::npos) << other_release;
        expect_words(svg, {">A: Slope (a)<", ">B: Slope (b)<"});
    }
}

TEST_F(MapSheet, OnlyTheSameCellsHaveADifference) {
    run("", "a");
    run("[terrain]\ncell-size = 10\n[material]\n", "coarse");
    run("[terrain]\ncrs = EPSG:32633\n[material]\n", "elsewhere");
    const std::pair<const char*, const char*> cases[] = {{"coarse", "has cells of another size"},
                                                         {"elsewhere", "has another coordinate reference system"},
                                                         {"missing", "is not a folder"}};
    for (const auto& [other, said] : cases) {
        refusal_of(render({"--difference", other, "--map", "max_depth", "--out", "none"}, "a"), {said});
    }
    EXPECT_NE(render({"--difference", "coarse"}, "a").err.find("--map max_depth"), std::string::npos);
    refusal_of(render({"--difference", "coarse", "--map", "max_depth", "--view", "3d"}, "a"));
    EXPECT_FALSE(fs::exists(path("none")));
}

TEST_F(MapSheet, CrossSectionsCarryTheirNames) {
    write_features("lines", {{"LineString", {{70, 40}, {70, 110}}, named("bridge")},
                             {"LineString", {{82, 40}, {82, 110}}, named("road")}});
    run("cross-sections = lines.geojson\n");
    const std::string svg = svg_of({"--size", "1600x1200"});
    expect_words(svg, {">bridge<", ">road<"});
}

}  // namespace
}  // namespace frana::test
