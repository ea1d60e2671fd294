// SPDX-License-Identifier: Apache-2.0
#include "study/openturns/distributions.h"

#include <cmath>
#include <openturns/LogNormal.hxx>
#include <openturns/LogNormalMuSigma.hxx>
#include <openturns/LogUniform.hxx>
#include <openturns/Normal.hxx>
#include <openturns/ParametrizedDistribution.hxx>
#include <openturns/Triangular.hxx>
#include <openturns/TruncatedDistribution.hxx>
#include <openturns/Uniform.hxx>

namespace frana::study {
namespace {

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

}  // namespace

std::vector<double> quantiles(const Distribution& distribution, const std::vector<double>& places) {
    const OT::Distribution law = law_of(distribution);
    std::vector<double> values;
    for (const double place : places) values.push_back(law.computeQuantile(place)[0]);
    return values;
}

}  // namespace frana::study
