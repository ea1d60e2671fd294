// SPDX-License-Identifier: Apache-2.0
// The language of pictures, from the scene's key or the locale to the letters on the page.
#include <cpl_vsi.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <regex>

#include "core/words/words.h"
#include "gis/raster/raster_out.h"
#include "support/program.h"
#include "support/tiny_scene.h"

namespace frana::test {
namespace {

/// A result drawn as SVG, whose texts are text.
class Languages : public TinyScene {
  protected:
    void run(const std::string& language, const std::vector<std::string>& sets = {}) {
        write_scene(
            "[output]\nmaps = max_depth\nmap-formats = svg\nmap-size = 1000x750\nanimation = off\nreport = off\nframes "
            "= off\n" +
            language);
        succeeded(frana(with_sets({"run", "scene.ini", "--out", "result", "--overwrite"}, sets)));
    }
    [[nodiscard]] bool has(const std::string& file, const std::string& text) const {
        return read_text(path(file)).find(text) != std::string::npos ||
               (file.ends_with(".svg") && unwrapped(file).find(text) != std::string::npos);
    }
    /// The texts of a drawing in one line, whatever its page wraps.
    [[nodiscard]] std::string unwrapped(const std::string& file) const {
        const std::string texts = std::regex_replace(read_text(path(file)), std::regex("<[^>]*>"), " ");
        return std::regex_replace(texts, std::regex("\\s+"), " ");
    }
};

TEST_F(Languages, AMapIsInTheLanguageOfTheKeyAndOfTheOption) {
    run("language = de\n");
    EXPECT_TRUE(has("result/scene.ini", "\nlanguage = de\n"));
    const std::string map = "result/maps/max_depth.svg";
    for (const char* text : {"Maximale Fließtiefe", "Anrissgebiet", "Volumen: 4.000 m³", "(&gt; 0,1 m)", "0 – 0,2",
                             "Äquidistanz der Höhenlinien", "max_depth.tif"})
        EXPECT_TRUE(has(map, text)) << text << "\n" << read_text(path(map)).substr(0, 20000);
    EXPECT_FALSE(has(map, "Maximum depth"));
    succeeded(frana({"render", "result", "--map", "max_depth", "--language", "fr"}));
    for (const char* text :
         {"\u202F: Hauteur d’écoulement maximale", "Zone de départ", "4\u202F000 m³", "Surface couverte"})
        EXPECT_TRUE(has(map, text)) << text;
    refusal_of(frana({"render", "result", "--language", "xx"}), {"--language", language_codes()});
}

TEST_F(Languages, ChartsAndStylesAreInTheLanguageAndDataStayEnglish) {
    run("language = es\n");
    for (const char* text : {"Curso del flujo", "Velocidad máxima", "Tiempo [s]", "Velocidad del flujo [m/s]"})
        EXPECT_TRUE(has("result/charts/timeseries.svg", text)) << text;
    EXPECT_TRUE(has("result/charts/profile_flow_path.svg", "Perfiles: Trayectoria"));
    EXPECT_TRUE(has("result/max_depth.sld", "Profundidad máxima"));
    for (const char* style : {"result/max_depth.sld", "result/max_depth.qml"})
        EXPECT_TRUE(has(style, "label=\"0,2 \u2013 0,5 m\"")) << style;
    EXPECT_TRUE(has("result/timeseries.csv", "max_speed_ms"));
    EXPECT_TRUE(has("result/log.txt", "computed"));
    const gis::RasterText band = gis::read_raster_text(path("result/max_depth.tif"));
    EXPECT_EQ(band.description.find("max_depth: Maximum flow depth"), 0U) << band.description;
}

// What gave the friction stands on its maps and in the report, as does whether its source was read.
TEST_F(Languages, AMapOfFrictionNamesItsTableAndItsSource) {
    const std::vector<std::string> table{"material.friction-table=ngi-avalanche", "material.return-period=300",
                                         "output.maps=mu,xi", "output.report=on", "material.altitude-limits=270, 1500"};
    run("language = de\n", table);
    for (const char* map : {"result/maps/mu.svg", "result/maps/xi.svg", "result/report.html"})
        for (const char* text : {"NGI, Voellmy", "RAMMS::AVALANCHE"})
            EXPECT_TRUE(has(map, text)) << map << ": " << text;
    for (const char* text : {"Reibungskoeffizient an der Sohle", "Reibungstabelle: NGI", "Quelle: NGI"})
        EXPECT_TRUE(has("result/maps/mu.svg", text)) << text;
    for (const char* text : {"(Klasse &lt; 5.000 m³)", "Gleichmäßiger oder konvexer Hang", "gelesen unter github.com",
                             "NGI, Voellmy-Reibung von Lawinen", "μ und ξ springen bei Höhen von 270 m"})
        EXPECT_TRUE(has("result/report.html", text)) << text;
    write("own.ini", own_friction_table(0.2));
    run("", {"material.friction-table=own.ini", "material.return-period=30", "output.maps=mu"});
    for (const char* text : {"Friction table: Own", "Source: None (not read)"})
        EXPECT_TRUE(has("result/maps/mu.svg", text)) << text;
}

TEST_F(Languages, ChartsOfAStudyNameKeysAndUnitsAsPrintDoes) {
    write_scene(
        "[output]\nmap-formats = svg\nmap-size = 1000x750\nanimation = off\nreport = off\nframes = off\nlanguage = "
        "de\n");
    write("study.ini",
          "[study]\nscene = scene.ini\nsamples = 8\n[vary]\nmaterial.friction-angle = uniform(10, 26)\n"
          "material.turbulence = log-uniform(200, 2000)\n");
    succeeded(frana({"ensemble", "study.ini", "--out", "result"}));
    for (const auto& [chart, text] :
         {std::pair{"exceedance", "Bedeckte Fläche [m²]"}, std::pair{"sensitivity", "Reibungswinkel"}}) {
        const std::string file = std::string("result/charts/") + chart + ".svg";
        EXPECT_TRUE(has(file, text)) << chart << ": " << text;
        EXPECT_FALSE(has(file, "material.friction-angle")) << chart;
    }
}

// Maps are passed on without the log: what the run warned of stands on each, in its language, and on QGIS's sheets.
TEST_F(Languages, AWarningOfARunStandsOnItsMapsAndSheets) {
    const auto on_map = [&] { return unwrapped("result/maps/max_depth.svg"); };
    const auto has_all = [](const std::string& text, const std::vector<std::string>& parts) {
        for (const std::string& part : parts) EXPECT_NE(text.find(part), std::string::npos) << part << " in " << text;
    };
    run("language = it\n", {"time.end=3", "time.stop-when-still=off"});
    const std::string told = "il flusso si muove ancora quando time.end termina il calcolo (";
    has_all(on_map(), {"Avviso: " + told});
    std::string project(1 << 20, '\0');
    VSILFILE* const file = VSIFOpenL(("/vsizip/{" + path("result/result.qgz") + "}/result.qgs").c_str(), "rb");
    ASSERT_NE(file, nullptr);
    project.resize(VSIFReadL(project.data(), 1, project.size(), file));
    VSIFCloseL(file);
    const std::size_t sheet = project.find("<Layout name=");
    ASSERT_NE(sheet, std::string::npos);
    EXPECT_NE(project.find("Avviso: " + told, sheet), std::string::npos) << project.substr(sheet, 4000);
    // Drawn again, from summary.json, in another language.
    succeeded(frana({"render", "result", "--map", "max_depth", "--language", "de"}));
    has_all(on_map(), {"Warnung: der Strom bewegt sich noch, wenn time.end den Lauf beendet ("});
    run("language = en\n", {"time.end=3", "time.stop-when-still=off", "numerics.particles-per-cell=1"});
    has_all(on_map(), {"Warning: the flow still moves when time.end ends the run ("});
    run("language = en\n", {"time.end=300", "material.friction-angle=22"});
    expect_no_words(on_map(), {"Warning:", "warnings, the first"});
}

TEST_F(Languages, TheLocaleOfTheRunIsKeptInTheResult) {
    ::setenv("LC_ALL", "it_IT.UTF-8", 1);
    run("");
    ::setenv("LC_ALL", "C.UTF-8", 1);
    EXPECT_TRUE(has("result/scene.ini", "\nlanguage = it\n"));
    EXPECT_TRUE(has("result/maps/max_depth.svg", "Profondità massima"));
    succeeded(frana({"render", "result", "--map", "max_depth"}));
    EXPECT_TRUE(has("result/maps/max_depth.svg", "Profondità massima")) << "drawn again under another locale";
    run("");
    EXPECT_TRUE(has("result/scene.ini", "\nlanguage = en\n"));
    EXPECT_TRUE(has("result/maps/max_depth.svg", "Maximum depth"));
}

}  // namespace
}  // namespace frana::test
