// SPDX-License-Identifier: Apache-2.0
#include "app/study/statistics/importance.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <numeric>
#include <utility>

#include "app/study/statistics/calibration_posterior.h"

namespace frana::app::study {
namespace {

constexpr std::int64_t k_dense = 65536, k_last_seed = 2147483647, k_seed_step = 1000003;
constexpr std::size_t k_centres = 300, k_least_near = 50;
constexpr double k_least_width = 0.1;

/// Phi^-1 of all coordinates.
Places scores_of(Places places) {
    for (std::vector<double>& place : places) place = openturns().quantiles({Law::normal, {0, 1}, {}, {}, {}}, place);
    return places;
}

/// A study from a seed of its own for everything that is drawn.
StudySpec with_seed(StudySpec study, std::size_t number, std::int64_t samples) {
    study.sampling = Sampling::sobol;
    study.samples = samples;
    study.seed = (study.seed + static_cast<std::int64_t>(number) * k_seed_step) % k_last_seed;
    return study;
}

}  // namespace

ImportanceSampling::ImportanceSampling(const StudySpec& study) : study_(study) {
    dense_.places = draw_places(with_seed(study, std::size(k_round_ends), k_dense), true);
    dense_.numbers.resize(dense_.places.size());
    for (std::size_t k = 0; k < study.vary.size(); ++k) {
        const Distribution& distribution = study.vary[k].distribution;
        dense_.nominal.push_back(distribution.is_nominal());
        const std::vector<double> column = numbers_at(distribution, column_of(dense_.places, k));
        for (std::size_t i = 0; i < column.size(); ++i) dense_.numbers[i].push_back(column[i]);
        low_.push_back(*std::min_element(column.begin(), column.end()));
        high_.push_back(*std::max_element(column.begin(), column.end()));
    }
    rounds_.push_back({static_cast<std::size_t>(round_end(study, 0)), {}, {}, {}});
}

/// Values take the place of probabilities: a flow follows them smoothly also where a distribution is thin.
DesignPoints ImportanceSampling::coordinates(const std::vector<std::vector<double>>& numbers) const {
    DesignPoints points{numbers, dense_.nominal, numbers};
    for (std::vector<double>& place : points.places)
        for (std::size_t k = 0; k < place.size(); ++k) place[k] = (place[k] - low_[k]) / (high_[k] - low_[k]);
    return points;
}

double ImportanceSampling::Kernels::density(const std::vector<double>& scores) const {
    if (centres.empty()) return 1;
    double sum = 0;
    for (std::size_t c = 0; c < centres.size(); ++c) {
        double log = 0;
        for (std::size_t k = 0; k < scores.size(); ++k) {
            const double away = (scores[k] - centres[c][k]) / widths[k];
            log += (scores[k] * scores[k] - away * away) / 2 - std::log(widths[k]);
        }
        sum += weights[c] * std::exp(log);
    }
    return sum;
}

ImportanceSampling::Kernels ImportanceSampling::kernels_near(const std::vector<double>& distances,
                                                             const SampleTable& table) const {
    Kernels kernels;
    std::vector<double> known;
    std::vector<std::vector<double>> numbers;
    for (std::size_t i = 0; i < distances.size(); ++i) {
        if (std::isnan(distances[i])) continue;
        known.push_back(distances[i]);
        numbers.push_back(table.numbers[i]);
    }
    if (known.size() < 2) return kernels;
    const Chaos chaos = openturns().chaos(coordinates(numbers), {known}, coordinates(dense_.numbers)).front();
    if (chaos.elsewhere.empty()) return kernels;
    double squares = 0;
    for (std::size_t i = 0; i < known.size(); ++i) squares += std::pow(known[i] - chaos.left_out[i], 2);
    const double scatter = std::max(1e-9, std::sqrt(squares / static_cast<double>(known.size())));
    std::vector<double> sorted = chaos.elsewhere, weights;
    std::nth_element(sorted.begin(), sorted.begin() + k_least_near, sorted.end(), std::greater<>());
    for (const double one : chaos.elsewhere)
        weights.push_back(normal_below((one - std::min(0.0, sorted[k_least_near])) / scatter));
    const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
    for (double& weight : weights) weight /= sum;
    std::size_t last = dense_.places.size();
    for (const std::size_t i : drawn(weights, k_centres)) {
        if (std::exchange(last, i) != i) {
            kernels.centres.push_back(dense_.places[i]);
            kernels.weights.push_back(0);
        }
        kernels.weights.back() += 1.0 / static_cast<double>(k_centres);
    }
    kernels.centres = scores_of(std::move(kernels.centres));
    kernels.widths = kernel_widths(kernels.centres, kernels.weights, k_least_width);
    return kernels;
}

Places ImportanceSampling::draw(const Kernels& kernels, std::size_t round) const {
    StudySpec drawn = with_seed(study_, round, static_cast<std::int64_t>(kernels.members));
    if (kernels.centres.empty()) return draw_places(drawn, true);
    drawn.vary.emplace_back();  // the first coordinate chooses the centre
    Places places;
    for (const std::vector<double>& even : draw_places(drawn, true)) {
        std::size_t chosen = 0;
        for (double below = kernels.weights[0]; below < even[0] && chosen + 1 < kernels.centres.size();)
            below += kernels.weights[++chosen];
        const std::vector<double>& centre = kernels.centres[chosen];
        const std::vector<double> scores = scores_of({{even.begin() + 1, even.end()}}).front();
        std::vector<double>& place = places.emplace_back();
        for (std::size_t k = 0; k < scores.size(); ++k)
            place.push_back(std::clamp(normal_below(centre[k] + kernels.widths[k] * scores[k]), 0x1p-53, 1 - 0x1p-53));
    }
    return places;
}

void ImportanceSampling::add_round(const std::vector<double>& distances, SampleTable& table) {
    const std::size_t round = rounds_.size();
    Kernels kernels = kernels_near(distances, table);
    kernels.members = static_cast<std::size_t>(round_end(study_, round)) - table.size();
    Problems of_values;  // a value outside its key's range: the member fails with the reason
    const SampleTable more = samples_at(study_, draw(kernels, round), "", of_values);
    for (std::size_t i = 0; i < more.size(); ++i) {
        table.values.push_back(more.values[i]);
        table.numbers.push_back(more.numbers[i]);
        table.places.push_back(more.places[i]);
        table.parts.push_back(round * k_replicates + i % k_replicates);
    }
    rounds_.push_back(std::move(kernels));
    table.weights.clear();
    for (const std::vector<double>& scores : scores_of(table.places)) {
        double sum = 0;
        for (const Kernels& one : rounds_)
            sum += static_cast<double>(one.members) / static_cast<double>(table.size()) * one.density(scores);
        table.weights.push_back(1 / sum);
    }
}

}  // namespace frana::app::study
