// SPDX-License-Identifier: Apache-2.0
// Files of friction tables: that of share/friction, what is refused, and the keys that use them.
#include "params/scene/read_friction_table.h"

#include <gtest/gtest.h>

#include "params/scene/write_scene.h"
#include "physics/laws.h"
#include "scene_fixture.h"

namespace frana {
namespace {

FrictionTable ramms() {
    Problems problems;
    FrictionTable table =
        read_friction_table(FRANA_SOURCE_SHARE "/friction/ngi-avalanche.ini", "ngi-avalanche", problems);
    EXPECT_TRUE(problems.empty());
    return table;
}

// Values, k = 9.81 / xi and limits as in the file read (its head names it), in every corner of the table.
TEST(FrictionTables, NgiAvalancheIsAsInItsSource) {
    const FrictionTable table = ramms();
    EXPECT_EQ(table.periods, (std::vector<double>{10, 30, 100, 300}));
    EXPECT_EQ(table.volumes, (std::vector<double>{5000, 25000, 60000}));
    EXPECT_EQ(table.altitudes, (std::vector<double>{1000, 1500}));
    ASSERT_EQ(table.terrain.size(), 4U);
    ASSERT_EQ(table.values.size(), 4U * 4 * 4 * 3);
    const double curvatures[] = {0, 0.002, 0.01, 0.05};  // NOLINT(modernize-avoid-c-arrays)
    for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(table.terrain[i].curvature, curvatures[i]);
    struct Row {
        std::size_t period, volume, kind, band;
        double mu, k;
    };
    for (const Row& row :
         {Row{0, 0, 0, 0, 0.295, 0.00654}, Row{0, 0, 3, 2, 0.450, 0.00934}, Row{0, 2, 2, 1, 0.295, 0.00561},
          Row{0, 3, 0, 2, 0.160, 0.00245}, Row{1, 1, 1, 1, 0.265, 0.00561}, Row{1, 3, 0, 2, 0.155, 0.00245},
          Row{1, 2, 2, 1, 0.285, 0.00641}, Row{2, 0, 2, 2, 0.280, 0.00785}, Row{2, 2, 0, 1, 0.200, 0.00338},
          Row{2, 2, 1, 1, 0.220, 0.00467}, Row{3, 1, 3, 0, 0.400, 0.00981}, Row{3, 2, 0, 2, 0.170, 0.00302},
          Row{3, 3, 1, 2, 0.155, 0.00327}, Row{3, 3, 3, 2, 0.270, 0.00654}}) {
        const FrictionPair& pair = table.at(row.period, row.volume, row.kind, row.band);
        EXPECT_EQ(pair.coefficient, row.mu);
        EXPECT_NEAR(9.81 / pair.turbulence, row.k, 0.5e-5) << "the digits of the source";
    }
    for (const LanguageRow& language : languages().subspan(1))
        EXPECT_EQ(table.texts.at(language.code).size(), 5U) << language.code;
    EXPECT_FALSE(table.quote.empty());
}

// In the table friction falls with volume, altitude and return period and rises into channels, but for what its note
// says.
TEST(FrictionTables, NgiAvalancheIsMonotonic) {
    const FrictionTable table = ramms();
    for (std::size_t t = 0; t < 4; ++t)
        for (std::size_t v = 0; v < 4; ++v)
            for (std::size_t c = 0; c < 4; ++c)
                for (std::size_t b = 0; b < 3; ++b) {
                    const double mu = table.at(t, v, c, b).coefficient;
                    const auto place = [&] {
                        return "t " + std::to_string(t) + ", v " + std::to_string(v) + ", c " + std::to_string(c) +
                               ", b " + std::to_string(b);
                    };
                    if (b > 0) {
                        EXPECT_LT(mu, table.at(t, v, c, b - 1).coefficient) << place();
                        const bool exchanged = c == 2 && v == 2 && (t == 0 || t == 3) && b == 2;
                        EXPECT_EQ(table.at(t, v, c, b).turbulence > table.at(t, v, c, b - 1).turbulence, !exchanged)
                            << place();
                    }
                    if (c > 0) {
                        EXPECT_GT(mu, table.at(t, v, c - 1, b).coefficient) << place();
                    }
                    const bool doubtful = c == 2 && v <= 1 && t >= 2;
                    if (v > 0 && !doubtful) {
                        EXPECT_LT(mu, table.at(t, v - 1, c, b).coefficient) << place();
                    }
                    if (t > 0 && !doubtful) {
                        EXPECT_LE(mu, table.at(t - 1, v, c, b).coefficient) << place();
                    }
                }
}

class OwnFrictionTable : public SceneFixture {
  protected:
    [[nodiscard]] std::vector<Problem> problems_of(const std::string& text) const {
        Problems found;
        (void)read_friction_table(write(text, "own.ini"), "own.ini", found);
        return found.list();
    }
};

const std::string k_head = "[table]\ntitle = Own\nsource = None\nreturn-periods = 30\n";

TEST_F(OwnFrictionTable, MayHaveOneClassOfEverything) {
    Problems none;
    const FrictionTable table = read_friction_table(
        write(k_head + "[class-1]\nname = All\n30-years-from-0-m3 = 0.2 1000\n", "own.ini"), "own.ini", none);
    EXPECT_TRUE(none.empty());
    EXPECT_EQ(table.at(0, 0, 0, 0).turbulence, 1000);
    EXPECT_EQ(table.spacing, 10);
    EXPECT_FALSE(table.forest);
}

TEST_F(OwnFrictionTable, IsRefusedWhereItIsWrong) {
    const std::string row = "30-years-from-0-m3 = 0.2 1000\n", one = "[class-1]\nname = A\n" + row;
    EXPECT_TRUE(has_problem(problems_of(k_head), "own.ini: class-1"));
    EXPECT_TRUE(has_problem(problems_of(k_head + "[class-2]\nname = A\n" + row), "own.ini: class-1"));
    EXPECT_TRUE(has_problem(problems_of(k_head + "[class-1]\nname = A\n"), "own.ini: class-1.30-years-from-0-m3"));
    EXPECT_TRUE(has_problem(problems_of(k_head + "[class-1]\nname = A\n30-years-from-0-m3 = 0.2\n"),
                            "class-1.30-years-from-0-m3", "0.2", "1 pair, mu 0 to 2, xi 1 to 1e9 m/s2"));
    EXPECT_TRUE(has_problem(problems_of(k_head + "[class-1]\nname = A\n30-years-from-0-m3 = 2.5 1000\n"),
                            "class-1.30-years-from-0-m3", "2.5 1000", "1 pair, mu 0 to 2, xi 1 to 1e9 m/s2"));
    EXPECT_TRUE(has_problem(problems_of(k_head + "volume-limits = 100000\n" + one), "class-1.30-years-from-100000-m3"));
    EXPECT_TRUE(has_problem(problems_of(k_head + "altitude-limits = 1500, 1000\n" + one), "table.altitude-limits",
                            "1500, 1000", "rising numbers greater than 0"));
    EXPECT_TRUE(has_problem(problems_of(k_head + one + "[class-2]\nname = B\n" + row), "class-1.curvature"));
    EXPECT_TRUE(has_problem(problems_of(k_head + "[class-1]\nname = A\ncurvature = 0.1\n" + row +
                                        "[class-2]\nname = B\ncurvature = 0.1\n" + row),
                            "class-2.curvature", "0.1", "greater than 0.1"));
    const std::string gentle = k_head + "[class-1]\nname = A\nslope-below = ";
    EXPECT_TRUE(problems_of(gentle + "10\n" + row + "[class-2]\nname = B\ncurvature = -1\n" + row).empty());
    EXPECT_TRUE(has_problem(problems_of(gentle + "95\n" + row + "[class-2]\nname = B\ncurvature = 0\n" + row),
                            "class-1.slope-below", "95", "0.1 to 90"));
    EXPECT_TRUE(
        has_problem(problems_of(gentle + "10\ncurvature = 0\n" + row + "[class-2]\nname = B\ncurvature = 0\n" + row),
                    "class-1.curvature"));
    EXPECT_TRUE(has_problem(problems_of(k_head + one + "[forest]\nmore-friction = 0.02\n"), "forest.turbulence"));
    EXPECT_TRUE(has_problem(problems_of(k_head + "density = 2\n" + one), "table.density", "2", "10 to 10000"));
    EXPECT_TRUE(has_problem(problems_of(k_head + one + "colour = ffffff\n"), "class-1.colour"));
    EXPECT_TRUE(has_problem(problems_of(k_head + "quote = words\n" + one), "table.quote"));
}

const std::string k_scene = "[terrain]\ndtm = dtm.tif\n[release]\nperimeter = area.shp\nthickness = 2\n[material]\n",
                  k_table = k_scene + "friction-table = ngi-avalanche\n";

TEST_F(OwnFrictionTable, KeysThatUseIt) {
    EXPECT_TRUE(problems(k_table + "return-period = 30\n").empty());
    EXPECT_TRUE(has_problem(problems(k_table), "material.return-period", "", "10, 30, 100, 300 years"));
    EXPECT_TRUE(has_problem(problems(k_table + "return-period = 30\naltitude-limits = 1000\n"),
                            "material.altitude-limits", "1 limits", "2, between 3 bands"));
    EXPECT_TRUE(has_problem(problems(k_table + "return-period = 30\nforest = wood.shp\n"), "material.forest"));
    EXPECT_TRUE(has_problem(problems(k_table + "return-period = 30\nturbulence = 1000\n"), "material.turbulence"));
    EXPECT_TRUE(has_problem(problems(k_table + "return-period = 30\nbed-friction = coulomb\n"),
                            "material.friction-table", "ngi-avalanche"));
    EXPECT_TRUE(has_problem(problems(k_least + "table-volume = 1000\n"), "material.table-volume"));
    EXPECT_TRUE(has_problem(problems(k_least + "table-friction-factor = 2\n"), "material.table-friction-factor", "2"));
    EXPECT_TRUE(problems(k_least + "table-friction-factor = 1\n").empty()) << "as the echo of every scene has it";
    const SceneReading table = read(k_table + "return-period = 30\n");
    const std::string echo = scene_text(table.scene, {});
    EXPECT_TRUE(problems(echo).empty()) << "its echo";
    EXPECT_EQ(echo.find("\nturbulence ="), std::string::npos) << "which has no effect";
    EXPECT_NE(scene_text(read(k_least).scene, {}).find("\nturbulence = off"), std::string::npos);
    EXPECT_TRUE(
        has_problem(problems(k_table + "return-period = 30\nturbulence = off\n"), "material.turbulence", "off"));
    EXPECT_EQ(table.scene.material.density, 300);
    EXPECT_EQ(table.scene.origin_of("material.density"), Origin::friction_table);
    EXPECT_EQ(read(k_table + "return-period = 30\ndensity = 400\n").scene.material.density, 400);
    EXPECT_TRUE(problems(k_table + "return-period = 30\n[hazard]\nscheme = swiss-avalanche\n").empty());
    // It replaces what a preset, or an earlier source, gives.
    const SceneReading preset = read(k_table + "preset = snow-avalanche\nreturn-period = 30\n");
    EXPECT_TRUE(preset.problems.empty());
    EXPECT_FALSE(preset.scene.material.of<TurbulentFriction>().turbulence ||
                 preset.scene.material.of<CoulombFriction>().friction_coefficient ||
                 preset.scene.material.of<CoulombFriction>().friction_angle);
    EXPECT_TRUE(problems(k_least, {"material.friction-table=ngi-avalanche", "material.return-period=30"}).empty());
}

// The greatest mu of 30 years is 0.46, from 60 000 m3 on 0.33; the least and greatest xi are 900 and 4000.
TEST_F(OwnFrictionTable, FactorsKeepItsValuesWithinTheLimitsOfTheKeys) {
    const std::string years = k_table + "return-period = 30\n", factor = years + "table-friction-factor = ";
    EXPECT_TRUE(problems(factor + "4.34\n").empty());
    EXPECT_TRUE(has_problem(problems(factor + "5\n"), "material.friction-table", "0.775 to 2.3", "0 to 2"));
    EXPECT_TRUE(problems(factor + "6\ntable-volume = 60000\n").empty());
    EXPECT_TRUE(has_problem(problems(factor + "6.1\ntable-volume = 60000\n"), "material.friction-table"));
    EXPECT_TRUE(problems(years + "table-turbulence-factor = 10\n").empty());
    const std::string own = write(k_head +
                                      "[forest]\nmore-friction = 1.9\nturbulence = 1\n[class-1]\nname = All\n"
                                      "30-years-from-0-m3 = 0.2 5e8\n",
                                  "own.ini");
    const std::string of_own = k_scene + "friction-table = own.ini\nreturn-period = 30\n";
    EXPECT_TRUE(problems(of_own).empty());
    EXPECT_TRUE(
        has_problem(problems(of_own + "forest = wood.shp\n"), "material.friction-table", "0.2 to 2.1", "0 to 2"));
    EXPECT_TRUE(has_problem(problems(of_own + "table-turbulence-factor = 3\n"), "material.friction-table",
                            "1.5e+09 to 1.5e+09"));
}

}  // namespace
}  // namespace frana
