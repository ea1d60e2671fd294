// SPDX-License-Identifier: Apache-2.0
#include "study/openturns/refined.h"

#include <openturns/ComposedDistribution.hxx>
#include <openturns/Mixture.hxx>
#include <openturns/RandomGenerator.hxx>
#include <openturns/TBB.hxx>
#include <openturns/TruncatedNormal.hxx>
#include <openturns/Uniform.hxx>

namespace frana::study {
namespace {

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

}  // namespace

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

}  // namespace frana::study
