// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <list>
#include <map>
#include <numeric>
#include <openturns/Beta.hxx>
#include <openturns/ComposedDistribution.hxx>
#include <openturns/ConstantBasisFactory.hxx>
#include <openturns/CovarianceMatrix.hxx>
#include <openturns/Exception.hxx>
#include <openturns/Gamma.hxx>
#include <openturns/IdentityMatrix.hxx>
#include <openturns/KrigingAlgorithm.hxx>
#include <openturns/LegendreFactory.hxx>
#include <openturns/Log.hxx>
#include <openturns/LogNormal.hxx>
#include <openturns/LogNormalMuSigma.hxx>
#include <openturns/LogUniform.hxx>
#include <openturns/LowDiscrepancyExperiment.hxx>
#include <openturns/MaternModel.hxx>
#include <openturns/Matrix.hxx>
#include <openturns/Mixture.hxx>
#include <openturns/Normal.hxx>
#include <openturns/NormalCopula.hxx>
#include <openturns/ParametrizedDistribution.hxx>
#include <openturns/RandomGenerator.hxx>
#include <openturns/SobolSequence.hxx>
#include <openturns/TBB.hxx>
#include <openturns/Triangular.hxx>
#include <openturns/TruncatedDistribution.hxx>
#include <openturns/TruncatedNormal.hxx>
#include <openturns/Uniform.hxx>
#include <openturns/UserDefined.hxx>
#include <set>
#include <utility>
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

/// Scatters numbers over all 64-bit words, one to one (the finaliser of SplitMix64: Steele et al. 2014, OOPSLA).
std::uint64_t scattered(std::uint64_t word) {
    word += 0x9E3779B97F4A7C15ULL;
    word = (word ^ (word >> 30)) * 0xBF58476D1CE4E5B9ULL;
    word = (word ^ (word >> 27)) * 0x94D049BB133111EBULL;
    return word ^ (word >> 31);
}

/// Owen's nested uniform scrambling (1995) of a coordinate of a Sobol' point: each bit is turned or not by a random bit
/// that those before it select. Points of a net remain one, each is uniform in (0, 1), and different `random` are
/// independent.
double scrambled(double coordinate, std::uint64_t random) {
    constexpr int k_bits = 32, k_rest = 20;  // no sequence has 2^32 points: all other bits of a coordinate are 0
    const auto bits = static_cast<std::uint64_t>(coordinate * 0x1p32);
    std::uint64_t result = 0;
    for (int bit = 0; bit < k_bits; ++bit) {
        const std::uint64_t node = (std::uint64_t{1} << bit) + (bits >> (k_bits - bit));  // of a binary tree
        result = result << 1 | (((bits >> (k_bits - 1 - bit)) ^ scattered(random + node)) & 1);
    }
    result = result << k_rest | scattered(random + (std::uint64_t{1} << k_bits) + bits) >> (64 - k_rest);
    return (static_cast<double>(result) + 0.5) * 0x1p-52;
}

/// Point i is the next of a Sobol' sequence, from 0 on, that belongs to part i % k_replicates.
Places sobol_points(std::size_t count, std::size_t coordinates, std::int64_t seed) {
    const std::uint64_t random = scattered(static_cast<std::uint64_t>(seed));
    const OT::SobolSequence sequence(coordinates);
    OT::Point point(coordinates);
    Places places(count, std::vector<double>(coordinates));
    for (std::size_t i = 0; i < count; ++i) {
        if (i > 0 && i % k_replicates == 0) point = sequence.generate();
        for (std::size_t k = 0; k < coordinates; ++k)
            places[i][k] = scrambled(point[k], scattered(random + k * k_replicates + i % k_replicates));
    }
    return places;
}

/// Morris' design (1991) as Campolongo, Saltelli & Cariboni (2011) place it: points, then each key alone moved, here by
/// half of its distribution, so that every matrix is as even as the first one.
Places morris_points(std::size_t groups, std::size_t keys, std::int64_t seed) {
    const Places points = sobol_points(groups, keys, seed);
    Places places = points;
    for (std::size_t k = 0; k < keys; ++k)
        for (std::vector<double> place : points) {
            place[k] += place[k] < 0.5 ? 0.5 : -0.5;
            places.push_back(std::move(place));
        }
    return places;
}

/// OpenturnsFunctions::independent_places.
Places independent_places(const StudySpec& study, bool is_replicated) {
    OT::TBB::SetThreadsNumber(1);
    const std::size_t keys = study.vary.size(), count = static_cast<std::size_t>(study.samples);
    if (const std::size_t size = study.group_size(); size > 0) return morris_points(count / size, keys, study.seed);
    if (study.sampling == Sampling::sobol && is_replicated) return sobol_points(count, keys, study.seed);
    const OT::ComposedDistribution cube{OT::Collection<OT::Distribution>(keys, OT::Uniform(0, 1))};
    OT::RandomGenerator::SetSeed(static_cast<OT::UnsignedInteger>(study.seed));
    Places places(count, std::vector<double>(keys));
    if (study.sampling == Sampling::random) {
        for (std::vector<double>& place : places)
            for (double& one : place) one = OT::RandomGenerator::Generate();
        return places;
    }
    OT::LowDiscrepancyExperiment sequence(OT::SobolSequence(), cube, count, true);
    sequence.setRandomize(true);
    const OT::Sample points = sequence.generate();
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t k = 0; k < keys; ++k) places[i][k] = points(i, k);
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
        case Law::pert:  // Clark 1962: a beta distribution with the mean (a + 4 c + b) / 6
            return OT::Beta(1 + 4 * (n[1] - n[0]) / (n[2] - n[0]), 1 + 4 * (n[2] - n[1]) / (n[2] - n[0]), n[0], n[2]);
        case Law::table: {
            OT::Sample values(n.size(), 1);
            for (std::size_t i = 0; i < n.size(); ++i) values(i, 0) = n[i];
            return OT::UserDefined(values, OT::Point(distribution.weights.begin(), distribution.weights.end()));
        }
        case Law::gamma:
            return OT::Gamma(n[0] * n[0] / (n[1] * n[1]), n[0] / (n[1] * n[1]));
        case Law::uniform:
        case Law::choice:
        case Law::gaussian_field:
        case Law::pareto:
        case Law::return_periods:
            break;
    }
    return OT::Uniform(n[0], n[1]);
}

/// Of a power law that is cut off, Law::pareto.
double power_law_at(const std::vector<double>& n, double place) {
    return n[0] * std::pow(1 - place * (1 - std::pow(n[0] / n[2], n[1])), -1 / n[1]);
}

/// Of Law::return_periods.
double volume_at(const std::vector<double>& n, double place) {
    const double period = 1 / (1 - place);
    for (std::size_t i = 2; i < n.size(); i += 2)
        if (period < n[i + 1])
            return n[i - 2] * std::pow(n[i] / n[i - 2], std::log(period / n[i - 1]) / std::log(n[i + 1] / n[i - 1]));
    return n[n.size() - 2];
}

/// OpenturnsFunctions::quantiles.
std::vector<double> quantiles(const Distribution& distribution, const std::vector<double>& places) {
    std::vector<double> values;
    double (*closed)(const std::vector<double>& numbers, double place) = nullptr;
    if (distribution.law == Law::return_periods) closed = volume_at;
    if (distribution.law == Law::pareto) closed = power_law_at;
    for (const double place : places)
        if (closed != nullptr) values.push_back(closed(distribution.numbers, place));
    if (closed != nullptr) return values;
    const OT::Distribution law = law_of(distribution);
    for (const double place : places) values.push_back(law.computeQuantile(place)[0]);
    return values;
}

OT::Sample sample_of(const std::vector<std::vector<double>>& rows) {
    OT::Sample sample(rows.size(), rows.front().size());
    for (std::size_t i = 0; i < rows.size(); ++i)
        for (std::size_t k = 0; k < rows[i].size(); ++k) sample(i, k) = rows[i][k];
    return sample;
}

/// A function of one key.
struct KeyFunction {
    std::size_t degree = 1;
    std::vector<double> values, elsewhere;  ///< by member, by other point
};
/// A product of functions: the key and the number of each.
using Term = std::vector<std::pair<std::size_t, std::size_t>>;

/// Weighted Helmert contrasts of the values of a key without order: each value with all before it. Orthonormal over the
/// members; none if each member has a value of its own, as fields of error have.
std::vector<KeyFunction> contrasts(const std::vector<double>& column, const std::vector<double>& elsewhere) {
    std::map<double, double> counts;
    for (const double value : column) counts[value] += 1;
    std::vector<KeyFunction> functions;
    if (counts.size() == column.size()) return functions;
    const auto members = static_cast<double>(column.size());
    double before = counts.begin()->second;
    for (auto one = std::next(counts.begin()); one != counts.end(); before += one++->second) {
        const double high = std::sqrt(members * before / (one->second * (one->second + before))),
                     low = -high * one->second / before;
        KeyFunction& function = functions.emplace_back();
        const auto of = [&](double value) { return value < one->first ? low : value == one->first ? high : 0; };
        std::transform(column.begin(), column.end(), std::back_inserter(function.values), of);
        std::transform(elsewhere.begin(), elsewhere.end(), std::back_inserter(function.elsewhere), of);
    }
    return functions;
}

constexpr std::size_t k_most_degree = 3;

std::vector<KeyFunction> polynomials(const std::vector<double>& places, const std::vector<double>& elsewhere) {
    const std::size_t different = std::set<double>(places.begin(), places.end()).size();
    std::vector<KeyFunction> functions;
    for (std::size_t degree = 1; degree <= k_most_degree && degree < different; ++degree) {
        const OT::OrthogonalUniVariatePolynomial legendre = OT::LegendreFactory().build(degree);
        KeyFunction& function = functions.emplace_back(KeyFunction{degree, {}, {}});
        for (const double place : places) function.values.push_back(legendre(2 * place - 1));
        for (const double place : elsewhere) function.elsewhere.push_back(legendre(2 * place - 1));
    }
    return functions;
}

/// Adds a term and all its products with functions of keys from `first` on.
void add_terms(const std::vector<std::vector<KeyFunction>>& keys, const Term& term, std::size_t first,
               std::size_t degree, std::size_t order, std::vector<Term>& all) {
    all.push_back(term);
    for (std::size_t k = first; k < keys.size() && order > 0; ++k)
        for (std::size_t f = 0; f < keys[k].size(); ++f) {
            if (keys[k][f].degree > degree) continue;
            Term longer = term;
            longer.emplace_back(k, f);
            add_terms(keys, longer, k + 1, degree - keys[k][f].degree, order - 1, all);
        }
}

class Regression;

/// The polynomial of an output.
struct Fitted {
    Chaos chaos{std::nan(""), {}, {}, {}, {}};
    std::vector<double> coefficients;
    Regression* by = nullptr;
};

/// Least squares with a set of terms for any output.
class Regression {
  public:
    Regression(const std::vector<std::vector<KeyFunction>>& keys, std::vector<Term> terms, std::size_t members)
        : keys_(keys), terms_(std::move(terms)), q_(members, terms_.size()), leverage_(members) {
        OT::Matrix design(members, terms_.size());
        for (std::size_t i = 0; i < members; ++i)
            for (std::size_t j = 0; j < terms_.size(); ++j) {
                design(i, j) = 1;
                for (const auto& [key, function] : terms_[j]) design(i, j) *= keys[key][function].values[i];
            }
        q_ = design.computeQR(r_, false);
        for (std::size_t i = 0; i < members; ++i)
            for (std::size_t j = 0; j < terms_.size(); ++j) leverage_[i] += q_(i, j) * q_(i, j);
    }
    /// Whether every term adds something, and no member decides a term alone.
    [[nodiscard]] bool is_sound() const {
        constexpr double k_least = 1e-6;  // of columns whose lengths are about 1
        for (std::size_t j = 0; j < terms_.size(); ++j)
            if (std::abs(r_(j, j)) < k_least * std::sqrt(static_cast<double>(leverage_.size()))) return false;
        return std::all_of(leverage_.begin(), leverage_.end(), [](double one) { return one < 1 - k_least; });
    }
    [[nodiscard]] Fitted of(const std::vector<double>& output, bool tells_left_out) {
        const std::size_t keys = keys_.size();
        const std::size_t members = output.size(), terms = terms_.size();
        const double mean = std::accumulate(output.begin(), output.end(), 0.0) / static_cast<double>(members);
        std::vector<double> rest = output, coefficients(terms);
        for (std::size_t j = 0; j < terms; ++j) {
            for (std::size_t i = 0; i < members; ++i) coefficients[j] += q_(i, j) * output[i];
            for (std::size_t i = 0; i < members; ++i) rest[i] -= q_(i, j) * coefficients[j];
        }
        for (std::size_t j = terms; j-- > 0;) {  // R c = Q^T y
            for (std::size_t later = j + 1; later < terms; ++later)
                coefficients[j] -= r_(j, later) * coefficients[later];
            coefficients[j] /= r_(j, j);
        }
        double all = 0, left_out = 0, unexplained = 0;
        for (std::size_t i = 0; i < members; ++i) {
            all += (output[i] - mean) * (output[i] - mean);
            unexplained += rest[i] * rest[i];
            left_out += std::pow(rest[i] / (1 - leverage_[i]), 2);
        }
        Chaos chaos{1 - left_out / all, std::vector<double>(keys), std::vector<double>(keys), {}, {}};
        double variance = unexplained / static_cast<double>(members - terms);
        for (std::size_t j = 0; j < terms; ++j) {
            const double square = terms_[j].empty() ? 0 : coefficients[j] * coefficients[j];
            variance += square;
            for (const auto& [key, function] : terms_[j]) {
                chaos.total[key] += square;
                if (terms_[j].size() == 1) chaos.first_order[key] += square;
            }
        }
        // The decomposition's last digits depend on where its memory lies.
        const auto steady = [](double value, double unit = 1) { return std::round(value / unit * 1e9) * 1e-9 * unit; };
        chaos.q2 = steady(chaos.q2);
        for (auto* const of_keys : {&chaos.first_order, &chaos.total})
            for (double& one : *of_keys) one = steady(one / variance);
        const double unit = all > 0 ? std::sqrt(all / static_cast<double>(members)) : 1;
        for (double& one : coefficients) one = steady(one, unit);
        for (std::size_t i = 0; i < members && tells_left_out; ++i)
            chaos.left_out.push_back(output[i] - steady(rest[i] / (1 - leverage_[i]), unit));
        return {std::move(chaos), std::move(coefficients), this};
    }

    /// What coefficients of the terms predict at other points, of which there are `count`.
    [[nodiscard]] std::vector<double> elsewhere(const std::vector<double>& coefficients, std::size_t count) {
        if (products_.empty())
            for (const Term& term : terms_) {
                std::vector<double>& product = products_.emplace_back(count, 1.0);
                for (const auto& [key, function] : term)
                    for (std::size_t i = 0; i < count; ++i) product[i] *= keys_[key][function].elsewhere[i];
            }
        std::vector<double> sums(count);
        for (std::size_t j = 0; j < terms_.size(); ++j)
            for (std::size_t i = 0; i < count; ++i) sums[i] += coefficients[j] * products_[j][i];
        return sums;
    }

  private:
    const std::vector<std::vector<KeyFunction>>& keys_;
    std::vector<Term> terms_;
    std::vector<std::vector<double>> products_;  ///< of each term at the other points
    OT::Matrix q_, r_;
    std::vector<double> leverage_;  ///< by member: how much its own output decides what is said of it
};

/// OpenturnsFunctions::chaos.
std::vector<Chaos> chaos(const DesignPoints& points, const std::vector<std::vector<double>>& outputs,
                         const DesignPoints& elsewhere) {
    OT::TBB::SetThreadsNumber(1);
    const std::size_t keys = points.nominal.size(), members = points.numbers.size(), others = elsewhere.numbers.size();
    std::vector<std::vector<KeyFunction>> functions;
    for (std::size_t k = 0; k < keys; ++k)
        functions.push_back(points.nominal[k]
                                ? contrasts(column_of(points.numbers, k), column_of(elsewhere.numbers, k))
                                : polynomials(column_of(points.places, k), column_of(elsewhere.places, k)));
    std::list<Regression> regressions;
    std::vector<Fitted> best(outputs.size());
    constexpr std::pair<std::size_t, std::size_t> k_sets[] = {{1, 1}, {2, 1}, {3, 1}, {2, 2}, {3, 2}, {3, 3}};
    for (const auto& [degree, order] : k_sets) {
        std::vector<Term> terms;
        add_terms(functions, {}, 0, degree, order, terms);
        if (4 * terms.size() > 3 * members) continue;
        Regression& regression = regressions.emplace_back(functions, std::move(terms), members);
        for (std::size_t i = 0; i < outputs.size() && regression.is_sound(); ++i) {
            Fitted one = regression.of(outputs[i], others > 0);
            if (std::isfinite(one.chaos.q2) && !(best[i].chaos.q2 >= one.chaos.q2)) best[i] = std::move(one);
        }
    }
    std::vector<Chaos> all;
    for (Fitted& one : best) {
        if (one.by != nullptr && others > 0) one.chaos.elsewhere = one.by->elsewhere(one.coefficients, others);
        all.push_back(std::move(one.chaos));
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

/// The distance, from the mean and variance of its square.
Prediction root_of(double mean, double variance) {
    const double square = std::max({mean, std::sqrt(variance) / 2, 1e-12});
    return {std::sqrt(square), variance / (4 * square)};
}

/// 1 - squares of the errors of each distance predicted from all others (Dubrule 1983, Mathematical Geology 15, 687)
/// over their variance.
double q2_of(OT::CovarianceMatrix covariance, const std::vector<double>& squares) {
    const std::size_t n = squares.size();
    const OT::Matrix inverse = covariance.solveLinearSystem(OT::IdentityMatrix(n));
    const OT::Point ones = inverse * OT::Point(n, 1.0);
    const double sum = std::accumulate(ones.begin(), ones.end(), 0.0),
                 trend = std::inner_product(squares.begin(), squares.end(), ones.begin(), 0.0) / sum;
    OT::Point rest(n);
    double mean = 0, errors = 0, all = 0;
    for (std::size_t i = 0; i < n; ++i) {
        rest[i] = squares[i] - trend;
        mean += std::sqrt(squares[i]) / static_cast<double>(n);
    }
    const OT::Point weights = inverse * rest;
    for (std::size_t i = 0; i < n; ++i) {
        const double distance = std::sqrt(squares[i]),
                     predicted = squares[i] - weights[i] / (inverse(i, i) - ones[i] * ones[i] / sum);
        errors += std::pow(std::sqrt(std::max(0.0, predicted)) - distance, 2);
        all += std::pow(distance - mean, 2);
    }
    return 1 - errors / all;
}

/// OpenturnsFunctions::emulator.
Emulator emulator(const Places& places, const std::vector<double>& distances) {
    OT::TBB::SetThreadsNumber(1);
    OT::Log::Show(OT::Log::NONE);
    const std::size_t count = distances.size();
    std::vector<double> squares;
    double mean = 0, variance = 0;
    for (const double one : distances) mean += squares.emplace_back(one * one) / static_cast<double>(count);
    for (const double one : squares) variance += (one - mean) * (one - mean) / static_cast<double>(count);
    if (count < 4 || places.front().empty() || !(variance > 0)) {
        const Prediction same = root_of(mean, variance);
        return {std::nan(""), 0, [same](const Places& at) { return std::vector<Prediction>(at.size(), same); }};
    }
    const double unit = std::sqrt(variance);
    const std::size_t keys = places.front().size();
    const OT::Sample inputs = sample_of(places);
    OT::Sample outputs(count, 1);
    for (std::size_t i = 0; i < count; ++i) outputs(i, 0) = squares[i] /= unit;
    OT::KrigingResult best;
    OT::Point error(count), best_error;
    double most_likely = -std::numeric_limits<double>::infinity(), noise = 0;
    // Variances; that of y^2 is 4 y^2 times it. The greatest are made by fields of error.
    for (const double of_distance : {1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1, 1.0, 10.0}) {
        for (std::size_t i = 0; i < count; ++i) error[i] = 4 * of_distance * std::max(squares[i], 1e-6);
        OT::MaternModel model(OT::Point(keys, 0.5), OT::Point(1, 1.0), 2.5);
        model.setNuggetFactor(1e-8);
        OT::KrigingAlgorithm algorithm(inputs, outputs, model, OT::ConstantBasisFactory(keys).build());
        algorithm.setNoise(error);
        algorithm.setOptimizationBounds(OT::Interval(OT::Point(keys, 0.05), OT::Point(keys, 10)));
        algorithm.run();
        const OT::KrigingResult result = algorithm.getResult();
        const double likelihood =
            algorithm.getReducedLogLikelihoodFunction()(result.getCovarianceModel().getScale())[0];
        if (!(likelihood > most_likely)) continue;
        most_likely = likelihood;
        best = result;
        best_error = error;
        noise = unit * of_distance;
    }
    OT::CovarianceMatrix covariance = best.getCovarianceModel().discretize(inputs);
    for (std::size_t i = 0; i < count; ++i) covariance(i, i) += best_error[i];
    return {q2_of(covariance, squares), noise, [best, unit](const Places& at) {
                const OT::Sample where = sample_of(at), means = best.getConditionalMean(where),
                                 variances = best.getConditionalMarginalVariance(where);
                std::vector<Prediction> all;
                for (std::size_t i = 0; i < at.size(); ++i)
                    all.push_back(root_of(unit * means(i, 0), unit * unit * std::max(0.0, variances(i, 0))));
                return all;
            }};
}

}  // namespace
}  // namespace frana::app::study

FRANA_MODULE(frana::app::study::OpenturnsFunctions, {.quantiles = frana::app::study::quantiles,
                                                     .independent_places = frana::app::study::independent_places,
                                                     .correlate = frana::app::study::correlate,
                                                     .refined = frana::app::study::refined,
                                                     .chaos = frana::app::study::chaos,
                                                     .emulator = frana::app::study::emulator})
