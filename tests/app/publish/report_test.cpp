// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "app/pictures/map_source.h"
#include "app/pictures/result_reader.h"
#include "app/publish/html_page.h"
#include "app/store/manifest.h"
#include "params/keys/scene_parameters.h"
#include "render/map/legend.h"
#include "support/html_check.h"
#include "support/tiny_scene.h"

namespace frana::test {
namespace {

namespace fs = std::filesystem;

class Report : public TinyScene {
  protected:
    [[nodiscard]] std::string page_of(const std::string& result = "result") const {
        return read_text(path(result + "/report.html"));
    }
    void expect_well_formed(const std::string& page) const {
        for (const std::string& problem : html_problems(page)) ADD_FAILURE() << problem;
    }
    void write_scar() const { write_polygon("scar", {{15, 50}, {180, 50}, {180, 100}, {15, 100}}); }
};

TEST_F(Report, ContainsEverythingInOneFile) {
    write_scar();
    write_scene(
        "frame-interval = 1\n[output]\nanimation = off\nmap-size = 640x480\nmaps = max_depth, max_velocity\n"
        "title = Slope <5> & \"more\"\n[hazard]\nscheme = swiss-flood\n[scar]\nperimeter = scar.geojson\n");
    ran("result", {"numerics.cfl=0.4"});
    const std::string page = page_of();
    expect_well_formed(page);
    EXPECT_NE(page.find("<h1>Slope &lt;5&gt; &amp; &quot;more&quot;</h1>"), std::string::npos);
    EXPECT_EQ(count_of(page, "src=\"data:image/"), 4U) << "intensity, two maps and the comparison";
    EXPECT_EQ(count_of(page, "src="), 4U);
    EXPECT_EQ(count_of(page, "url("), 0U);
    EXPECT_NE(page.find("@media print"), std::string::npos);
    expect_words(page, {"EPSG:32632", "dtm.asc", "perimeter.geojson", "scar.geojson", "Mass budget", "still moves",
                        "Jaccard index", "High intensity", "Numerical errors"});
    EXPECT_NE(page.find("alt=\"Maximum depth: maximum "), std::string::npos);
}

// The answer comes first, then maps, then inputs, then the keys that were used; all keys are folded.
TEST_F(Report, HasTheAnswerFirstAndOnlyTheKeysUsed) {
    write_scene("[output]\nanimation = off\ncharts = off\nmap-size = 640x480\nmaps = max_depth, max_velocity\n");
    ran("result", {"numerics.cfl=0.4"});
    const std::string page = page_of();
    std::size_t before = 0;
    for (const std::string id : {"answer", "maps", "series", "values", "inputs", "parameters"}) {
        const std::size_t at = page.find("<h2 id=\"" + id + "\"");
        ASSERT_NE(at, std::string::npos) << id;
        EXPECT_GT(at, before) << id;
        before = at;
    }
    EXPECT_LT(page.find("<img "), page.find("<h2 id=\"maps\"")) << "the main map is on the first page";
    const std::size_t folded = page.find("<details>");
    const std::string used = page.substr(before, folded - before), all = page.substr(folded);
    for (const Parameter& parameter : scene_parameters())
        EXPECT_NE(all.find("<td>" + parameter.name() + "</td>"), std::string::npos) << parameter.name();
    expect_words(used, {"<tr class=\"given\"><td>numerics.cfl</td><td>0.4</td><td>command line</td>",
                        "<tr class=\"given\"><td>material.friction-angle</td><td>15 [°]</td><td>scene "
                        "file</td>",
                        "<tr><td>material.density</td><td>2000 [kg/m³]</td><td>default</td>",
                        "<td>numerics.minimum-depth</td>"});
    for (const std::string key :
         {"structured.young-modulus", "material.chezy", "entrainment.growth-rate", "output.depth-thresholds"})
        EXPECT_EQ(used.find("<td>" + key + "</td>"), std::string::npos) << key;
    // Sentences, with the origin of the friction.
    expect_words(page, {"<td>friction angle</td><td>15° (μ = 0.268)</td><td>scene file</td>",
                        "<td>density</td><td>2000 kg/m³</td><td>default</td>"});
    // The four answers come first, each with its unit and where it is.
    std::size_t answer = page.find("<h2 id=\"answer\"");
    for (const std::string question : {"How far", "How deep", "How fast", "How sure"}) {
        const std::size_t row = page.find("<td>" + question + "</td>", answer);
        ASSERT_NE(row, std::string::npos) << question;
        const std::string cells = page.substr(row, page.find("</tr>", row) - row);
        expect_words(cells, {question == "How sure" ? "cells of 5 m" : "E ", "no estimate"});
        answer = row;
    }
    EXPECT_LT(answer, page.find("<img "));
}

// A value has the estimate that there is, and says so where there is none.
TEST_F(Report, HasTheEstimateOfTheError) {
    write_scene(k_pages_only);
    ran("plain");
    EXPECT_NE(page_of("plain").find("<td class=\"soft\">no estimate</td>"), std::string::npos);
    EXPECT_EQ(page_of("plain").find("<td class=\"soft\">± "), std::string::npos);
    succeeded(frana({"converge", "scene.ini", "--out", "result-convergence", "--quiet"}));
    const Outcome outcome = succeeded(frana({"run", "scene.ini", "--out", "result"}));
    const std::string page = page_of(), study = read_text(path("result-convergence/convergence.json"));
    const double error = json_number(study, "runout_m.estimated_error");
    // The terminal ends with the same four, and with what the map is.
    std::size_t line = outcome.err.find("frana: How far: Run-out ");
    for (const std::string told : {" m; ± ", "\n  How deep: ", "\n  How fast: ", "\n  How sure: ", "cells of 5 m",
                                   "One run with one set of values, the scene's own.", "frana: result in "}) {
        ASSERT_NE(line, std::string::npos) << outcome.err;
        line = outcome.err.find(told, line);
    }
    EXPECT_NE(line, std::string::npos) << outcome.err;
    EXPECT_NE(page.find("One run with one set of values, the scene"), std::string::npos);
    char text[40];
    std::snprintf(text, sizeof text, "<td class=\"soft\">± %.2g", error);
    const std::size_t row = page.find("<td>Run-out</td>");
    ASSERT_NE(row, std::string::npos);
    const std::size_t cell = page.find(text, row);
    ASSERT_NE(cell, std::string::npos) << text;
    EXPECT_LT(cell, page.find("</tr>", row));
    EXPECT_NE(page.find(">±<"), std::string::npos);
}

// Warnings are put together in English, and shown in the language of the report.
TEST_F(Report, HasItsWarningsInItsLanguage) {
    write("dtm.asc", [&] {
        std::string text = read_text(path("dtm.asc"));
        const std::size_t at = text.rfind(' ', text.size() / 2);
        return text.replace(at, text.find_first_of(" \n", at + 1) - at, " 9500");
    }());
    write_scene("[output]\nlanguage = it\nmaps = off\nanimation = off\ncharts = off\n");
    ran();
    const std::string page = page_of();
    const Json summary = parse_json(read_text(path("result/summary.json")));
    ASSERT_GE(summary.at("warnings").size(), 3U) << "the lists below are of several";
    const std::size_t begin = page.find("<h2 id=\"warnings\">");
    ASSERT_NE(begin, std::string::npos);
    const std::string list = page.substr(begin, page.find("<h2", begin + 1) - begin);
    EXPECT_EQ(count_of(list, "<p class=\"warning\">"), summary.at("warnings").size());
    expect_no_words(list, {" the ", " is ", " of ", " its ", " and ", " than "});
    EXPECT_NE(list.find("il flusso si muove ancora quando time.end termina il calcolo"), std::string::npos) << list;
}

// Gauges side by side are told apart without colours: no two curves of a chart have the same stroke and marker.
TEST_F(Report, DrawsCurvesThatDifferWithoutColour) {
    std::vector<TestFeature> gauges;
    for (int i = 0; i < 10; ++i) gauges.push_back({"Point", {{60 + 8 * i, 75}}, named("g" + std::to_string(i))});
    write_features("gauges", gauges);
    write_scene("[output]\nanimation = off\ncharts = off\nmaps = off\nframes = off\ngauges = gauges.geojson\n");
    ran();
    const std::string page = page_of();
    expect_well_formed(page);
    const std::size_t at = page.find("aria-label=\"Gauges; ");
    ASSERT_NE(at, std::string::npos);
    const std::string chart = page.substr(at, page.find("</svg>", at) - at);
    std::set<std::string> dashes;
    for (std::size_t dash = chart.find("stroke-dasharray:"); dash != std::string::npos;
         dash = chart.find("stroke-dasharray:", dash + 1))
        dashes.insert(chart.substr(dash, chart.find(';', dash) - dash));
    EXPECT_EQ(dashes.size(), 3U) << "four kinds, and again with markers";
    EXPECT_GE(count_of(chart, ";fill:rgb(35.29%,27.45%,19.60%)"), 4U);
    expect_words(page, {"Arrival time [s]", "<td>g9</td>"});
}

// A browser displays PNG: pictures in other formats are also drawn for the page.
TEST_F(Report, ShowsPicturesRequestedInOtherFormats) {
    write_scar();
    write_scene(
        "[output]\nanimation = off\ncharts = off\nmap-size = 640x480\nmaps = max_depth, "
        "max_depth_3d\nmap-formats = pdf\n"
        "[scar]\nperimeter = scar.geojson\n");
    ran();
    EXPECT_EQ(count_of(page_of(), "src=\"data:image/"), 3U);
    for (const std::string& name : files()) {
        EXPECT_FALSE(name.ends_with(".png")) << name;
        EXPECT_EQ(name.find("report_pictures"), std::string::npos) << name;
    }
}

TEST_F(Report, IsWrittenOnlyOnRequest) {
    write_scene(k_numbers_only);
    ran();
    EXPECT_FALSE(fs::exists(path("result/report.html")));
    write_scene(k_pages_only);
    ran("other");
    EXPECT_EQ(page_of("other").find("<h2 id=\"maps\""), std::string::npos) << "the scene asks for none";
}

// Large maps are as good as paper needs.
TEST_F(Report, StaysSmallWithLargeMaps) {
    write_scene(
        "[output]\nanimation = off\ncharts = off\nframes = off\nmap-size = 3600x2700\n"
        "maps = max_depth, max_depth_3d\n");
    ran();
    EXPECT_LT(fs::file_size(path("result/report.html")), 2'600'000U);  // 4 MB with three maps
    EXPECT_EQ(count_of(page_of(), "src=\"data:image/"), 2U);
}

// Pictures are drawn for the width that they have on paper: 1 : n is true there, and everything can be read.
TEST_F(Report, PicturesHaveTheirScaleAndLegibleLettersOnPaper) {
    constexpr double k_point = 25.4 / 72, k_least_points = 6;  // mm
    write_scene("[output]\nanimation = off\ncharts = off\nmap-size = 640x480\nmaps = max_depth, max_depth_3d\n");
    ran();
    const std::string page = page_of();
    std::smatch found;
    ASSERT_TRUE(std::regex_search(page, found, std::regex("img\\.page \\{[^}]*[ ;]width: ([0-9.]+)mm;")));
    const double width_mm = std::stod(found[1]);
    const std::regex picture("<img class=\"page\"[^>]*? width=\"([0-9]+)\" height=\"([0-9]+)\"");
    const app::ResultReader result(path("result"));
    const app::MapSource source = result.map_source();
    const app::MapLayer layer = result.map_layer("max_depth");
    const render::MapSpec spec = app::page_map_spec(source, layer, app::k_page_picture_heights_mm[0]);
    std::size_t pictures = 0;
    for (std::sregex_iterator one(page.begin(), page.end(), picture), end; one != end; ++one, ++pictures) {
        EXPECT_EQ(std::stoi((*one)[1]), spec.width);
        EXPECT_EQ(std::stoi((*one)[2]), spec.height);
    }
    EXPECT_EQ(pictures, 2U);
    EXPECT_EQ(count_of(page, "src=\"data:image/"), 2U) << "all are drawn for the page";
    const double mm_per_pixel = width_mm / spec.width;
    render::MapLayout map;
    render::map_page(spec, &map);
    const double bar_on_paper = map.scale_bar.width() * mm_per_pixel / 1000;
    EXPECT_NEAR(map.scale_bar_metres / bar_on_paper / map.scale, 1, 0.02);
    EXPECT_TRUE(std::any_of(map.texts.begin(), map.texts.end(),
                            [&](const render::TextBox& text) { return text.text == render::scale_words(map.scale); }));
    for (const render::TextBox& text : map.texts)
        EXPECT_GE(text.size_px * mm_per_pixel / k_point, k_least_points) << text.text;
    // Charts are as wide as the text.
    const std::regex svg("<svg [^>]*viewBox=\"0 0 ([0-9]+) ([0-9]+)\""), letters("font-size=\"([0-9.]+)");
    ASSERT_TRUE(std::regex_search(page, found, svg));
    const double mm_per_unit = width_mm / std::stod(found[1]);
    std::size_t texts = 0;
    for (std::sregex_iterator one(page.begin(), page.end(), letters), end; one != end; ++one, ++texts)
        EXPECT_GE(std::stod((*one)[1]) * mm_per_unit / k_point, k_least_points);
    EXPECT_GT(texts, 20U);
}

TEST_F(Report, SpeaksTheLanguageOfTheScene) {
    write_scar();
    for (const auto& [language, words] : std::vector<std::pair<std::string, std::vector<std::string>>>{
             {"it", {"Risposta", "<td>angolo di attrito</td><td>15°", "Confronto con il rilievo"}},
             {"de", {"Antwort", "<td>Reibungswinkel</td><td>15°", "Vergleich mit der Kartierung"}},
             {"fr", {"Réponse", "<td>angle de frottement</td><td>15°", "Comparaison avec le levé"}},
             {"es", {"Respuesta", "<td>ángulo de fricción</td><td>15°", "Comparación con el levantamiento"}}}) {
        write_scene(k_pages_only + "language = " + language + "\n[observed]\nperimeter = scar.geojson\n");
        ran(language);
        const std::string page = page_of(language);
        expect_well_formed(page);
        EXPECT_NE(page.find("<html lang=\"" + language + "\">"), std::string::npos);
        for (const std::string& word : words) EXPECT_NE(page.find(word), std::string::npos) << word;
        expect_no_words(page, {"How far", "Keys used"});
        // Meanings and effects of keys, units, terms of the run, input files.
        expect_no_words(page, {"Used by", "required", "Cell size of", ">degrees<", "hydrostatic pressure",
                               "polygons:", "Release perimeter", "Operation to"});
        // Numbers on the axis of the scores.
        for (const std::string value : {"01", "1", "2"}) {
            EXPECT_NE(page.find(">0," + value + "</text>"), std::string::npos) << language << " 0," << value;
            EXPECT_EQ(page.find(">0." + value + "</text>"), std::string::npos) << language << " 0." << value;
        }
        EXPECT_EQ(page.find("Jaccard index<"), std::string::npos);
    }
}

}  // namespace
}  // namespace frana::test
