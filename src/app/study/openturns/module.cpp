// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <openturns/ComposedDistribution.hxx>
#include <openturns/Exception.hxx>
#include <openturns/LHSExperiment.hxx>
#include <openturns/LogNormal.hxx>
#include <openturns/LogNormalMuSigma.hxx>
#include <openturns/LogUniform.hxx>
#include <openturns/LowDiscrepancyExperiment.hxx>
#include <openturns/MartinezSensitivityAlgorithm.hxx>
#include <openturns/Mixture.hxx>
#include <openturns/MonteCarloExperiment.hxx>
#include <openturns/Normal.hxx>
#include <openturns/NormalCopula.hxx>
#include <openturns/ParametrizedDistribution.hxx>
#include <openturns/RandomGenerator.hxx>
#include <openturns/SobolIndicesExperiment.hxx>
#include <openturns/SobolSequence.hxx>
#include <openturns/TBB.hxx>
#include <openturns/Triangular.hxx>
#include <openturns/TruncatedDistribution.hxx>
#include <openturns/TruncatedNormal.hxx>
#include <openturns/Uniform.hxx>
#include <vector>

#include "app/study/openturns/functions.h"
#include "core/module.h"

namespace frana::app::study {
namespace {

OT::CorrelationMatrix rank_correlations(const StudySpec& study) {
    OT::CorrelationMatrix rho(study.vary.size());
    const auto index = [&](const std::string& key) {
        const auto found =
            std::find_if(study.vary.begin(), study.vary.end(), [&](const Variation& one) { return one.key == key; });
        return static_cast<std::size_t>(found - study.vary.begin());
    };
    for (const Correlation& one : study.correlate) rho(index(one.first), index(one.second)) = one.rho;
    return rho;
}

OT::Sample independent_points(const StudySpec& study) {
    const OT::UnsignedInteger keys = study.vary.size(), count = static_cast<OT::UnsignedInteger>(study.samples);
    const OT::ComposedDistribution cube{OT::Collection<OT::Distribution>(keys, OT::Uniform(0, 1))};
    OT::RandomGenerator::SetSeed(static_cast<OT::UnsignedInteger>(study.seed));
    switch (study.sampling) {
        case Sampling::latin_hypercube:
            return OT::LHSExperiment(cube, count, true, true).generate();
        case Sampling::random:
            return OT::MonteCarloExperiment(cube, count).generate();
        case Sampling::saltelli: {
            OT::LowDiscrepancyExperiment pairs(OT::SobolSequence(), cube, count / (keys + 2), true);
            pairs.setRandomize(true);
            return OT::SobolIndicesExperiment(pairs, false).generate();
        }
        case Sampling::sobol:
        case Sampling::grid:
        case Sampling::table:
        case Sampling::polygons:
            break;
    }
    OT::LowDiscrepancyExperiment sequence(OT::SobolSequence(), cube, count, true);
    sequence.setRandomize(true);
    return sequence.generate();
}

/// OpenturnsFunctions::independent_places.
Places independent_places(const StudySpec& study) {
    OT::TBB::SetThreadsNumber(1);
    const OT::Sample points = independent_points(study);
    Places places(points.getSize(), std::vector<double>(points.getDimension()));
    for (std::size_t i = 0; i < places.size(); ++i)
        for (std::size_t k = 0; k < places[i].size(); ++k) places[i][k] = points(i, k);
    return places;
}

/// OpenturnsFunctions::correlate.
bool correlate(const StudySpec& study, Places& places) {
    OT::TriangularMatrix factor;
    try {
        factor =
            OT::CorrelationMatrix(OT::NormalCopula::GetCorrelationFromSpearmanCorrelation(rank_correlations(study)))
                .computeCholesky();
    } catch (const OT::Exception&) {  // not positive definite
        return false;
    }
    const OT::Normal normal(0, 1);
    for (std::vector<double>& place : places) {
        OT::Point z(place.size());
        for (std::size_t k = 0; k < place.size(); ++k) z[k] = normal.computeQuantile(place[k])[0];
        const OT::Point y = factor * z;
        for (std::size_t k = 0; k < place.size(); ++k) place[k] = normal.computeCDF(y[k]);
    }
    return true;
}

OT::Distribution law_of(const Distribution& distribution) {
    const std::vector<double>& n = distribution.numbers;
    const auto cut = [&](const OT::Distribution& law) -> OT::Distribution {
        if (n.size() < 4) return law;
        return OT::TruncatedDistribution(law, n[2], n[3]);
    };
    switch (distribution.law) {
        case Law::log_uniform:
            return OT::LogUniform(std::log(n[0]), std::log(n[1]));
        case Law::normal:
            return cut(OT::Normal(n[0], n[1]));
        case Law::log_normal:
            return cut(OT::ParametrizedDistribution(OT::LogNormalMuSigma(n[0], n[1], 0)));
        case Law::triangular:
            return OT::Triangular(n[0], n[1], n[2]);
        case Law::uniform:
        case Law::choice:
        case Law::gaussian_field:
            break;
    }
    return OT::Uniform(n[0], n[1]);
}

/// OpenturnsFunctions::quantiles.
std::vector<double> quantiles(const Distribution& distribution, const std::vector<double>& places) {
    const OT::Distribution law = law_of(distribution);
    std::vector<double> values;
    for (const double place : places) values.push_back(law.computeQuantile(place)[0]);
    return values;
}

OT::Sample sample_of(const std::vector<std::vector<double>>& rows) {
    OT::Sample sample(rows.size(), rows.front().size());
    for (std::size_t i = 0; i < rows.size(); ++i)
        for (std::size_t k = 0; k < rows[i].size(); ++k) sample(i, k) = rows[i][k];
    return sample;
}

/// OpenturnsFunctions::indices.
std::vector<KeySensitivity> indices(const DesignPoints& points, const std::vector<double>& output, std::size_t groups,
                                    bool with_intervals) {
    OT::TBB::SetThreadsNumber(1);
    const std::size_t keys = points.nominal.size(), rows = output.size();
    OT::Sample values(rows, 1);
    for (std::size_t i = 0; i < rows; ++i) values(i, 0) = output[i];
    // One output at a time: with several, every question for one of them computes all.
    OT::MartinezSensitivityAlgorithm algorithm(sample_of(points.numbers), values, groups);
    algorithm.setUseAsymptoticDistribution(true);
    const OT::Point first = algorithm.getFirstOrderIndices(), total = algorithm.getTotalOrderIndices();
    std::vector<KeySensitivity> all(keys);
    for (std::size_t k = 0; k < keys; ++k)
        all[k] = {Interval{first[k], first[k], first[k]}, Interval{total[k], total[k], total[k]}, {}, "Martinez"};
    if (!with_intervals) return all;
    const OT::Interval of_first = algorithm.getFirstOrderIndicesInterval(),
                       of_total = algorithm.getTotalOrderIndicesInterval();
    for (std::size_t k = 0; k < keys; ++k) {
        all[k].first_order = Interval{first[k], of_first.getLowerBound()[k], of_first.getUpperBound()[k]};
        all[k].total = Interval{total[k], of_total.getLowerBound()[k], of_total.getUpperBound()[k]};
    }
    return all;
}

OT::Mixture proposal(const Places& design, const std::vector<double>& weights, const std::vector<double>& widths,
                     double prior_part) {
    const std::size_t keys = widths.size();
    OT::Collection<OT::Distribution> parts;
    OT::Point part_weights;
    parts.add(OT::ComposedDistribution(OT::Collection<OT::Distribution>(keys, OT::Uniform(0, 1))));
    part_weights.add(prior_part);
    for (std::size_t i = 0; i < design.size(); ++i) {
        if (weights[i] == 0) continue;
        OT::Collection<OT::Distribution> marginals;
        for (std::size_t k = 0; k < keys; ++k) marginals.add(OT::TruncatedNormal(design[i][k], widths[k], 0, 1));
        parts.add(OT::ComposedDistribution(marginals));
        part_weights.add((1 - prior_part) * weights[i]);
    }
    return {parts, part_weights};
}

/// OpenturnsFunctions::refined.
RefinedPlaces refined(const Places& design, const std::vector<double>& weights, const std::vector<double>& widths,
                      double prior_part, std::size_t count, std::int64_t seed) {
    OT::TBB::SetThreadsNumber(1);
    const OT::Mixture density = proposal(design, weights, widths, prior_part);
    OT::RandomGenerator::SetSeed(static_cast<OT::UnsignedInteger>(seed));
    const OT::Sample drawn = density.getSample(count);
    RefinedPlaces result;
    for (std::size_t i = 0; i < count; ++i) {
        const OT::Point place = drawn[i];
        result.places.emplace_back(place.begin(), place.end());
        result.density.push_back(density.computePDF(place));
    }
    return result;
}

}  // namespace
}  // namespace frana::app::study

FRANA_MODULE(frana::app::study::OpenturnsFunctions, {.quantiles = frana::app::study::quantiles,
                                                     .independent_places = frana::app::study::independent_places,
                                                     .correlate = frana::app::study::correlate,
                                                     .refined = frana::app::study::refined,
                                                     .indices = frana::app::study::indices})
