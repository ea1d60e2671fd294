// SPDX-License-Identifier: Apache-2.0
// How often, as a user sees it: rates, what is exceeded once in some years, hazard curves.
#include <gdal_priv.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <nlohmann/json.hpp>

#include "core/json.h"
#include "study/tiny_study.h"

namespace frana::test {
namespace {

namespace fs = std::filesystem;

constexpr double k_release_area = 50.0 * 40;  // [m2]

class Frequency : public Ensemble {
  protected:
    Frequency() { write_frequency_scene(); }

    /// Finite volumes, with gauges on the axis of the flow so far east of the DTM's western edge [m].
    void write_frequency_scene(const std::vector<double>& gauges = {45, 122.5, 162.5, 192.5}) const {
        std::vector<TestFeature> points;
        for (const double x : gauges)
            points.push_back({"Point", {{x, 72.5}}, named("g" + std::to_string(points.size()))});
        write_features("gauges", points);
        write_scene("stop-when-still = off\n[numerics]\nscheme = finite-volume\n" + k_numbers_only +
                    "charts = off\ngauges = gauges.geojson\n");
    }
    [[nodiscard]] std::vector<double> band(const std::string& name, int number) const {
        GDALAllRegister();
        const GDALDatasetUniquePtr file(GDALDataset::Open(path(name + ".tif").c_str()));
        std::vector<double> values(static_cast<std::size_t>(k_columns * k_rows));
        EXPECT_NE(file, nullptr) << name;
        EXPECT_EQ(file->GetRasterBand(number)->RasterIO(GF_Read, 0, 0, k_columns, k_rows, values.data(), k_columns,
                                                        k_rows, GDT_Float64, 0, 0),
                  CE_None);
        return values;
    }
    /// Rows of hazard_curves.csv of the depth at a gauge.
    [[nodiscard]] Rows curve(const std::string& gauge) const {
        const gis::Table table = gis::read_table(path("out/hazard_curves.csv"), "curves");
        EXPECT_EQ(table.columns, (std::vector<std::string>{"kind", "place", "quantity", "value", "annual_rate", "low",
                                                           "high", "median"}));
        Rows rows;
        for (const auto& cells : table.rows)
            if (cells[1] == gauge && cells[2] == "max_depth_m")
                rows.push_back({{"value", cells[3]},
                                {"rate", cells[4]},
                                {"low", cells[5]},
                                {"high", cells[6]},
                                {"median", cells[7]}});
        return rows;
    }
};

/// Rate of events above a volume, for 2000: 20, 4000: 100, 8000: 400.
double rate_above(double volume) {
    if (volume <= 2000) return 1.0 / 20;
    if (volume > 8000) return 0;
    const double v0 = volume <= 4000 ? 2000 : 4000, t0 = volume <= 4000 ? 20 : 100, t1 = volume <= 4000 ? 100 : 400;
    return 1 / (t0 * std::pow(t1 / t0, std::log(volume / v0) / std::log(2.0)));
}
const std::string k_volumes = "[frequency]\nvolumes = 2000: 20, 4000: 100, 8000: 400\n";

// What does not move is as deep as its volume over its outline: the rate of each depth is known in closed form.
TEST_F(Frequency, RatesOfAPileAtRestAreThoseOfItsVolumes) {
    write_dtm([](int, int column) { return 300 - 0.05 * column * k_cell; });
    write_study("samples = 64\n", "[set]\nmaterial.friction-angle = 45\ntime.end = 1\n" + k_volumes);
    succeeded(run());
    int compared = 0;
    for (const auto& row : curve("g0")) {
        const double depth = std::stod(row.at("value")), truth = rate_above(depth * k_release_area),
                     rate = std::stod(row.at("rate"));
        if (depth <= 1 || depth >= 4) continue;
        // 2 % for the slope of the outline's cells; the interval of 5 to 95 % is that of one deviation of 1.64.
        EXPECT_GE(truth, std::stod(row.at("low")) - 0.02 * truth) << depth;
        EXPECT_LE(truth, std::stod(row.at("high")) + 0.02 * truth) << depth;
        EXPECT_NEAR(rate / truth, 1, 0.25) << depth;
        // Of a gamma distribution the median lies below the mean.
        EXPECT_GT(std::stod(row.at("median")), std::stod(row.at("low"))) << depth;
        EXPECT_LT(std::stod(row.at("median")), rate) << depth;
        ++compared;
    }
    EXPECT_GE(compared, 3);
}

// Of a power law between limits the rate of a depth changes with the exponent in closed form.
TEST_F(Frequency, AnUncertainLawOfVolumesWidensTheBand) {
    constexpr double k_least = 2000, k_most = 16000, k_exponent = 1.2, k_error = 0.15, k_rate = 0.05;
    write_dtm([](int, int column) { return 300 - 0.05 * column * k_cell; });
    const auto band_of = [&](const std::string& more) {
        write_study("samples = 256\n",
                    "[set]\nmaterial.friction-angle = 45\ntime.end = 1\n[vary]\nrelease.volume = "
                    "pareto(2000, 1.2, 16000)\n[frequency]\nrate = 0.05\n" +
                        more);
        succeeded(run({"--overwrite"}));
        return std::pair(band("out/annual_rate_depth_2", 1), band("out/annual_rate_depth_2", 2));
    };
    write("scene.ini", read_text(path("scene.ini")) + "depth-thresholds = 2\n");
    const auto [rate, certain] = band_of("");
    const auto [same, uncertain] = band_of("exponent-error = 0.15\n");
    EXPECT_EQ(rate, same);
    const auto above = [&](double exponent) {
        const double v = 2 * k_release_area, to = std::pow(k_most, -exponent);
        return k_rate * (std::pow(v, -exponent) - to) / (std::pow(k_least, -exponent) - to);
    };
    const double change = (above(k_exponent + 0.01) - above(k_exponent - 0.01)) / 0.02 * k_error;
    int compared = 0;
    for (std::size_t cell = 0; cell < rate.size(); ++cell) {
        if (!(std::abs(rate[cell] / above(k_exponent) - 1) < 0.1)) continue;
        const double added = std::sqrt(uncertain[cell] * uncertain[cell] - certain[cell] * certain[cell]) / 1.96;
        EXPECT_NEAR(added / std::abs(change), 1, 0.05) << "the volumes are a sample of 256";
        ++compared;
    }
    EXPECT_GT(compared, 20);
}

// A step of fragility breaks what a rate counts: the damage of a year is that rate times the value, with its band; a
// log-normal curve is the sum of such steps over the hazard curve, which is known in closed form.
TEST_F(Frequency, DamageOfAPileAtRestIsThatOfItsHazardCurve) {
    write_dtm([](int, int column) { return 300 - 0.05 * column * k_cell; });
    write_features("houses", {{"Point", {{45, 72.5}}, R"("kind": "step", "worth": 1000)"},
                              {"Point", {{45, 72.5}}, R"("kind": "smooth", "worth": 1000)"}});
    write("fragility.csv",
          "class,state,loss_ratio,quantity,unit,median,beta\nstep,lost,1,depth,m,2,0\nsmooth,lost,1,depth,m,2,0.3\n");
    write("scene.ini",
          read_text(path("scene.ini")) +
              "depth-thresholds = 0.1, 2\nexposure = houses.geojson\n[exposure]\nfragility = fragility.csv\n"
              "value = worth\nclass = kind\n");
    write_study("samples = 64\n", "[set]\nmaterial.friction-angle = 45\ntime.end = 1\n" + k_volumes);
    succeeded(run());
    const gis::Table table = gis::read_table(path("out/exposure.csv"), "exposure");
    const auto number = [&](std::size_t row, const std::string& name) {
        const auto column = std::find(table.columns.begin(), table.columns.end(), name) - table.columns.begin();
        return std::stod(table.rows[row][static_cast<std::size_t>(column)]);
    };
    for (const std::string part : {"", "_low", "_high"})
        EXPECT_NEAR(number(0, "annual_damage" + part) / (1000 * number(0, "annual_rate_depth_2" + part)), 1, 1e-9)
            << part;
    double truth = 0;  // integral of the rate above x over d P(x)
    const auto probability = [](double x) { return 0.5 * std::erfc(-std::log(x / 2) / (0.3 * std::sqrt(2.0))); };
    constexpr double k_step = 1e-3;
    for (double x = k_step; x < 6; x += k_step)
        truth += 1000 * rate_above((x + k_step / 2) * k_release_area) * (probability(x + k_step) - probability(x));
    EXPECT_LE(number(1, "annual_damage_low"), 1.02 * truth);
    EXPECT_GE(number(1, "annual_damage_high"), 0.98 * truth);
    EXPECT_NEAR(number(1, "annual_damage") / truth, 1, 0.1);
    const Json sum = parse_json(read_text(path("out/summary.json")))["exposure"]["annual_damage"];
    EXPECT_NEAR(sum["value"].get<double>(), number(0, "annual_damage") + number(1, "annual_damage"), 1e-9);
    EXPECT_LE(sum["low"].get<double>(), sum["value"].get<double>());
    EXPECT_LE(sum["high"].get<double>(), number(0, "annual_damage_high") + number(1, "annual_damage_high") + 1e-9);
    // Without a frequency it is that of an event: the probability times the value, with its band.
    write("plain.ini",
          "[study]\nscene = scene.ini\nsamples = 32\n[set]\nmaterial.friction-angle = 45\ntime.end = 1\n[vary]\n"
          "release.volume = uniform(2000, 8000)\n");
    succeeded(frana({"ensemble", "plain.ini", "--out", "plain", "--quiet"}));
    const gis::Table event = gis::read_table(path("plain/exposure.csv"), "exposure");
    const auto of_event = [&](const std::string& name) {
        const auto column = std::find(event.columns.begin(), event.columns.end(), name) - event.columns.begin();
        return std::stod(event.rows[0].at(static_cast<std::size_t>(column)));
    };
    const double chance = of_event("probability_depth_2");
    EXPECT_NEAR(chance, 2.0 / 3, 0.1);
    EXPECT_NEAR(of_event("expected_damage") / (1000 * chance), 1, 1e-6);
    EXPECT_LT(of_event("expected_damage_low"), 1000 * chance);
    EXPECT_GT(of_event("expected_damage_high"), 1000 * chance);
    // One over the rate, and its bands turned round.
    const std::vector<double> rates = band("out/annual_rate_depth_2", 1), margins = band("out/annual_rate_depth_2", 2),
                              periods = band("out/return_period_depth_2", 1),
                              low = band("out/return_period_depth_2", 2), high = band("out/return_period_depth_2", 3);
    int some = 0;
    for (std::size_t cell = 0; cell < rates.size(); ++cell) {
        if (!(rates[cell] > 0)) {
            EXPECT_EQ(periods[cell], -9999) << "never";
            continue;
        }
        ++some;
        EXPECT_NEAR(periods[cell] * rates[cell], 1, 1e-5);
        EXPECT_NEAR(low[cell] * (rates[cell] + margins[cell]), 1, 1e-5);
        if (rates[cell] > margins[cell])
            EXPECT_NEAR(high[cell] * (rates[cell] - margins[cell]), 1, 1e-4);
        else
            EXPECT_EQ(high[cell], -9999);
    }
    EXPECT_GT(some, 10);
}

// Where the flow comes to is a function of the volume: between the greatest that does not come and the least that does.
TEST_F(Frequency, RatesAtDistancesAreWithinTheirMargins) {
    write_study("samples = 64\nkeep = all\n",
                "[set]\ntime.end = 20\n[frequency]\nrate = 0.05 +- 0.02\n" + k_volumes.substr(12));
    succeeded(run());
    const std::string raster = "out/annual_rate_depth_0.5";
    const std::vector<double> rates = band(raster, 1), margins = band(raster, 2);
    const Rows all = members();
    int between = 0;
    for (const int column : {24, 30, 34, 36, 38, 40, 42, 44}) {
        const std::size_t cell = 15 * k_columns + static_cast<std::size_t>(column);
        double misses = 0, hits = 1e9;
        for (const auto& member : all) {
            const Raster depth =
                gis::read_result_raster(path("out/members/member_" + std::string(7 - member.at("member").size(), '0') +
                                             member.at("member") + "/max_depth.tif"));
            const double volume = std::stod(member.at("release.volume"));
            (depth.values[cell] > 0.5 ? hits = std::min(hits, volume) : misses = std::max(misses, volume));
        }
        const double rate = rates[cell];
        // The rate's own deviation is 40 %.
        EXPECT_GE(margins[cell], 1.95 * 0.4 * rate) << column;
        if (misses == 0 || hits > 8000) continue;
        ++between;
        const double of_members =
            margins[cell] > 0 ? std::sqrt(std::max(0.0, std::pow(margins[cell], 2) - std::pow(1.96 * 0.4 * rate, 2)))
                              : 0;
        EXPECT_LE(rate, rate_above(std::min(misses, hits)) + of_members) << column;
        EXPECT_GE(rate, rate_above(std::max(misses, hits)) - of_members) << column;
    }
    EXPECT_GE(between, 2);
    const Json summary = parse_json(read_text(path("out/summary.json")));
    EXPECT_EQ(summary["frequency"]["rate_per_year"], 0.05);
    EXPECT_EQ(summary["frequency"]["standard_deviation"], 0.02);
    EXPECT_EQ(summary["frequency"]["return_periods_years"].size(), 3U);
}

// One volume, one friction: the scenario, as often as it is.
TEST_F(Frequency, OfOneEventTheMapsAreThoseOfTheScenario) {
    write_study("samples = 2\n",
                "[set]\ntime.end = 20\n[frequency]\nvolumes = 4000: 50\nreturn-periods = 30, 50, 100\n");
    succeeded(run());
    const std::string end = "time.end=" + members()[0].at("time.end");  // it ran on
    succeeded(frana({"run", "scene.ini", "--set", "release.volume=4000", "--set", end, "--out", "alone"}));
    const std::vector<double> scenario = band("alone/max_depth", 1), speed = band("alone/max_velocity", 1),
                              rates = band("out/annual_rate_depth_0.5", 1), t30 = band("out/max_depth_T30", 1),
                              t50 = band("out/max_depth_T50", 1), t100 = band("out/max_depth_T100", 1),
                              fast = band("out/max_velocity_T100", 1);
    int reached = 0;
    for (std::size_t cell = 0; cell < scenario.size(); ++cell) {
        const bool comes = scenario[cell] > 0;
        reached += comes ? 1 : 0;
        EXPECT_EQ(t50[cell], scenario[cell]);
        EXPECT_EQ(t100[cell], scenario[cell]);
        EXPECT_EQ(t30[cell], comes ? 0 : -9999);
        EXPECT_EQ(fast[cell], speed[cell]);
        EXPECT_NEAR(rates[cell], scenario[cell] > 0.5 ? 0.02 : 0, 1e-9);
    }
    EXPECT_GT(reached, 50);
}

TEST_F(Frequency, SameBitsForAnyNumberOfThreadsAndAfterAKill) {
    write_study("samples = 32\n",
                "[vary]\nmaterial.friction-angle = pert(12, 15, 20)\n[correlate]\nrelease.volume "
                "material.friction-angle = -0.5\n[set]\ntime.end = 20\n" +
                    k_volumes);
    for (const std::string threads : {"1", "2"})
        succeeded(frana({"ensemble", "study.ini", "--out", "out" + threads, "--threads", threads, "--quiet"}));
    expect_same("out1", "out2");
    EXPECT_EQ(read_text(path("out1/hazard_curves.csv")), read_text(path("out2/hazard_curves.csv")));
    ASSERT_EQ(stop_after(8, SIGKILL).exit_code, -SIGKILL);
    succeeded(run({"--resume"}));
    expect_same("out1", "out");
    EXPECT_EQ(read_text(path("out1/hazard_curves.csv")), read_text(path("out/hazard_curves.csv")));
}

TEST_F(Frequency, WithoutOneThereAreNoRatesAndVolumesMustFitTheScene) {
    write_study("samples = 4\n", k_two_keys);
    succeeded(run());
    for (const std::string& name : files()) expect_no_words(name, {"annual_rate", "_T100", "hazard_curves"});
    EXPECT_FALSE(parse_json(read_text(path("out/summary.json"))).contains("frequency"));
    const auto expect_refused = [&](const std::string& words) { refusal_of(refused({"check", "study.ini"}), {words}); };
    write_study("samples = 4\n", "[frequency]\nvolumes = 2: 20, 4: 100, 8: 400\n");
    expect_refused("not in thousands");
    write("scene.ini",
          "[terrain]\ndtm = dtm.asc\n[release]\nperimeter = perimeter.geojson\nlevel = 250\n" + k_numbers_only);
    write_study("samples = 4\n", k_volumes);
    expect_refused("release.volume");
}

/// A region of slopes with a rate of their own, or volumes.
class RegionFrequency : public Frequency {
  protected:
    struct TestSource {
        std::string name, rate, volumes;
        double west = 20, south = 55;
    };
    void write_sources(const std::vector<TestSource>& sources, const std::string& rest) const {
        std::vector<TestFeature> features;
        for (const TestSource& one : sources)
            features.push_back(
                {"Polygon", box(one.west, one.south, one.west + 50, one.south + 40),
                 R"("NAME": ")" + one.name + R"(", "RATE": ")" + one.rate + R"(", "VOLUMES": ")" + one.volumes + '"'});
        write_features("perimeter", features);
        write("region.ini", "[region]\nscene = scene.ini\nname = NAME\n" + rest);
    }
    [[nodiscard]] Outcome batch(const std::vector<std::string>& more = {}, const std::string& out = "out") const {
        return frana(with_more({"batch", "region.ini", "--out", out, "--quiet"}, more));
    }
};
const std::string k_columns_of_frequency = "[columns]\nfrequency.rate = RATE\nfrequency.volumes = VOLUMES\n";

// Two piles at rest in the same place: the rate of each depth is the sum of both, in closed form.
TEST_F(RegionFrequency, RatesOfTwoSlopesAddUpToTheirSum) {
    write_dtm([](int, int column) { return 300 - 0.05 * column * k_cell; });
    write_sources({{"a", "0.05 +- 0.02", "2000: 20, 4000: 100, 8000: 400"}, {"b", "0.1", "2000: 10, 8000: 100"}},
                  "samples = 64\n[set]\nmaterial.friction-angle = 45\ntime.end = 1\n" + k_columns_of_frequency);
    succeeded(batch());
    int compared = 0;
    for (const auto& row : curve("g0")) {
        const double depth = std::stod(row.at("value")), volume = depth * k_release_area;
        if (depth <= 1 || depth >= 4) continue;
        const double truth = rate_above(volume) + 0.1 * std::pow(volume / 2000, -std::log(10) / std::log(4.0));
        // As of one slope.
        EXPECT_GE(truth, std::stod(row.at("low")) - 0.02 * truth) << depth;
        EXPECT_LE(truth, std::stod(row.at("high")) + 0.02 * truth) << depth;
        EXPECT_NEAR(std::stod(row.at("rate")) / truth, 1, 0.25) << depth;
        ++compared;
    }
    EXPECT_GE(compared, 3);
    const Json frequency = parse_json(read_text(path("out/summary.json")))["frequency"];
    EXPECT_NEAR(frequency["rate_per_year"].get<double>(), 0.15, 1e-12);
    EXPECT_NEAR(frequency["standard_deviation"].get<double>(), 0.02, 1e-12);
    EXPECT_EQ(frequency["sources"], 2);

    const gis::Table parts = gis::read_table(path("out/disaggregation.csv"), "parts");
    std::map<std::string, double> fractions, rates;  // by place, quantity and value
    for (const auto& cells : parts.rows) {
        const std::string of = cells[1] + cells[2] + cells[3];
        fractions[of] += std::stod(cells[7]);
        rates[of] += std::stod(cells[6]);
        EXPECT_GE(std::stod(cells[8]), 2000 * (1 - 1e-9)) << "of the events that exceed it";
        EXPECT_LE(std::stod(cells[8]), 8000 * (1 + 1e-9));
    }
    EXPECT_GT(fractions.size(), 1U);
    for (const auto& [of, sum] : fractions) EXPECT_NEAR(sum, 1, 1e-12) << of;
    for (const auto& row : curve("g0")) {
        const auto found = rates.find("g0max_depth_m" + row.at("value"));
        if (found == rates.end()) continue;
        EXPECT_NEAR(found->second, std::stod(row.at("rate")), 1e-12);
    }
}

// Its first slope has the draws of a study: so has its only one, with the same maps.
TEST_F(RegionFrequency, OfOneSlopeTheMapsAreThoseOfTheStudy) {
    const std::string vary =
        "[vary]\nmaterial.friction-angle = pert(12, 15, 20)\n[correlate]\nrelease.volume "
        "material.friction-angle = -0.5\n[set]\ntime.end = 20\n";
    write_sources({{"a", "", "2000: 20, 4000: 100, 8000: 400"}},
                  "samples = 32\nseed = 3\n" + vary + "[columns]\nfrequency.volumes = VOLUMES\n");
    succeeded(batch({}, "region"));
    write_study("samples = 32\nseed = 3\n", vary + k_volumes);
    succeeded(run());
    double greatest = 0;
    for (const std::string name :
         {"annual_rate_depth_0.5", "annual_rate_velocity_5", "max_depth_T100", "max_velocity_T300"})
        for (const int number : {1, 2}) {
            const std::vector<double> of_study = band("out/" + name, number),
                                      of_region = band("region/" + name, number);
            EXPECT_EQ(of_study, of_region) << name << ' ' << number;
            greatest = std::max(greatest, *std::max_element(of_study.begin(), of_study.end()));
        }
    EXPECT_GT(greatest, 1);
    EXPECT_EQ(read_text(path("out/hazard_curves.csv")), read_text(path("region/hazard_curves.csv")));
}

// What is exceeded once in so many years lies in its interval, and the rate at its ends is that of the interval.
TEST_F(RegionFrequency, ValuesOfAReturnPeriodAreWithinTheirBands) {
    write_study("samples = 64\n", "[set]\ntime.end = 20\n" + k_volumes);
    succeeded(run());
    const std::vector<double> value = band("out/max_depth_T100", 1), low = band("out/max_depth_T100", 2),
                              high = band("out/max_depth_T100", 3);
    int known = 0, wide = 0;
    for (std::size_t cell = 0; cell < value.size(); ++cell) {
        if (value[cell] < 0) continue;
        EXPECT_LE(low[cell], value[cell]);
        if (high[cell] == -9999) continue;
        ++known;
        EXPECT_GE(high[cell], value[cell]);
        wide += high[cell] > low[cell] ? 1 : 0;
    }
    EXPECT_GT(known, 50);
    EXPECT_GT(wide, known / 2);
}

TEST_F(RegionFrequency, SameBitsForAnyNumberOfThreadsAndAfterAKill) {
    write_sources({{"a", "0.05", ""}, {"b", "0.02 +- 0.01", "", 25, 20}},
                  "samples = 16\n[vary]\nmaterial.friction-angle = uniform(12, 20)\n[set]\ntime.end = 20\n[columns]\n"
                  "frequency.rate = RATE\n");
    const Json slopes = Json::parse(frana({"check", "region.ini", "--json"}).out).at("slopes");
    EXPECT_EQ(slopes[0].at("annual_rate"), 0.05);
    EXPECT_EQ(slopes[0].at("annual_rate_deviation"), 0);
    EXPECT_EQ(slopes[1].at("annual_rate"), 0.02);
    EXPECT_EQ(slopes[1].at("annual_rate_deviation"), 0.01);
    for (const std::string threads : {"1", "2"}) succeeded(batch({"--threads", threads}, "out" + threads));
    {
        StartedProgram program(folder_.string(), {"batch", "region.ini", "--out", "out", "--threads", "2"});
        EXPECT_TRUE(program.wait_until([&] { return records().size() >= 8; }));
        program.send(SIGKILL);
        ASSERT_EQ(program.wait().exit_code, -SIGKILL);
    }
    succeeded(batch({"--resume"}));
    for (const std::string other : {"out2", "out"}) {
        for (const char* name : {"annual_rate_depth_0.5", "max_depth_T100"})
            for (const int number : {1, 2})
                EXPECT_EQ(band(std::string("out1/") + name, number), band(other + "/" + name, number));
        EXPECT_EQ(read_text(path("out1/disaggregation.csv")), read_text(path(other + "/disaggregation.csv")));
    }
}

TEST_F(RegionFrequency, WhatAFrequencyNeedsIsAsked) {
    const auto expect_refused = [&](const std::string& rest, const std::string& words) {
        write_sources({{"a", "0.05", "2000: 20"}}, rest);
        refusal_of(refused({"check", "region.ini"}), {words});
    };
    const std::string vary = "[vary]\nmaterial.friction-angle = uniform(12, 20)\n";
    expect_refused(vary, "needs a frequency");
    expect_refused("samples = 9\n", "has no effect without a frequency");
    expect_refused("[columns]\nfrequency.rate = RATE\n", "has no key");
    expect_refused("scenario = NAME\n" + vary + "[frequency]\nrate = 0.1\n", "an event has one of the two");
    expect_refused(vary + "[columns]\nfrequency.rate = RAT\n", "Did you mean RATE?");
    expect_refused("[columns]\nfrequency.rate = RATE\nmaterial.friction-angle = VOLUMES\n" + vary, "also has a column");
    write_sources({{"a", "0.05", ""}, {"b", "5 %", ""}}, vary + "[columns]\nfrequency.rate = RATE\n");
    const Outcome outcome = succeeded(frana({"check", "region.ini"}));
    EXPECT_NE(outcome.out.find("is not a number of events a year"), std::string::npos) << outcome.out;
    // One slope without volumes fails alone, whether something else varies or not.
    for (const std::string& more : {std::string(), vary}) {
        write_sources({{"a", "", "abc"}, {"b", "", "2000: 20, 4000: 100"}},
                      "samples = 16\n" + more + "[set]\ntime.end = 1\n[columns]\nfrequency.volumes = VOLUMES\n");
        const Outcome check = succeeded(frana({"check", "region.ini"}));
        EXPECT_NE(check.out.find("is not of the form 8000: 20"), std::string::npos) << check.out;
        EXPECT_EQ(batch({"--overwrite"}).exit_code, 3) << "half of the runs failed";
        EXPECT_EQ(members().size(), 32U);
    }
}

// Rasters of single events with how often each happens, as other programs take them, make the same rates.
TEST_F(RegionFrequency, KeptMembersWithTheirRatesMakeTheMapAgain) {
    write_sources({{"a", "0.05", ""}, {"b", "0.02 +- 0.01", "", 25, 20}},
                  "samples = 16\nkeep = all\n[vary]\nmaterial.friction-angle = uniform(12, 20)\n[set]\ntime.end = "
                  "20\n[columns]\nfrequency.rate = RATE\n");
    succeeded(batch());
    std::vector<double> sums(static_cast<std::size_t>(k_columns * k_rows));
    double all = 0;
    for (const auto& member : members()) {
        const double rate = std::stod(member.at("annual_rate"));
        all += rate;
        const std::string number = member.at("member");
        const std::vector<double> depth =
            band("out/members/member_" + std::string(7 - number.size(), '0') + number + "/max_depth", 1);
        for (std::size_t cell = 0; cell < sums.size(); ++cell) sums[cell] += depth[cell] > 0.5 ? rate : 0;
    }
    EXPECT_NEAR(all, 0.07, 1e-9);
    const std::vector<double> rates = band("out/annual_rate_depth_0.5", 1);
    for (std::size_t cell = 0; cell < sums.size(); ++cell) EXPECT_NEAR(rates[cell], sums[cell], 1e-8);
}

// Depth times the square of the speed at one moment, never more than of both maxima.
TEST_F(Frequency, MomentumFluxIsRecordedWhereItIsAskedFor) {
    write("scene.ini", read_text(path("scene.ini")) + "momentum-flux-thresholds = 20\nrasters = max_momentum_flux\n");
    succeeded(frana({"run", "scene.ini", "--out", "alone"}));
    const std::vector<double> momentum = band("alone/max_momentum_flux", 1), depth = band("alone/max_depth", 1),
                              speed = band("alone/max_velocity", 1);
    double greatest = 0;
    for (std::size_t cell = 0; cell < momentum.size(); ++cell) {
        EXPECT_EQ(momentum[cell] < 0, depth[cell] < 0);
        if (depth[cell] < 0) continue;
        EXPECT_LE(momentum[cell], depth[cell] * speed[cell] * speed[cell] * (1 + 1e-6));
        greatest = std::max(greatest, momentum[cell]);
    }
    EXPECT_GT(greatest, 20);
    write_study("samples = 16\n", "[set]\ntime.end = 20\n" + k_volumes);
    succeeded(run());
    const std::vector<double> rates = band("out/annual_rate_momentum_flux_20", 1),
                              chances = band("out/probability_momentum_flux_20", 1);
    EXPECT_GT(*std::max_element(rates.begin(), rates.end()), 0);
    for (std::size_t cell = 0; cell < rates.size(); ++cell) EXPECT_NEAR(rates[cell], chances[cell] / 20, 1e-8);
    const gis::Table table = gis::read_table(path("out/hazard_curves.csv"), "curves");
    EXPECT_TRUE(std::any_of(table.rows.begin(), table.rows.end(),
                            [](const auto& cells) { return cells[2] == "max_momentum_flux_m3s2"; }));
}

}  // namespace
}  // namespace frana::test
