// SPDX-License-Identifier: Apache-2.0
// Unusual names of files, folders, gauges and lines by users and their programs, through the whole program.
#include "core/text.h"
#include "support/tiny_scene.h"

namespace frana::test {
namespace {

namespace fs = std::filesystem;

bool is_utf8(const std::string& text) {
    return valid_utf8(text) == text;
}

class HostileNames : public TinyScene {
  protected:
    /// Points or lines by name, along the slope.
    void write_named(const std::string& file, const std::string& type, const std::vector<std::string>& names) const {
        std::vector<TestFeature> features;
        for (const std::string& name : names) {
            const double y = 75 + static_cast<double>(features.size());
            features.push_back({type, type == "Point" ? Places{{80, y}} : Places{{30, y}, {150, y}}, named(name)});
        }
        write_features(file, features);
    }
    [[nodiscard]] Outcome run(const std::string& scene = "scene.ini", const std::string& out = "result") const {
        return frana({"run", scene, "--out", out, "--quiet"});
    }
};

TEST_F(HostileNames, ChartsOfAllProfilesAndNoFormulaInATable) {
    const std::string longest(240, 'n');
    write_named("profiles", "LineString", {"a b", "a_b", "a/b", "=HYPERLINK(1)", longest, "<script>alert(1)</script>"});
    write_named("gauges", "Point", {"@SUM(1)", "-2+3", "plain"});
    write_scene(
        "[output]\nmaps = max_depth\nmap-size = 640x480\nanimation = off\nframes = off\nprofiles = profiles.geojson\n"
        "gauges = gauges.geojson\n");
    const Outcome outcome = succeeded(run());
    EXPECT_EQ(outcome.err.find("could not be drawn"), std::string::npos) << outcome.err;
    std::vector<std::string> charts;
    for (const auto& entry : fs::directory_iterator(path("result/charts"))) charts.push_back(entry.path().filename());
    EXPECT_EQ(charts.size(), 9U) << ::testing::PrintToString(charts);  // flow path, six lines, series, gauges
    EXPECT_NE(std::find(charts.begin(), charts.end(), "profile_a_b.png"), charts.end());
    EXPECT_NE(std::find(charts.begin(), charts.end(), "timeseries.png"), charts.end());
    const std::string table = read_text(path("result/profiles.csv")), gauges = read_text(path("result/gauges.csv"));
    EXPECT_NE(table.find("\n'=HYPERLINK(1),"), std::string::npos);
    EXPECT_EQ(table.find("\n=HYPERLINK"), std::string::npos);
    EXPECT_NE(gauges.find(",'@SUM(1),"), std::string::npos);
    EXPECT_NE(gauges.find(",'-2+3,"), std::string::npos);
    EXPECT_NE(gauges.find(",plain,"), std::string::npos);
    // Drawn again they have the same names.
    const Outcome again = succeeded(frana({"render", "result", "--charts", "--size", "640x480", "--out", "again"}));
    for (const std::string& chart : charts) EXPECT_TRUE(fs::exists(path("again/" + chart))) << chart;
    EXPECT_EQ(read_text(path("result/report.html")).find("<script"), std::string::npos);
}

TEST_F(HostileNames, BytesThatAreNotUtf8) {
    const std::string folder = "caf\xE9 <i>&amp;\"";
    fs::create_directory(path(folder));
    write_scene(
        "frame-interval = 2\n[output]\nmaps = max_depth\nmap-size = 640x480\nmap-formats = png, pdf\n"
        "animation = off\n[scar]\nperimeter = perimeter.geojson\n");
    for (const char* file : {"dtm.asc", "dtm.prj", "perimeter.geojson", "scene.ini"})
        fs::copy(path(file), path(folder + "/" + file));
    succeeded(run(folder + "/scene.ini"));
    EXPECT_NE(json_text(read_text(path("result/summary.json")), "scene").find("caf\\xe9"), std::string::npos);
    for (const std::string& file : files()) {
        const std::string name = fs::path(file).filename();
        const bool text = name.ends_with(".json") || name.ends_with(".html") || name.ends_with(".csv") ||
                          name == "log.txt" || name.ends_with(".qml") || name.ends_with(".sld");
        if (!file.starts_with("result/") || !text) continue;
        EXPECT_TRUE(is_utf8(read_text(path(file)))) << file;
    }
    const std::string report = read_text(path("result/report.html"));
    EXPECT_EQ(report.find("<i>"), std::string::npos);
    EXPECT_NE(report.find("caf\\xe9 &lt;i&gt;&amp;amp;&quot;"), std::string::npos);
    succeeded(frana({"check", "result/scene.ini"}));
    // The scene is preserved byte for byte: it can be run.
    const Outcome again = succeeded(run("result/scene.ini", "again"));
    const auto values = [&](const std::string& result) {
        const std::string text = read_text(path(result + "/scene.ini"));
        return text.substr(text.find("\n[scene]"));
    };
    EXPECT_NE(values("again").find("title = caf\xE9 <i>"), std::string::npos);
    for (const std::string key : {"max_depth_m", "max_velocity_ms", "covered_area_m2", "steps"})
        EXPECT_EQ(json_number(read_text(path("again/summary.json")), key),
                  json_number(read_text(path("result/summary.json")), key))
            << key;
}

TEST_F(HostileNames, ControlCharactersAndMarksOfDirectionInNoPictureOrPage) {
    write_named("profiles", "LineString", {R"(a\u0001b\u202ec)"});
    write_named("gauges", "Point", {R"(g\u001b[2Jh\u200fi)"});
    write_named("sections", "LineString", {R"(s\u0002t\u2067u)"});
    write_scene(
        "[output]\nmaps = max_depth\nmap-size = 640x480\nmap-formats = png, svg\nanimation = off\nframes = off\n"
        "profiles = profiles.geojson\ngauges = gauges.geojson\ncross-sections = sections.geojson\n"
        "title = ev\u202Eent\n");
    const Outcome check = frana({"check", "scene.ini"});
    const Outcome outcome = succeeded(frana({"run", "scene.ini", "--out", "result"}));
    for (const std::string& shown : {check.out, check.err, outcome.err})
        for (const char* mark : {"\x1b", "\x01", "\u202e"}) EXPECT_EQ(shown.find(mark), std::string::npos) << shown;
    int pages = 0;
    for (const std::string& file : files()) {
        if (!file.starts_with("result/") || !(file.ends_with(".svg") || file.ends_with(".html"))) continue;
        ++pages;
        const std::string text = read_text(path(file));
        for (const char c : text) {
            const auto byte = static_cast<unsigned char>(c);
            ASSERT_TRUE(byte >= 0x20 || c == '\n' || c == '\t') << file << ' ' << int(byte);
        }
        for (const char* mark : {"\u202e", "\u200f", "\u2067"}) EXPECT_EQ(text.find(mark), std::string::npos) << file;
    }
    EXPECT_GE(pages, 5);  // report, map, profile, gauges, sections
}

TEST_F(HostileNames, TitlesOfFoldersSurviveTheEcho) {
    for (const std::string folder : {" Val #3 ", "#", " "}) {
        fs::create_directory(path(folder));
        std::string scene = read_text(path("scene.ini"));
        for (const std::string file : {"dtm.asc", "perimeter.geojson"})
            scene.replace(scene.find("= " + file), 2, "= " + folder_.string() + "/");
        write(folder + "/scene.ini", scene);
        const Outcome first = succeeded(run(folder + "/scene.ini", "first"));
        const Outcome second = succeeded(run("first/scene.ini", "second"));
        const auto title = [&](const std::string& result) {
            const std::string text = read_text(path(result + "/scene.ini"));
            const auto at = text.find("\ntitle = ");
            return at == std::string::npos ? "none" : text.substr(at + 1, text.find('\n', at + 1) - at - 1);
        };
        EXPECT_NE(title("first"), "none") << folder;
        EXPECT_EQ(title("first"), title("second")) << folder;
        fs::remove_all(path("first"));
        fs::remove_all(path("second"));
    }
}

// Three thousand letters took half a minute. Of processor time: other programs take the clock's.
TEST_F(HostileNames, LongTitlesAreCutAndFast) {
    write_scene("[output]\nmaps = max_depth\nmap-size = 640x480\nanimation = off\nframes = off\nreport = off\n");
    succeeded(run());
    const auto seconds = [&](const std::string& title) {
        const Outcome outcome =
            succeeded(frana({"render", "result", "--map", "max_depth", "--view", "2d", "--size", "640x480", "--title",
                             title, "--attribution", title, "--out", "drawn"}));
        return outcome.cpu_seconds;
    };
    const double usual = seconds("Slope");
    std::string words;
    while (words.size() < 3000) words += "slope ";
    for (const std::string& title : {std::string(3000, 'w'), words})
        EXPECT_LT(seconds(title), 5 * usual + 2) << title.substr(0, 10);
}

}  // namespace
}  // namespace frana::test
