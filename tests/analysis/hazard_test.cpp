// SPDX-License-Identifier: Apache-2.0
#include "analysis/hazard.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.h"

namespace frana {
namespace {

/// One row of cells with every quantity; zero unless a test sets it.
struct HazardCells {
    explicit HazardCells(std::vector<double> depths) {
        GridSpec grid;
        grid.columns = static_cast<std::int64_t>(depths.size());
        grid.rows = 1;
        depth = velocity = flux = head = pressure = deposit = Raster(grid);
        depth.values = std::move(depths);
    }
    [[nodiscard]] std::vector<double> classes(const std::string& scheme, const HazardLimits& limits = {}) const {
        return hazard_classes(hazard_scheme(scheme, limits), {depth, velocity, flux, head, pressure, deposit}).values;
    }
    Raster depth, velocity, flux, head, pressure, deposit;
};

TEST(Hazard, SwissDebrisFlowNeedsDepthAndSpeedOverOne) {
    HazardCells cells({1.01, 1.01, 1, 3, 0.2, k_no_data});
    cells.velocity.values = {1.01, 1, 8, 0.5, 9, k_no_data};
    const auto classes = cells.classes("swiss-debris-flow");
    EXPECT_EQ(std::vector<double>(classes.begin(), classes.end() - 1), (std::vector<double>{3, 2, 2, 2, 2}));
    EXPECT_TRUE(std::isnan(classes.back())) << "never reached";
}

TEST(Hazard, SwissFloodUsesTheWorseOfDepthAndFlux) {
    HazardCells cells({2.01, 2, 0.5, 0.51, 0.4, 0.4, 0.4});
    cells.flux.values = {0, 0, 0, 0, 0.5, 0.51, 2.01};
    EXPECT_EQ(cells.classes("swiss-flood"), (std::vector<double>{3, 2, 1, 2, 1, 2, 3}));
}

TEST(Hazard, AustrianTorrentIsRedFromEnergyHeadOrDeposit) {
    HazardCells cells({1, 1, 1, 1});
    cells.head.values = {1.49, 1.5, 1, 1};
    cells.deposit.values = {0, 0, 0.69, 0.7};
    EXPECT_EQ(cells.classes("austrian-torrent"), (std::vector<double>{1, 2, 1, 2}));
}

TEST(Hazard, GroundUpToTheMinimumDepthHasNoClass) {
    const HazardCells cells({0.1, 0.11});
    const Raster classes =
        hazard_classes(hazard_scheme("swiss-flood", {}, 0.1),
                       {cells.depth, cells.velocity, cells.flux, cells.head, cells.pressure, cells.deposit});
    EXPECT_TRUE(std::isnan(classes.values[0]));
    EXPECT_EQ(classes.values[1], 1);
}

TEST(Hazard, CustomCountsTheLimitsExceeded) {
    HazardCells cells({0.2, 0.6, 3, 0.2, 0.2});
    cells.pressure.values = {0, 0, 0, 11, 31};
    const HazardLimits limits{{0.5}, {}, {}, {10, 30}};
    EXPECT_EQ(cells.classes("custom", limits), (std::vector<double>{1, 2, 2, 2, 3}));
    EXPECT_EQ(hazard_scheme("custom", limits).classes.size(), 3U);
}

TEST(Hazard, EveryClassOfASchemeHasItsOwnColourAndEverySchemeASource) {
    for (const std::string name : {"swiss-debris-flow", "swiss-flood", "austrian-torrent", "custom"}) {
        const HazardScheme scheme = hazard_scheme(name, {{0.5, 2}, {}, {}, {}});
        EXPECT_FALSE(scheme.source.empty());
        for (std::size_t i = 1; i < scheme.classes.size(); ++i) {
            EXPECT_EQ(scheme.classes[i].value, scheme.classes[i - 1].value + 1);
            EXPECT_NE(scheme.classes[i].colour.g, scheme.classes[i - 1].colour.g) << name;
        }
    }
    EXPECT_THROW(hazard_scheme("swiss", {}), Error);
}

TEST(Hazard, EveryClassNamesItsThresholds) {
    const auto labels = [](const std::string& name, const HazardLimits& limits = {}) {
        std::vector<std::string> all;
        for (const HazardClass& kind : hazard_scheme(name, limits).classes) all.push_back(kind.label());
        return all;
    };
    using Labels = std::vector<std::string>;
    EXPECT_EQ(labels("swiss-debris-flow"), (Labels{"Medium intensity: depth ≤ 1 m or speed ≤ 1 m/s",
                                                   "High intensity: depth > 1 m and speed > 1 m/s"}));
    EXPECT_EQ(labels("swiss-flood").back(), "High intensity: depth > 2 m or depth × speed > 2 m²/s");
    EXPECT_EQ(labels("austrian-torrent").back(), "Red zone: energy head ≥ 1.5 m or deposit ≥ 0.7 m");
    EXPECT_EQ(labels("custom", {{0.5, 2}, {}, {}, {}}), (Labels{"depth ≤ 0.5 m", "depth 0.5 – 2 m", "depth > 2 m"}));
    EXPECT_EQ(
        labels("custom", {{0.5}, {}, {}, {10, 30}}),
        (Labels{"depth ≤ 0.5 m and pressure ≤ 10 kPa", "depth > 0.5 m or pressure > 10 kPa", "pressure > 30 kPa"}));
}

TEST(Hazard, ClassesDifferInLightnessForPrintsWithoutColours) {
    for (const char* name : {"swiss-debris-flow", "swiss-flood", "austrian-torrent"}) {
        const std::vector<HazardClass> classes = hazard_scheme(name, {}).classes;
        for (std::size_t i = 1; i < classes.size(); ++i) {
            const auto tone = [](Rgb c) { return 0.299 * c.r + 0.587 * c.g + 0.114 * c.b; };  // Rec. 601, of 255
            EXPECT_LT(tone(classes[i].colour), tone(classes[i - 1].colour) - 40) << name;     // a higher intensity is
                                                                                              // darker
        }
    }
}

}  // namespace
}  // namespace frana
