// SPDX-License-Identifier: Apache-2.0
#include "app/study/statistics/importance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <functional>
#include <numbers>
#include <optional>

#include "app/study/statistics/cell_statistics.h"

namespace frana::app::study::test {
namespace {

/// Where a flow ends, of the numbers of the varied keys, and the place that it reaches with an exact probability.
struct RareScene {
    const char* name;
    std::vector<std::pair<std::string, std::string>> vary;
    std::function<double(const std::vector<double>&)> run_out;
    double place = 0;                  ///< that it passes with the probability k_rare
    double cell = 1;                   ///< in the unit of the run-out: distances are known by cells, as in records
    std::optional<double> usual = {};  ///< a place that it passes with the probability k_usual, where that is known
};

constexpr double k_rare = 1e-3, k_usual = 0.2;
// Quantiles of the normal distribution at 1 - p and 1 - p / 2.
constexpr double k_normal_999 = 3.090232306167813, k_normal_9995 = 3.290526731491926, k_normal_8 = 0.8416212335729143,
                 k_normal_9 = 1.2815515655446004;

const std::vector<RareScene>& scenes() {
    const std::string friction = "material.friction-coefficient", density = "material.density",
                      volume = "release.volume", ratio = "material.pore-pressure-ratio",
                      direction = "release.thickness-direction";
    static const std::vector<RareScene> k_scenes{
        {"one key", {{friction, "uniform(0.1, 0.3)"}}, [](const auto& x) { return -x[0]; }, -0.1002, 0.005, -0.14},
        // The sum of three standard normal values over root 3 is one.
        {"three normal keys",
         {{friction, "normal(0.3, 0.02)"}, {density, "normal(2000, 50)"}, {volume, "normal(3000, 200)"}},
         [](const auto& x) {
             return ((0.3 - x[0]) / 0.02 + (x[1] - 2000) / 50 + (x[2] - 3000) / 200) / std::numbers::sqrt3;
         },
         k_normal_999,
         0.1,
         k_normal_8},
        // The product of two even values is greater than c with probability 1 - c + c ln c.
        {"a corner of two even keys and a choice of one in four",
         {{friction, "uniform(0, 1)"}, {ratio, "uniform(0, 0.9)"}, {direction, "choice(vertical: 3, normal: 1)"}},
         [](const auto& x) { return (1 - x[0]) * x[1] / 0.9 + x[2]; },
         1.9119007972677873,
         0.02},
        {"two ways",
         {{density, "normal(2000, 50)"}, {volume, "uniform(2000, 4000)"}},
         [](const auto& x) { return std::abs(x[0] - 2000) / 50; },
         k_normal_9995,
         0.1,
         k_normal_9}};
    return k_scenes;
}

StudySpec study_of(const RareScene& scene, Sampling sampling, std::int64_t seed) {
    StudySpec study;
    study.sampling = sampling;
    study.samples = 128;
    study.seed = seed;
    for (const auto& [key, text] : scene.vary)
        study.vary.push_back({key, std::get<Distribution>(distribution_from_text(text))});
    return study;
}

/// Members as the program draws them, round by round.
SampleTable drawn_members(const RareScene& scene, const StudySpec& study) {
    Problems problems;
    SampleTable table = draw_samples(study, "study.ini", problems);
    EXPECT_TRUE(problems.empty());
    if (study.sampling != Sampling::importance) return table;
    ImportanceSampling sampling(study);
    while (static_cast<std::int64_t>(table.size()) < study.samples) {
        std::vector<double> distances;
        for (const auto& numbers : table.numbers)
            distances.push_back(std::floor((scene.run_out(numbers) - scene.place) / scene.cell) + 0.5);
        sampling.add_round(distances, table);
    }
    return table;
}

Estimate probability_of(const RareScene& scene, const SampleTable& table, double place) {
    FinishedMembers members;
    members.weights = table.weights;
    members.records.resize(table.size());
    std::vector<float> values;
    for (std::size_t m = 0; m < table.size(); ++m) {
        members.replicates.push_back(table.replicate_of(m));
        values.push_back(scene.run_out(table.numbers[m]) > place ? 1 : 0);
    }
    return MeanEstimate(members).probability(values, 0.5);
}

/// Of many studies that differ in their seed, at a place with a known probability.
struct Scatter {
    double place = 0, exact = 0;
    double mean = 0, squares = 0, stated = 0, held = 0;  ///< means over the studies

    void add(const Estimate& p, double part) {
        mean += part * p.value;
        squares += part * (p.value - exact) * (p.value - exact);
        stated += part * p.error * p.error;
        held += exact >= p.low() && exact <= p.high() ? part : 0;
    }
    [[nodiscard]] double relative_error() const { return std::sqrt(squares) / exact; }
    [[nodiscard]] double bias() const { return mean / exact - 1; }
    [[nodiscard]] double ratio() const { return std::sqrt(stated / squares); }
    /// Plain members that would be as exact, over those of a study.
    [[nodiscard]] double gain() const { return exact * (1 - exact) / 128 / squares; }
};

// 128 members each, of which plain ones would come to the rare place once in eight studies. The scatter of 80 studies
// is known to 1 / sqrt(160) = 8 %, their mean to error / sqrt(80): one of seven may be off by four times that.
TEST(Importance, ARareProbabilityIsRightOnAverageAndSoIsItsError) {
    constexpr int k_studies = 80;
    for (const RareScene& scene : scenes()) {
        std::vector<Scatter> all{{scene.place, k_rare}};
        if (scene.usual) all.push_back({*scene.usual, k_usual});
        for (int i = 0; i < k_studies; ++i) {
            const SampleTable table = drawn_members(scene, study_of(scene, Sampling::importance, i));
            for (Scatter& one : all) one.add(probability_of(scene, table, one.place), 1.0 / k_studies);
        }
        for (const Scatter& one : all) {
            std::printf(
                "%s: p = %g, mean off by %.1f %%, error %.0f %% of p, stated over true %.2f, interval holds "
                "%.0f %%, as exact as %.1f times as many plain members\n",
                scene.name, one.exact, 100 * one.bias(), 100 * one.relative_error(), one.ratio(), 100 * one.held,
                one.gain());
            EXPECT_LT(std::abs(one.bias()), 4 * one.relative_error() / std::sqrt(k_studies)) << scene.name;
            EXPECT_TRUE(one.ratio() > 0.8 && one.ratio() < 1.25) << scene.name << ": " << one.ratio();
            EXPECT_GT(one.held, 0.9) << scene.name;
        }
        EXPECT_GT(all.front().gain(), 40) << scene.name;
    }
}

}  // namespace
}  // namespace frana::app::study::test
