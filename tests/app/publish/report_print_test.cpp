// SPDX-License-Identifier: Apache-2.0
// The report as a browser prints it on A4. Debian: chromium, poppler-utils; skipped where they are absent.
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "app/pictures/map_source.h"
#include "support/html_check.h"
#include "support/tiny_scene.h"

namespace frana::test {
namespace {

namespace fs = std::filesystem;

bool has_tool(const std::string& name) {
    return std::system(("command -v " + name + " >/dev/null 2>&1").c_str()) == 0;
}

std::string output_of(const std::string& command) {
    std::string output;
    FILE* const pipe = ::popen((command + " 2>/dev/null").c_str(), "r");
    if (pipe == nullptr) return output;
    std::array<char, 4096> part{};
    for (std::size_t n = 0; (n = std::fread(part.data(), 1, part.size(), pipe)) > 0;) output.append(part.data(), n);
    ::pclose(pipe);
    return output;
}

/// A printed page in grey: fraction of its height above which all its ink is, without the foot.
double filled(const std::string& pgm) {
    int width = 0, height = 0;
    if (std::sscanf(pgm.c_str(), "P5 %d %d 255", &width, &height) != 2) return 0;
    const auto columns = static_cast<std::size_t>(width), rows = static_cast<std::size_t>(height);
    const std::string pixels = pgm.substr(pgm.size() - columns * rows);
    for (std::size_t row = rows * (297 - 16) / 297; row-- > 0;)
        for (std::size_t column = 0; column < columns; ++column)
            if (static_cast<unsigned char>(pixels[row * columns + column]) < 200)
                return static_cast<double>(row) / static_cast<double>(rows);
    return 0;
}

class PrintedReport : public TinyScene {
  protected:
    void SetUp() override {
        if (!has_tool("chromium") || !has_tool("pdftotext"))
            GTEST_SKIP() << "chromium or pdftotext (Debian: chromium, poppler-utils) is not installed";
    }

    /// Prints a page; returns the letters of each printed page, without white space, in the order of its content.
    std::vector<std::string> printed(const std::string& page) {
        const std::string pdf = path("printed.pdf");
        const std::string command =
            "timeout 120 chromium --headless --no-sandbox --disable-gpu --no-first-run "
            "--disable-background-networking --disable-component-update --disable-sync --user-data-dir='" +
            path("browser") + "' --no-pdf-header-footer --print-to-pdf='" + pdf + "' 'file://" + path(page) +
            "' >/dev/null 2>&1";
        EXPECT_EQ(std::system(command.c_str()), 0);
        EXPECT_NE(output_of("pdfinfo '" + pdf + "'").find("(A4)"), std::string::npos);
        std::vector<std::string> pages;
        const std::string text = output_of("pdftotext -raw '" + pdf + "' -");
        for (std::size_t at = 0, end = 0; (end = text.find('\f', at)) != std::string::npos; at = end + 1)
            pages.push_back(without_space(text.substr(at, end - at)));
        return pages;
    }
    void expect_good_pages(const std::string& page, std::size_t most) {
        const std::string html = read_text(path(page));
        const std::vector<std::string> pages = printed(page);
        ASSERT_GT(pages.size(), 1U);
        EXPECT_LT(pages.size(), most);
        for (std::size_t i = 0; i + 1 < pages.size(); ++i) {
            const std::string number = std::to_string(i + 1);
            const std::string picture =
                output_of("pdftoppm -gray -r 40 -f " + number + " -l " + number + " '" + path("printed.pdf") + "'");
            EXPECT_GE(filled(picture), 0.5) << "page " << number;
        }
        // Pictures have the width for which they were drawn, so that their scale is true.
        std::istringstream images(output_of("pdfimages -list '" + path("printed.pdf") + "'"));
        std::size_t maps = 0;
        for (std::string line; std::getline(images, line);) {
            std::istringstream words(line);
            std::string kind, of_colour;
            double page_number = 0, number_on_page = 0, columns = 0, rows = 0, other = 0, dots_per_inch = 0;
            std::string text;
            if (!(words >> page_number >> number_on_page >> kind >> columns >> rows) || kind != "image") continue;
            words >> of_colour >> other >> other >> text >> text >> other >> other >> dots_per_inch;
            EXPECT_NEAR(columns / dots_per_inch * 25.4, app::k_page_picture_width_mm, 2) << line;
            ++maps;
        }
        EXPECT_EQ(maps, count_of(html, "src=\"data:image/"));
        // Each row of each table is whole on a page.
        const std::vector<std::vector<std::string>> rows = printed_rows(html);
        EXPECT_GT(rows.size(), 40U);
        for (const std::vector<std::string>& row : rows) {
            std::string cells;
            for (const std::string& cell : row) cells += cell;
            const bool is_whole = std::any_of(pages.begin(), pages.end(), [&](const std::string& text) {
                return text.find(cells) != std::string::npos;
            });
            EXPECT_TRUE(is_whole) << cells;
        }
        pages_ = pages;
    }

    std::vector<std::string> pages_;
};

TEST_F(PrintedReport, OfTheSampleFillsItsFewPages) {
    succeeded(frana({"run", FRANA_SOURCE_DIR "/sample_data/bindo/scene.ini", "--out", "result", "--quiet", "--set",
                     "output.animation=off", "--set", "terrain.cell-size=20", "--set", "output.charts=off"}));
    expect_good_pages("result/report.html", 10);
    EXPECT_LT(fs::file_size(path("result/report.html")), 4'000'000U);
    // Scenario, answer and the values are on the first page, searchable.
    const std::string& first = pages_.front();
    for (const std::string words :
         {"Bindo (synthetic terrain)", "failing mass", "friction angle", "preset bindo", "Fois", "How sure",
          "no estimate", "Jaccard index", "uncalibrated", "Maximum depth", "Run-out"})
        EXPECT_NE(first.find(without_space(words)), std::string::npos) << words;
    // The head of the keys is on each page that has keys; what is folded is on none.
    const std::string head = "KeyValueOriginMeaning";
    for (const std::string key : {"terrain.dtm", "time.stop-change"})
        EXPECT_TRUE(std::any_of(pages_.begin(), pages_.end(), [&](const std::string& text) {
            return text.find(key) != std::string::npos && text.find(head) != std::string::npos;
        })) << key;
    for (const std::string& text : pages_) EXPECT_EQ(text.find("structured.young-modulus"), std::string::npos);
}

// Long names, many gauges and warnings: the first page may not overflow the second.
TEST_F(PrintedReport, OfALongAnswerStaysReadable) {
    write_polygon("scar", {{15, 50}, {180, 50}, {180, 100}, {15, 100}});
    write_scene("[output]\nanimation = off\nmaps = max_depth\ncharts = off\ntitle = " + std::string(150, 'W') +
                "\n[scar]\nperimeter = scar.geojson\n");
    ran();
    expect_good_pages("result/report.html", 8);
}

}  // namespace
}  // namespace frana::test
