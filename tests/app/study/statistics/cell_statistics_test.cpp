// SPDX-License-Identifier: Apache-2.0
#include "app/study/statistics/cell_statistics.h"

#include <array>
#include <cmath>
#include <fstream>
#include <functional>

#include "app/study/plan/sampling.h"
#include "app/study/statistics/study_maps.h"
#include "core/files.h"
#include "study/records.h"

namespace frana::app::study::test {
namespace {

class Cells : public Records {};

TEST_F(Cells, ProbabilityIsTheFractionOfMembersAboveTheThreshold) {
    add(record(0, {0.2F, 0.6F}));
    add(record(1, {0.7F}));
    add(record(0, {0.5F}));
    add(record(1, {0.4F}));
    const QuantityMaps maps = quantity_maps(runs(), Quantity::depth, grid_, {0.1, 0.5});
    EXPECT_EQ(maps.probability[0].at(0, 0), 0.5);
    EXPECT_EQ(maps.probability[1].at(0, 0), 0);  // 0.5 is not more than 0.5
    EXPECT_EQ(maps.probability[1].at(0, 1), 0.5);
    EXPECT_NEAR(maps.errors.largest(), 0.25, 1e-12);  // sqrt(0.5 * 0.5 / 4)
    EXPECT_NEAR(maps.margin[1].at(0, 1), 1.96 * 0.25, 1e-4);
    // Where nobody came the probability is 0, and no gap, but not known exactly.
    EXPECT_EQ(maps.probability[0].at(2, 3), 0);
    EXPECT_EQ(maps.margin[0].at(2, 3), 0.75);  // 3 / 4
    EXPECT_TRUE(std::isnan(maps.hits.at(2, 3)));
    EXPECT_EQ(maps.hits.at(0, 1), 3);
    const QuantityMaps arrival = quantity_maps(runs(), Quantity::arrival, grid_, {});
    EXPECT_FLOAT_EQ(static_cast<float>(arrival.quantile[1].at(0, 0)), 1.2F);  // of the two that came
}

// Weights of 49 members of 1/49 add up to 1 - 2e-16 or more, by their order: an error of 1e-8 where it is 0.
TEST_F(Cells, WhereAllMembersCameTheProbabilityIsOneWithinAMargin) {
    for (int i = 0; i < 49; ++i) add(record(0, {1}));
    for (double& weight : members_.weights) weight = 1.0 / 49;
    const QuantityMaps maps = quantity_maps(runs(), Quantity::depth, grid_, {0.5});
    EXPECT_EQ(maps.probability[0].at(0, 0), 1);
    EXPECT_NEAR(maps.margin[0].at(0, 0), 3.0 / 49, 1e-12);
    EXPECT_EQ(maps.errors.mean(), 0);
}

// Two runs finished, one was cut on its way, one failed: 1 of 3 at the first cell may be 3 of 4.
TEST_F(Cells, WhatWasCutOrFailedMayHaveComeAnywhere) {
    add(record(0, {1, 1}));  // finished
    add(record(0, {0.1F}));  // finished
    add(record(4, {1}));     // cut: it counts as far as it came
    StudyRuns all = runs();
    all.is_open = {false, false, true, true};
    all.all.records.push_back(keep("failed", record(8, {2})));
    all.all.weights.assign(4, 0.25);
    const QuantityMaps maps = quantity_maps(all, Quantity::depth, grid_, {0.5});
    const Raster& upper = maps.upper.front();
    EXPECT_TRUE(std::isnan(maps.hits.at(2, 0)));  // only the failed one came
    EXPECT_DOUBLE_EQ(maps.probability[0].at(0, 0), 1.0 / 3);
    EXPECT_DOUBLE_EQ(upper.at(0, 0), 0.75);
    EXPECT_DOUBLE_EQ(maps.probability[0].at(1, 0), 1.0 / 3);
    EXPECT_DOUBLE_EQ(upper.at(1, 0), 0.5);  // the cut one came, and is not counted twice
    EXPECT_DOUBLE_EQ(upper.at(2, 3), 0.5);  // where nobody came
    for (std::size_t i = 0; i < upper.values.size(); ++i) EXPECT_GE(upper.values[i], maps.probability[0].values[i]);
}

// One of five runs is open: half of all is 5/8 of the others, and the 95 % quantile has no bound.
TEST_F(Cells, AQuantileIsBoundedByTheRunsThatEnded) {
    for (const float depth : {1, 2, 3, 4}) add(record(0, {depth}));
    StudyRuns all = runs();
    all.is_open = {false, false, false, false, true};
    all.all.records.push_back(keep("open", record(0, {0.5F})));
    all.all.weights.assign(5, 0.2);
    const QuantityMaps maps = quantity_maps(all, Quantity::depth, grid_, {});
    const auto& upper = maps.quantile_upper;
    ASSERT_TRUE(upper[0] && upper[1]);
    EXPECT_EQ(upper[0]->at(0, 0), 1);
    EXPECT_EQ(upper[1]->at(0, 0), 3);
    EXPECT_FALSE(upper[2]);
    EXPECT_EQ(maps.quantile[1].at(0, 0), 2);
}

TEST_F(Cells, WeightsCountAsCopiesOfMembers) {
    add(record(0, {1}));
    add(record(0, {2}));
    members_.weights = {0.75, 0.25};
    const QuantityMaps weighted = quantity_maps(runs(), Quantity::depth, grid_, {1.5});
    add(record(0, {1}));
    add(record(0, {1}));
    const QuantityMaps copies = quantity_maps(runs(), Quantity::depth, grid_, {1.5});
    EXPECT_DOUBLE_EQ(weighted.probability[0].at(0, 0), copies.probability[0].at(0, 0));
    for (std::size_t q = 0; q < 3; ++q) EXPECT_EQ(weighted.quantile[q].at(0, 0), copies.quantile[q].at(0, 0)) << q;
    EXPECT_DOUBLE_EQ(effective_count({0.75, 0.25}), 1.6);  // 1 / (9/16 + 1/16)
}

TEST(WeightedQuantile, IsTheLeastValueWithEnoughWeightBelow) {
    const std::vector<float> values{5, 1, 3, 2, 4};
    const std::vector<double> weights(5, 0.2);
    std::vector<std::size_t> order;
    EXPECT_EQ(weighted_quantile(values, weights, 0.5, order), 3);
    EXPECT_EQ(weighted_quantile(values, weights, 0.2, order), 1);
    EXPECT_EQ(weighted_quantile(values, weights, 0.21, order), 2);
    EXPECT_EQ(weighted_quantile(values, weights, 1, order), 5);
}

// The members of a replicate depend on each other: the error is that of the replicates' means.
TEST_F(Cells, ReplicatesThatAgreeCountOnce) {
    for (int i = 0; i < 8; ++i) {
        add(record(0, {i % 2 == 0 ? 1.0F : 0.0F}));
        members_.replicates.push_back(static_cast<std::size_t>(i % 4));
    }
    const QuantityMaps maps = quantity_maps(runs(), Quantity::depth, grid_, {0.5});
    EXPECT_EQ(maps.probability[0].at(0, 0), 0.5);
    const double error = 0.5 / std::sqrt(3.0);  // sd of 1, 0, 1, 0 over sqrt(4)
    EXPECT_DOUBLE_EQ(maps.errors.largest(), error);
    EXPECT_NEAR(maps.margin[0].at(0, 0), 3.1824 * error, 1e-9);  // Student's t with 3 degrees of freedom
}

/// Bytes that this process has read so far.
double bytes_read() {
    std::ifstream file("/proc/self/io");
    std::string name;
    double bytes = 0;
    file >> name >> bytes;
    return bytes;
}

// Ten times as many members make three quantities read ten times as many bytes: each record once from one file, and of
// those that have no place in memory the values of a quantity whenever it is asked for.
TEST_F(Cells, TenThousandMembersAreReadOnce) {
    grid_.columns = grid_.rows = 100;
    grid_.north = 1000;
    double read[2], size = 0;
    std::size_t count = 0;
    std::filesystem::create_directories(folder_ / "records");
    RecordFiles files(folder_.string());
    for (const std::size_t members : {1000U, 10000U}) {
        for (std::size_t m = members_.records.size(); m < members; ++m) {
            MemberRecord one = record(m * 37 % 5000, std::vector<float>(250, static_cast<float>(m % 7)));
            one.north = 1000;
            one.columns = one.rows = 100;
            const std::string bytes = bytes_of(one);
            files.append(m, bytes);
            members_.records.push_back(files.place(m));
            size = static_cast<double>(bytes.size());
        }
        members_.weights.assign(members, 1.0 / static_cast<double>(members));
        members_.store = std::make_shared<CellStore>(members_.records);
        const double before = bytes_read();
        for (const Quantity quantity : {Quantity::depth, Quantity::velocity, Quantity::arrival}) {
            double came = 0, exact = 0;
            for_each_hit_cell(members_, quantity, grid_, [&](std::size_t, Hits hits) {
                came += static_cast<double>(std::count_if(hits.begin(), hits.end(), [](const auto& one) {
                    return one.value > 0 && std::isfinite(one.value);
                }));
            });
            for (std::size_t m = 0; m < members; ++m)  // arrivals are one more than depths
                exact += m % 7 > 0 || quantity == Quantity::arrival ? 250 : 0;
            EXPECT_EQ(came, exact);
        }
        read[count++] = (bytes_read() - before) / (size * static_cast<double>(members));
    }
    EXPECT_NEAR(read[0], 1, 0.05);
    EXPECT_LT(read[1], 4);
}

/// A scene that costs nothing: how far the material comes, of the numbers of the varied keys.
struct CheapScene {
    std::vector<std::pair<std::string, std::string>> vary;
    std::vector<Correlation> correlate;
    std::function<double(const std::vector<double>&)> run_out;
};

StudySpec study_of(const CheapScene& scene) {
    StudySpec study;
    for (const auto& [key, text] : scene.vary)
        study.vary.push_back({key, std::get<Distribution>(distribution_from_text(text))});
    study.correlate = scene.correlate;
    return study;
}

/// A study of a scene as the program draws it: its members, and the run-out of each.
struct CheapStudy {
    SampleTable table;
    FinishedMembers members;
    std::vector<double> run_out;

    CheapStudy(const CheapScene& scene, StudySpec study) {
        Problems problems;
        table = draw_samples(study, "study.ini", problems);
        EXPECT_TRUE(problems.empty());
        members.records.resize(table.size());
        members.weights = table.weights;
        for (std::size_t m = 0; m < table.size(); ++m) {
            if (table.is_replicated) members.replicates.push_back(table.replicate_of(m));
            run_out.push_back(scene.run_out(table.numbers[m]));
        }
    }
};

// An energy line with Voellmy's drag and a volume; two correlated keys whose effects meet; five with a choice, of which
// one first helps and then hinders.
const CheapScene k_cheap_scenes[] = {
    {{{"material.friction-coefficient", "uniform(0.15, 0.35)"},
      {"material.turbulence", "log-uniform(300, 3000)"},
      {"release.volume", "triangular(2000, 3000, 6000)"}},
     {},
     [](const std::vector<double>& x) { return 4 * std::cbrt(x[2]) / (x[0] + 30 / x[1]); }},
    {{{"material.friction-coefficient", "normal(0.25, 0.05, 0.1, 0.4)"},
      {"material.pore-pressure-ratio", "uniform(0, 0.6)"}},
     {{"material.friction-coefficient", "material.pore-pressure-ratio", -0.4}},
     [](const std::vector<double>& x) { return 1 / (x[0] * (1 - x[1])); }},
    {{{"material.friction-coefficient", "uniform(0.1, 0.3)"},
      {"release.volume", "log-normal(3000, 1000)"},
      {"release.thickness-direction", "choice(vertical: 3, normal: 1)"},
      {"material.pore-pressure-ratio", "uniform(0, 0.6)"},
      {"material.density", "uniform(1500, 2500)"}},
     {},
     [](const std::vector<double>& x) {
         return x[4] / 2000 * std::cbrt(x[1]) / x[0] + 20 * x[2] + 30 * std::sin(5 * x[3]);
     }}};

// 200 studies of 64 members each, as the program draws them. Their scatter is known to 1 / sqrt(2 * 200) = 5 %, and
// the part of the intervals that hold the truth to 1.5 % at a place; what is asked is the mark: within a quarter, and
// 92 to 97 %. The truth is that of a sequence of 2^15 members, whose error is a fortieth of theirs.
TEST(Errors, AreTheScatterOfStudies) {
    constexpr int k_studies = 200, k_places = 37;
    for (const CheapScene& scene : k_cheap_scenes) {
        StudySpec study = study_of(scene);
        const auto drawn = [&](Sampling sampling, std::int64_t samples, std::int64_t seed) {
            study.sampling = sampling;
            study.samples = samples;
            study.seed = seed;
            return CheapStudy(scene, study);
        };
        std::vector<double> truth = drawn(Sampling::sobol, 32768, 99999).run_out;
        std::sort(truth.begin(), truth.end());
        for (const Sampling sampling : {Sampling::random, Sampling::sobol}) {
            double squares = 0, stated = 0, held = 0, largest = 0;
            std::array<double, k_places> of_place{};
            for (int i = 0; i < k_studies; ++i) {
                const CheapStudy drawn_study = drawn(sampling, 64, i);
                const std::vector<float> values(drawn_study.run_out.begin(), drawn_study.run_out.end());
                const MeanEstimate estimate(drawn_study.members);
                ErrorSummary summary;
                for (int place = 0; place < k_places; ++place) {
                    const double exact = 0.05 + 0.025 * place;
                    const auto far =
                        static_cast<float>(truth[static_cast<std::size_t>(std::lround((1 - exact) * 32768)) - 1]);
                    const Estimate p = estimate.probability(values, static_cast<double>(far));
                    const double square = (p.value - exact) * (p.value - exact);
                    squares += square;
                    of_place[static_cast<std::size_t>(place)] += square / k_studies;
                    stated += p.error * p.error;
                    held += std::abs(p.value - exact) <= p.margin ? 1 : 0;
                    summary.add(p);
                }
                largest += summary.largest() / k_studies;
            }
            const double ratio = std::sqrt(stated / squares), part = held / k_studies / k_places,
                         worst = std::sqrt(*std::max_element(of_place.begin(), of_place.end()));
            const std::string what = name_of(sampling) + ", scene " + std::to_string(&scene - k_cheap_scenes) +
                                     ": stated over true " + std::to_string(ratio) + ", held " + std::to_string(part) +
                                     ", largest " + std::to_string(largest) + " for " + std::to_string(worst);
            EXPECT_TRUE(ratio > 0.8 && ratio < 1.25 && part > 0.92 && part < 0.97) << what;
            EXPECT_TRUE(largest > 0.8 * worst && largest < 1.25 * worst) << what;  // by which `until` decides
        }
    }
}

// A block slides down 100 m and stops where the energy line of its friction does, x = 100 m / mu; mu falls with the
// volume, which has return periods, and has a factor of its own. The truth is integrated, of what the events with a
// volume of log exceedance e do.
TEST(Errors, RatesOfABlockAreWithinTheirMargins) {
    constexpr double k_years[] = {20, 100, 300}, k_volumes[] = {2000, 6000, 20000};
    const CheapScene block{{{"material.friction-coefficient", "uniform(0.2, 0.4)"}},
                           {},
                           [](const std::vector<double>& x) { return 100 / x[1] * std::pow(x[0] / 2000, 0.2); }};
    StudySpec study = study_of(block);
    study.frequency.rate = FrequencySpec::Rate{1 / k_years[0], 0};
    study.frequency.volumes = {{k_volumes[0], 20}, {k_volumes[1], 100}, {k_volumes[2], 300}};
    study.vary.insert(study.vary.begin(),
                      {k_volume_key, {Law::return_periods, {2000, 1, 6000, 5, 20000, 15}, {}, {}, ""}});
    study.samples = 64;
    const auto truth = [&](double far) {
        constexpr int k_parts = 20000;
        double all = 0;
        const auto beyond = [&](double volume) {  // fraction of the frictions that let it come
            return std::clamp((100 / far * std::pow(volume / 2000, 0.2) - 0.2) / 0.2, 0.0, 1.0);
        };
        for (int i = 0; i < k_parts; ++i) {
            const double exceedance = 1 - (i + 0.5) / k_parts * (1 - 1 / 15.0), years = 20 / exceedance;
            const std::size_t k = years < 100 ? 0 : 1;
            const double volume =
                k_volumes[k] * std::pow(k_volumes[k + 1] / k_volumes[k],
                                        std::log(years / k_years[k]) / std::log(k_years[k + 1] / k_years[k]));
            all += beyond(volume) * (1 - 1 / 15.0) / k_parts;
        }
        return all + beyond(k_volumes[2]) / 15;
    };
    constexpr int k_studies = 400;
    constexpr double k_places[] = {300, 400, 460, 500, 540, 620};
    double all_held = 0;
    for (const double far : k_places) {
        const double exact = truth(far);
        double held = 0, squares = 0, stated = 0, sum = 0;
        for (int seed = 0; seed < k_studies; ++seed) {
            study.seed = seed;
            const CheapStudy drawn(block, study);
            const std::vector<float> values(drawn.run_out.begin(), drawn.run_out.end());
            const Estimate p = MeanEstimate(drawn.members).probability(values, far);
            held += std::abs(p.value - exact) <= p.margin ? 1.0 / k_studies : 0;
            squares += (p.value - exact) * (p.value - exact) / k_studies;
            stated += p.error * p.error / k_studies;
            sum += p.value / k_studies;
        }
        const double ratio = std::sqrt(stated / squares);
        const std::string what = std::to_string(far) + " m, once in " + std::to_string(20 / exact) +
                                 " years: stated over true " + std::to_string(ratio) + ", held " + std::to_string(held);
        EXPECT_TRUE(ratio > 0.8 && ratio < 1.25 && held > 0.86) << what;  // of 400 studies: known to 1.5 %
        EXPECT_NEAR(sum, exact, 3 * std::sqrt(squares / k_studies)) << what;
        EXPECT_LT(std::sqrt(squares), 0.5 * exact) << what << ": rare ones are told too";
        all_held += held / static_cast<double>(std::size(k_places));
    }
    EXPECT_TRUE(all_held > 0.92 && all_held < 0.97) << all_held;
}

}  // namespace
}  // namespace frana::app::study::test
