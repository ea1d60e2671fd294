// SPDX-License-Identifier: Apache-2.0
#include "study/sampling.h"

#include <algorithm>
#include <cmath>
#include <openturns/ComposedDistribution.hxx>
#include <openturns/Exception.hxx>
#include <openturns/LHSExperiment.hxx>
#include <openturns/LogNormal.hxx>
#include <openturns/LogNormalMuSigma.hxx>
#include <openturns/LogUniform.hxx>
#include <openturns/LowDiscrepancyExperiment.hxx>
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
#include <openturns/Uniform.hxx>

#include "core/shortest_text.h"
#include "params/grammar/value_text.h"
#include "params/keys/scene_parameters.h"

namespace frana::study {
namespace {

constexpr double k_seeds = 9007199254740992.0;  // 2^53: every place in [0, 1) is a seed of its own

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

/// From places in (0, 1) to values of one key.
class Marginal {
  public:
    explicit Marginal(const Distribution& distribution) : distribution_(distribution) {
        if (!distribution.is_nominal()) law_ = law_of(distribution);
    }
    /// Returns the text and the number of a value.
    [[nodiscard]] std::pair<std::string, double> at(double place) const {
        if (distribution_.law == Law::choice) {
            double sum = 0;
            std::size_t index = 0;
            for (; index + 1 < distribution_.values.size(); ++index)
                if (place < (sum += distribution_.weights[index])) break;
            return {distribution_.values[index], static_cast<double>(index)};
        }
        if (distribution_.law == Law::gaussian_field) {
            const auto seed = static_cast<std::int64_t>(place * k_seeds);
            return {shortest_text(distribution_.numbers[0]) + ", " + shortest_text(distribution_.numbers[1]) + ", " +
                        std::to_string(seed),
                    place};
        }
        const double value = law_.computeQuantile(place)[0];
        return {shortest_text(value), value};
    }

  private:
    const Distribution& distribution_;
    OT::Distribution law_;
};

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

/// Points of the unit cube, independent in each coordinate.
OT::Sample independent_places(const StudySpec& study) {
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
            break;
    }
    OT::LowDiscrepancyExperiment sequence(OT::SobolSequence(), cube, count, true);
    sequence.setRandomize(true);
    return sequence.generate();
}

/// Gives the places the rank correlations of the study; each coordinate stays even in (0, 1). None: no distribution has
/// these correlations.
std::optional<OT::Sample> correlated_places(const StudySpec& study, OT::Sample places) {
    OT::TriangularMatrix factor;
    try {
        factor =
            OT::CorrelationMatrix(OT::NormalCopula::GetCorrelationFromSpearmanCorrelation(rank_correlations(study)))
                .computeCholesky();
    } catch (const OT::Exception&) {  // not positive definite
        return std::nullopt;
    }
    const OT::Normal normal(0, 1);
    for (OT::UnsignedInteger i = 0; i < places.getSize(); ++i) {
        OT::Point z(places.getDimension());
        for (OT::UnsignedInteger k = 0; k < z.getDimension(); ++k) z[k] = normal.computeQuantile(places(i, k))[0];
        const OT::Point y = factor * z;
        for (OT::UnsignedInteger k = 0; k < z.getDimension(); ++k) places(i, k) = normal.computeCDF(y[k]);
    }
    return places;
}

SampleTable empty_table(const StudySpec& study) {
    SampleTable table;
    for (const Variation& one : study.vary) {
        table.keys.push_back(one.key);
        table.nominal.push_back(one.distribution.is_nominal());
    }
    return table;
}

void add_member(const std::vector<std::pair<std::string, double>>& values, double weight, SampleTable& table) {
    auto& texts = table.values.emplace_back();
    auto& numbers = table.numbers.emplace_back();
    for (const auto& [text, number] : values) {
        texts.push_back(text);
        numbers.push_back(number);
    }
    table.weights.push_back(weight);
}

/// All combinations of as many levels of each key as the samples allow, in the middle of equal parts of its
/// distribution; of a choice all values, with their weights.
SampleTable full_factorial(const StudySpec& study) {
    SampleTable table = empty_table(study);
    double choices = 1;
    std::size_t numbers = 0;
    for (const Variation& one : study.vary) {
        const bool is_choice = one.distribution.law == Law::choice;
        choices *= is_choice ? static_cast<double>(one.distribution.values.size()) : 1;
        numbers += is_choice ? 0 : 1;
    }
    const double most = static_cast<double>(study.samples) / choices;
    const auto levels = static_cast<std::size_t>(
        numbers == 0 ? 1 : std::max(1.0, std::floor(std::pow(most, 1.0 / static_cast<double>(numbers)) + 1e-9)));
    std::vector<std::size_t> at(study.vary.size());
    for (bool more = true; more;) {
        std::vector<std::pair<std::string, double>> values;
        double weight = 1;
        for (std::size_t k = 0; k < at.size(); ++k) {
            const Distribution& d = study.vary[k].distribution;
            if (d.law == Law::choice) {
                values.emplace_back(d.values[at[k]], static_cast<double>(at[k]));
                weight *= d.weights[at[k]];
            } else {
                values.push_back(Marginal(d).at((static_cast<double>(at[k]) + 0.5) / static_cast<double>(levels)));
            }
        }
        add_member(values, weight, table);
        more = false;
        for (std::size_t k = at.size(); k-- > 0 && !more;) {
            const Distribution& d = study.vary[k].distribution;
            more = ++at[k] < (d.law == Law::choice ? d.values.size() : levels);
            if (!more) at[k] = 0;
        }
    }
    return table;
}

/// Of an unbounded distribution a value may lie outside the key's range.
void check_values(const StudySpec& study, const SampleTable& table, const std::string& label, Problems& problems) {
    const std::vector<Parameter> parameters = scene_parameters();
    for (std::size_t k = 0; k < table.keys.size(); ++k) {
        const Parameter* const key = find_parameter(parameters, table.keys[k]);
        SceneSpec scene;
        for (std::size_t member = 0; member < table.size(); ++member) {
            if (!key->read(scene, table.values[member][k])) continue;
            const std::string& law = study.vary[k].distribution.text;
            problems.add(
                {"has no end, and member " + std::to_string(member) + " would have a value of " +
                     table.values[member][k],
                 label + ": vary." + table.keys[k], law, key->limits,
                 "Cut the distribution off with two more numbers: " + law.substr(0, law.size() - 1) + ", low, high)"});
            break;
        }
    }
}

}  // namespace

std::vector<std::string> SampleTable::overrides(std::size_t member) const {
    std::vector<std::string> list;
    for (std::size_t k = 0; k < keys.size(); ++k) list.push_back(keys[k] + "=" + values[member][k]);
    return list;
}

SampleTable draw_samples(const StudySpec& study, const std::string& label, Problems& problems) {
    OT::TBB::SetThreadsNumber(1);
    if (study.sampling == Sampling::grid) return full_factorial(study);
    OT::Sample places = independent_places(study);
    if (!study.correlate.empty()) {
        auto correlated = correlated_places(study, places);
        if (!correlated) {
            problems.add({"no distribution has all these correlations at once", label + ": correlate", "", "",
                          "Bring them nearer to 0"});
            return empty_table(study);
        }
        places = std::move(*correlated);
    }
    SampleTable table = empty_table(study);
    std::vector<Marginal> marginals;
    for (const Variation& one : study.vary) marginals.emplace_back(one.distribution);
    for (OT::UnsignedInteger i = 0; i < places.getSize(); ++i) {
        std::vector<std::pair<std::string, double>> values;
        for (std::size_t k = 0; k < marginals.size(); ++k) values.push_back(marginals[k].at(places(i, k)));
        add_member(values, 1, table);
    }
    if (study.sampling == Sampling::saltelli) table.groups = table.size() / (study.vary.size() + 2);
    check_values(study, table, label, problems);
    return table;
}

SampleTable samples_of_table(const std::vector<std::string>& columns, const std::vector<std::vector<std::string>>& rows,
                             const std::string& where, Problems& problems) {
    SampleTable table;
    const std::vector<Parameter> parameters = scene_parameters();
    std::vector<std::size_t> of_key;
    std::optional<std::size_t> weights;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        if (columns[i] == "weight") weights = i;
        if (find_parameter(parameters, columns[i]) == nullptr) continue;
        table.keys.push_back(columns[i]);
        of_key.push_back(i);
    }
    if (of_key.empty() || rows.empty()) {
        problems.add({of_key.empty() ? "has no column with the name of a key" : "has no rows", where, "", "",
                      "Write a column for each key that varies, and a row for each member"});
        return table;
    }
    // Numbers where all of a column are; else the index of the first row with the same text.
    for (const std::size_t column : of_key)
        table.nominal.push_back(!std::all_of(
            rows.begin(), rows.end(), [&](const auto& row) { return number_from_text(row[column]).has_value(); }));
    for (std::size_t row = 0; row < rows.size(); ++row) {
        std::vector<std::pair<std::string, double>> values;
        for (std::size_t k = 0; k < of_key.size(); ++k) {
            const std::string& text = rows[row][of_key[k]];
            std::size_t first = 0;
            if (table.nominal[k])
                while (rows[first][of_key[k]] != text) ++first;
            values.emplace_back(text, table.nominal[k] ? static_cast<double>(first) : *number_from_text(text));
        }
        const auto weight = weights ? number_from_text(rows[row][*weights]) : 1;
        if (!weight || !(*weight >= 0))
            problems.add({"is not a weight", where + ": weight", rows[row][*weights], "0 or more",
                          "Correct row " + std::to_string(row + 1)});
        else if (*weight > 0)
            add_member(values, *weight, table);
    }
    return table;
}

std::vector<std::string> central_values(const StudySpec& study) {
    std::vector<std::string> list;
    for (const Variation& one : study.vary) {
        const Distribution& d = one.distribution;
        if (d.law == Law::gaussian_field) continue;
        if (d.law == Law::choice) {
            const auto likeliest = std::max_element(d.weights.begin(), d.weights.end()) - d.weights.begin();
            list.push_back(one.key + "=" + d.values[static_cast<std::size_t>(likeliest)]);
        } else {
            list.push_back(one.key + "=" + Marginal(d).at(0.5).first);
        }
    }
    return list;
}

}  // namespace frana::study
