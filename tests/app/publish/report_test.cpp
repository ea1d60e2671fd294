// SPDX-License-Identifier: Apache-2.0
#include "params/keys/scene_parameters.h"
#include "support/tiny_scene.h"

namespace frana::test {
namespace {

std::size_t count(const std::string& text, const std::string& word) {
    std::size_t n = 0;
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++n;
    return n;
}

using Report = TinyScene;

TEST_F(Report, ContainsEverythingInOneFile) {
    write_polygon("scar", {{15, 50}, {180, 50}, {180, 100}, {15, 100}});
    write_scene(
        "frame-interval = 1\n[output]\nanimation = off\nmap-size = 800x600\nmaps = max_depth, max_velocity\n"
        "title = Slope <5> & \"more\"\n[hazard]\nscheme = swiss-flood\n[scar]\nperimeter = scar.geojson\n");
    const Outcome outcome = frana({"run", "scene.ini", "--out", "result", "--quiet", "--set", "numerics.cfl=0.4"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const std::string page = read_text(path("result/report.html"));
    EXPECT_EQ(page.rfind("<!DOCTYPE html>", 0), 0U);
    EXPECT_NE(page.find("<h1>Slope &lt;5&gt; &amp; &quot;more&quot;</h1>"), std::string::npos);
    // Self-contained: pictures inside, nothing fetched.
    EXPECT_EQ(count(page, "src=\"data:image/png;base64,iVBORw0KGgo"), 4U) << "intensity, two maps and the comparison";
    EXPECT_EQ(count(page, "src="), 4U);
    EXPECT_EQ(count(page, "href="), 0U);
    EXPECT_EQ(count(page, "<script"), 0U);
    EXPECT_EQ(count(page, "url("), 0U);
    EXPECT_NE(page.find("@media print"), std::string::npos);
    for (const Parameter& parameter : scene_parameters())
        EXPECT_NE(page.find("<td>" + parameter.name() + "</td>"), std::string::npos) << parameter.name();
    EXPECT_NE(page.find("<tr class=\"given\"><td>numerics.cfl</td><td>0.4</td><td></td><td>command line</td>"),
              std::string::npos);
    EXPECT_NE(page.find("<tr class=\"given\"><td>material.friction-angle</td><td>15</td><td>degrees</td><td>scene "
                        "file</td>"),
              std::string::npos);
    EXPECT_NE(page.find("<tr><td>material.density</td><td>2000</td><td>kg/m3</td><td>default</td>"), std::string::npos);
    for (const std::string words : {"EPSG:32632", "dtm.asc", "perimeter.geojson", "scar.geojson", "Mass budget",
                                    "still moves", "Jaccard index", "High intensity", "Depths clamped"})
        EXPECT_NE(page.find(words), std::string::npos) << words;
    // Every table and paragraph that is opened is closed.
    for (const std::string tag : {"table", "tr", "td", "svg", "figure", "h2", "p"})
        EXPECT_EQ(count(page, "<" + tag + ">") + count(page, "<" + tag + " "), count(page, "</" + tag + ">")) << tag;
}

// A browser displays PNG: pictures in other formats are also drawn for the page.
TEST_F(Report, ShowsPicturesRequestedInOtherFormats) {
    write_polygon("scar", {{15, 50}, {180, 50}, {180, 100}, {15, 100}});
    write_scene(
        "[output]\nanimation = off\ncharts = off\nmap-size = 640x480\nmaps = max_depth, "
        "max_depth_3d\nmap-formats = pdf\n"
        "[scar]\nperimeter = scar.geojson\n");
    const Outcome outcome = frana({"run", "scene.ini", "--out", "result", "--quiet"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const std::string page = read_text(path("result/report.html"));
    for (const std::string name : {"max_depth", "max_depth_3d", "comparison"})
        EXPECT_EQ(count(page, "<img alt=\"" + name + "\" src=\"data:image/png;base64,iVBORw0KGgo"), 1U) << name;
    EXPECT_EQ(page.find("No map could be drawn"), std::string::npos);
    for (const std::string& name : files()) {
        EXPECT_FALSE(name.ends_with(".png")) << name;
        EXPECT_EQ(name.find("report_pictures"), std::string::npos) << name;
    }
}

TEST_F(Report, IsWrittenOnlyOnRequest) {
    write_scene(k_numbers_only + "report = off\n");
    ASSERT_EQ(frana({"run", "scene.ini", "--out", "result", "--quiet"}).exit_code, 0);
    EXPECT_FALSE(std::filesystem::exists(path("result/report.html")));
    write_scene(k_numbers_only);
    ASSERT_EQ(frana({"run", "scene.ini", "--out", "other", "--quiet"}).exit_code, 0);
    EXPECT_NE(read_text(path("other/report.html")).find("The scene asks for no maps."), std::string::npos);
}

}  // namespace
}  // namespace frana::test
