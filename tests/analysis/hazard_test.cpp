// SPDX-License-Identifier: Apache-2.0
#include "analysis/hazard.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace frana {
namespace {

using Q = HazardQuantity;

/// One row of cells with every quantity; zero unless a test sets it.
struct HazardCells {
    explicit HazardCells(std::vector<double> depths) {
        GridSpec grid;
        grid.columns = static_cast<std::int64_t>(depths.size());
        grid.rows = 1;
        depth = velocity = flux = head = pressure = deposit = momentum = Raster(grid);
        depth.values = std::move(depths);
    }
    [[nodiscard]] std::vector<double> classes(const HazardScheme& scheme) const {
        return hazard_classes(scheme, {depth, velocity, flux, head, pressure, deposit, momentum}).values;
    }
    Raster depth, velocity, flux, head, pressure, deposit, momentum;
};

HazardScheme scheme_of(std::vector<HazardCondition> conditions) {
    HazardScheme scheme;
    for (HazardCondition& condition : conditions) {
        HazardClass kind;
        kind.value = static_cast<int>(scheme.classes.size()) + 1;
        kind.condition = std::move(condition);
        scheme.classes.push_back(std::move(kind));
    }
    write_thresholds(scheme);
    return scheme;
}

TEST(Hazard, GroundUpToTheMinimumDepthHasNoClass) {
    const HazardCells cells({0.1, 0.11, k_no_data});
    HazardScheme scheme = scheme_of({{}, {{{Q::depth, 0.5}}}});
    scheme.minimum_depth = 0.1;
    const std::vector<double> classes = cells.classes(scheme);
    EXPECT_TRUE(std::isnan(classes[0]));
    EXPECT_EQ(classes[1], 1);
    EXPECT_TRUE(std::isnan(classes[2])) << "never reached";
}

// Fast and thin at the margins: classes of pressure, flux and speed are as large as their rasters say.
TEST(Hazard, OnlyDepthsNeedTheMinimumDepth) {
    HazardCells cells({0.02, 0.08, 0.09, 0.1, 0.6, k_no_data});
    cells.pressure.values = {0.5, 12, 40, 2, 1, k_no_data};
    cells.head.values = {0.1, 2, 3, 0.2, 0.7, k_no_data};
    const auto in_class = [&](HazardScheme scheme) {
        scheme.minimum_depth = 0.1;
        std::vector<double> classes = cells.classes(scheme);
        for (double& value : classes) value = std::isnan(value) ? 0 : value;
        return classes;
    };
    using Classes = std::vector<double>;
    const HazardLimit yellow{Q::pressure, 1, true}, red{Q::pressure, 10};
    EXPECT_EQ(in_class(scheme_of({{{yellow}}, {{red}}})), (Classes{0, 2, 2, 1, 1, 0}));
    EXPECT_EQ(in_class(scheme_of({{}, {{red}}})), (Classes{1, 2, 2, 1, 1, 0}))
        << "whatever pressure: all that is reached";
    EXPECT_EQ(in_class(scheme_of({{}, {{{Q::depth, 0.5}}, {red}}, {{{Q::pressure, 30}}}})),
              (Classes{0, 2, 3, 0, 2, 0}));
    EXPECT_EQ(in_class(scheme_of({{}, {{{Q::head, 1.5, true}}}})), (Classes{0, 0, 0, 0, 1, 0})) << "heights are depths";
    EXPECT_EQ(in_class(scheme_of({{}, {{red, {Q::depth, 0.05}}}})), (Classes{0, 0, 0, 0, 1, 0}));
    EXPECT_TRUE(scheme_of({{}, {{red}}}).minimum_labels().empty());
}

// Every quantity on, below and above every limit, against the conditions as a person would write them in code.
TEST(Hazard, ConditionsAreEvaluatedAsWritten) {
    struct Cell {
        double depth, velocity, flux, head, pressure, deposit, momentum;
    };
    const std::vector<double> values{0.4, 0.5, 0.7, 1, 1.5, 2, 2.5};
    std::vector<Cell> cells;
    for (const double a : values)
        for (const double b : values)
            for (const double c : values) cells.push_back({a, b, c, b, c, a, c});
    HazardCells grid(std::vector<double>(cells.size()));
    for (std::size_t i = 0; i < cells.size(); ++i) {
        grid.depth.values[i] = cells[i].depth;
        grid.velocity.values[i] = cells[i].velocity;
        grid.flux.values[i] = cells[i].flux;
        grid.head.values[i] = cells[i].head;
        grid.pressure.values[i] = cells[i].pressure;
        grid.deposit.values[i] = cells[i].deposit;
        grid.momentum.values[i] = cells[i].momentum;
    }
    const std::vector<std::pair<HazardScheme, std::function<int(const Cell&)>>> cases{
        {scheme_of({{}, {{{Q::depth, 1}, {Q::velocity, 1}}}}),
         [](const Cell& c) { return c.depth > 1 && c.velocity > 1 ? 2 : 1; }},
        {scheme_of({{}, {{{Q::depth, 0.5}}, {{Q::flux, 0.5}}}, {{{Q::depth, 2}}, {{Q::flux, 2}}}}),
         [](const Cell& c) {
             const double worst = std::max(c.depth, c.flux);
             return worst > 2 ? 3 : worst > 0.5 ? 2 : 1;
         }},
        {scheme_of({{}, {{{Q::head, 1.5, true}}, {{Q::deposit, 0.7, true}}}}),
         [](const Cell& c) { return c.head >= 1.5 || c.deposit >= 0.7 ? 2 : 1; }},
        {scheme_of({{}, {{{Q::momentum, 1, true}, {Q::depth, 0.5}}}}),
         [](const Cell& c) { return c.momentum >= 1 && c.depth > 0.5 ? 2 : 1; }},
        {scheme_of({{{{Q::pressure, 1, true}}}, {{{Q::pressure, 2}}, {{Q::pressure, 1.5}, {Q::depth, 1}}}}),
         [](const Cell& c) {
             return c.pressure > 2 || (c.pressure > 1.5 && c.depth > 1) ? 2 : c.pressure >= 1 ? 1 : 0;
         }}};
    for (std::size_t n = 0; n < cases.size(); ++n) {
        const std::vector<double> classes = grid.classes(cases[n].first);
        for (std::size_t i = 0; i < cells.size(); ++i) {
            const int expected = cases[n].second(cells[i]);
            if (expected == 0)
                ASSERT_TRUE(std::isnan(classes[i])) << n << ' ' << i;
            else
                ASSERT_EQ(classes[i], expected) << n << ' ' << i;
        }
    }
}

TEST(Hazard, AConditionFollowsFromAStricterOne) {
    const HazardCondition any{{{Q::depth, 0.5}}, {{Q::flux, 0.5}}}, high{{{Q::depth, 2}}, {{Q::flux, 2}}};
    EXPECT_TRUE(follows({}, any));
    EXPECT_FALSE(follows(any, {}));
    EXPECT_TRUE(follows(any, high));
    EXPECT_FALSE(follows(high, any));
    EXPECT_FALSE(follows({{{Q::depth, 0.5}}}, high)) << "a flux of 3 with a depth of 0.1";
    EXPECT_TRUE(follows({{{Q::depth, 1}}}, {{{Q::depth, 1}, {Q::velocity, 1}}}));
    EXPECT_TRUE(follows({{{Q::depth, 1, true}}}, {{{Q::depth, 1}}}));
    EXPECT_FALSE(follows({{{Q::depth, 1}}}, {{{Q::depth, 1, true}}})) << "at the limit";
}

TEST(Hazard, QuantitiesThatASchemeUses) {
    const HazardScheme scheme = scheme_of({{}, {{{Q::depth, 1}, {Q::velocity, 1}}, {{Q::head, 3}}}});
    for (const Q used : {Q::depth, Q::velocity, Q::head}) EXPECT_TRUE(scheme.uses(used));
    for (const Q unused : {Q::flux, Q::pressure, Q::deposit}) EXPECT_FALSE(scheme.uses(unused));
}

TEST(Hazard, EveryClassNamesItsThresholds) {
    const auto labels = [](const HazardScheme& scheme) {
        std::vector<std::string> all;
        for (const HazardClass& kind : scheme.classes) all.push_back(kind.thresholds);
        return all;
    };
    using Labels = std::vector<std::string>;
    EXPECT_EQ(labels(scheme_of({{}, {{{Q::depth, 1}, {Q::velocity, 1}}}})),
              (Labels{"depth ≤ 1 m or speed ≤ 1 m/s", "depth > 1 m and speed > 1 m/s"}));
    EXPECT_EQ(labels(scheme_of({{}, {{{Q::head, 1.5, true}}, {{Q::deposit, 0.7, true}}}})),
              (Labels{"energy head < 1.5 m and deposit < 0.7 m", "energy head ≥ 1.5 m or deposit ≥ 0.7 m"}));
    EXPECT_EQ(labels(scheme_of({{}, {{{Q::depth, 2}}, {{Q::depth, 1}, {Q::velocity, 1}}}})),
              (Labels{"all else", "depth > 2 m or depth > 1 m and speed > 1 m/s"}));
}

}  // namespace
}  // namespace frana
