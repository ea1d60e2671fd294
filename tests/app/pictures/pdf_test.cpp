// SPDX-License-Identifier: Apache-2.0
// Every PDF written by the program shows the same as the PNG beside it, and its texts are texts.
#include "support/pdf_check.h"
#include "support/tiny_scene.h"

namespace frana::test {
namespace {

class Pdf : public TinyScene {
  protected:
    // Returns those below a folder; every one must be valid.
    [[nodiscard]] std::vector<std::string> good_pdfs(const std::string& folder) const {
        std::vector<std::string> found;
        for (const std::string& file : files()) {
            if (!file.starts_with(folder) || !file.ends_with(".pdf")) continue;
            const std::string stem = path(file.substr(0, file.size() - 4));
            found.push_back(file.substr(folder.size()));
            EXPECT_EQ(gis::test::pdf_problems(stem + ".pdf", gis::test::pixels_of(stem + ".png"), 150),
                      std::vector<std::string>{})
                << file;
        }
        return found;
    }
};

TEST_F(Pdf, OfEveryKindShowsWhatItsPngShows) {
    write_polygon("scar", {{20, 50}, {120, 50}, {120, 100}, {20, 100}});
    write_scene(
        "[scar]\nperimeter = scar.geojson\n[output]\nmap-formats = png, pdf\nmap-size = 640x480\n"
        "maps = max_depth, max_depth_3d\nanimation = off\n[time]\nframe-interval = 1\n");
    succeeded(frana({"run", "scene.ini", "--out", "result", "--threads", "2"}));
    EXPECT_EQ(good_pdfs("result/"),
              (std::vector<std::string>{"charts/profile_flow_path.pdf", "charts/scores.pdf", "charts/timeseries.pdf",
                                        "comparison.pdf", "maps/max_depth.pdf", "maps/max_depth_3d.pdf"}));
    const Outcome foreign = succeeded(frana({"render", "result/max_depth.tif", "--dtm", "result/dtm.tif", "--format",
                                             "png", "--format", "pdf", "--size", "640x480", "--out", "foreign"}));
    EXPECT_EQ(good_pdfs("foreign/"), std::vector<std::string>{"max_depth.pdf"});
}

TEST_F(Pdf, CanBeSearchedForTitleNumbersAndNames) {
    write_scene("[output]\nmaps = off\nanimation = off\nreport = off\ncharts = off\n");
    succeeded(frana({"run", "scene.ini", "--out", "result"}));
    const std::vector<std::string> words{"render",   "result", "--map",    "max_depth",
                                         "--size",   "A4",     "--format", "pdf",
                                         "--format", "svg",    "--title",  "Hang \u05d0\u05d1 \u0416 slope"};
    std::vector<std::string> first = words, again = words;
    first.insert(first.end(), {"--out", "first"});
    again.insert(again.end(), {"--out", "again"});
    const Outcome outcome = succeeded(frana(first));
    EXPECT_EQ(outcome.err, "");
    const std::string text = gis::test::pdf_text(path("first/max_depth.pdf"));
    expect_words(text, {"Hang", "\u05d0\u05d1", "\u0416 slope", "Maximum depth, vertical [m]", "0.2 \u2013 0.5",
                        "Release", "EPSG"});
    const std::string svg = read_text(path("first/max_depth.svg"));
    expect_words(svg, {">Hang \u05d0\u05d1 \u0416 slope: Maximum depth</text>", "data:image/png;base64,iVBORw0KGgo"});
    succeeded(frana(again));
    for (const char* file : {"/max_depth.pdf", "/max_depth.svg"})
        EXPECT_EQ(read_text(path(std::string("first") + file)), read_text(path(std::string("again") + file)));
}

TEST_F(Pdf, LettersWithoutFontAreWarnedOf) {
    write_scene("[output]\nmaps = max_depth\nanimation = off\ncharts = off\nreport = off\ntitle = a\U0010fffd\n");
    const Outcome run = succeeded(frana({"run", "scene.ini", "--out", "result"}));
    EXPECT_NE(run.err.find("no installed font has the letters \U0010fffd"), std::string::npos) << run.err;
    EXPECT_NE(read_text(path("result/log.txt")).find("no installed font"), std::string::npos);
    const Outcome drawn = frana({"render", "result", "--map", "max_depth", "--title", "b"});
    EXPECT_EQ(drawn.err, "");
}

}  // namespace
}  // namespace frana::test
