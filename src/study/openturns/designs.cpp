// SPDX-License-Identifier: Apache-2.0
#include "study/openturns/designs.h"

#include <algorithm>
#include <openturns/ComposedDistribution.hxx>
#include <openturns/Exception.hxx>
#include <openturns/LHSExperiment.hxx>
#include <openturns/LowDiscrepancyExperiment.hxx>
#include <openturns/MonteCarloExperiment.hxx>
#include <openturns/Normal.hxx>
#include <openturns/NormalCopula.hxx>
#include <openturns/RandomGenerator.hxx>
#include <openturns/SobolIndicesExperiment.hxx>
#include <openturns/SobolSequence.hxx>
#include <openturns/TBB.hxx>
#include <openturns/Uniform.hxx>

namespace frana::study {
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

}  // namespace

Places independent_places(const StudySpec& study) {
    OT::TBB::SetThreadsNumber(1);
    const OT::Sample points = independent_points(study);
    Places places(points.getSize(), std::vector<double>(points.getDimension()));
    for (std::size_t i = 0; i < places.size(); ++i)
        for (std::size_t k = 0; k < places[i].size(); ++k) places[i][k] = points(i, k);
    return places;
}

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

}  // namespace frana::study
