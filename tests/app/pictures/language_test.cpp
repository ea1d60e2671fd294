// SPDX-License-Identifier: Apache-2.0
// The language of pictures, from the scene's key or the locale to the letters on the page.
#include <gtest/gtest.h>

#include <cstdlib>

#include "core/words/words.h"
#include "gis/raster/raster_out.h"
#include "support/program.h"
#include "support/tiny_scene.h"

namespace frana::test {
namespace {

/// A result drawn as SVG, whose texts are text.
class Languages : public TinyScene {
  protected:
    void run(const std::string& language) {
        write_scene(
            "[output]\nmaps = max_depth\nmap-formats = svg\nmap-size = 1000x750\nanimation = off\nframes = off\n" +
            language);
        const Outcome outcome = frana({"run", "scene.ini", "--out", "result", "--overwrite"});
        ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    }
    [[nodiscard]] bool has(const std::string& file, const std::string& text) const {
        return read_text(path(file)).find(text) != std::string::npos;
    }
};

TEST_F(Languages, AMapIsInTheLanguageOfTheKeyAndOfTheOption) {
    run("language = de\n");
    EXPECT_TRUE(has("result/scene.ini", "\nlanguage = de\n"));
    const std::string map = "result/maps/max_depth.svg";
    for (const char* text : {"Maximale Fließtiefe", "Anrissgebiet", "Volumen 4.000 m³", "(tiefer als 0,1 m)", "0 – 0,2",
                             "Äquidistanz der Höhenlinien", "max_depth.tif, Band 1"})
        EXPECT_TRUE(has(map, text)) << text << "\n" << read_text(path(map)).substr(0, 20000);
    EXPECT_FALSE(has(map, "Maximum depth"));
    const Outcome french = frana({"render", "result", "--map", "max_depth", "--language", "fr"});
    EXPECT_EQ(french.exit_code, 0) << french.err;
    for (const char* text :
         {"\u202F: Hauteur d’écoulement maximale", "Zone de départ", "4\u202F000 m³", "Surface couverte"})
        EXPECT_TRUE(has(map, text)) << text;
    const Outcome unknown = frana({"render", "result", "--language", "xx"});
    EXPECT_EQ(unknown.exit_code, 2);
    EXPECT_NE(unknown.err.find("--language"), std::string::npos) << unknown.err;
    EXPECT_NE(unknown.err.find(language_codes()), std::string::npos) << unknown.err;
}

TEST_F(Languages, ChartsAndStylesAreInTheLanguageAndDataStayEnglish) {
    run("language = es\n");
    for (const char* text : {"series temporales del flujo", "Velocidad máxima", "tiempo [s]", "velocidad [m/s]"})
        EXPECT_TRUE(has("result/charts/timeseries.svg", text)) << text;
    EXPECT_TRUE(has("result/charts/profile_flow_path.svg", "perfil a lo largo de la trayectoria del flujo"));
    EXPECT_TRUE(has("result/max_depth.sld", "Profundidad máxima"));
    for (const char* style : {"result/max_depth.sld", "result/max_depth.qml"})
        EXPECT_TRUE(has(style, "label=\"0,2 \u2013 0,5 m\"")) << style;
    EXPECT_TRUE(has("result/timeseries.csv", "max_speed_ms"));
    EXPECT_TRUE(has("result/log.txt", "volume"));
    const gis::RasterText band = gis::read_raster_text(path("result/max_depth.tif"));
    EXPECT_EQ(band.description.find("max_depth: Maximum flow depth"), 0U) << band.description;
}

TEST_F(Languages, TheLocaleOfTheRunIsKeptInTheResult) {
    ::setenv("LC_ALL", "it_IT.UTF-8", 1);
    run("");
    ::setenv("LC_ALL", "C.UTF-8", 1);
    EXPECT_TRUE(has("result/scene.ini", "\nlanguage = it\n"));
    EXPECT_TRUE(has("result/maps/max_depth.svg", "Profondità massima"));
    ASSERT_EQ(frana({"render", "result", "--map", "max_depth"}).exit_code, 0);
    EXPECT_TRUE(has("result/maps/max_depth.svg", "Profondità massima")) << "drawn again under another locale";
    run("");
    EXPECT_TRUE(has("result/scene.ini", "\nlanguage = en\n"));
    EXPECT_TRUE(has("result/maps/max_depth.svg", "Maximum depth"));
}

}  // namespace
}  // namespace frana::test
