// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "analysis/hazard.h"

namespace frana::study {

/// Points of the unit cube, by member and key: cumulative probabilities of the keys' distributions.
using Places = std::vector<std::vector<double>>;

enum class Law { uniform, log_uniform, normal, log_normal, triangular, choice, gaussian_field };

/// The distribution of one key.
struct Distribution {
    Law law = Law::uniform;
    /// In the key's unit: limits (uniform, log-uniform), mean and standard deviation (normal, log-normal, of the value
    /// itself) with two limits where it is cut off, least, likeliest and greatest value (triangular), standard
    /// deviation and range [m] (gaussian-field).
    std::vector<double> numbers;
    std::vector<std::string> values;  ///< choice
    std::vector<double> weights;      ///< choice: as many, their sum is 1
    std::string text;                 ///< as written

    /// Whether its values have no order.
    [[nodiscard]] bool is_nominal() const noexcept { return law == Law::choice || law == Law::gaussian_field; }
};

struct Variation {
    std::string key;  ///< of the scene: "material.turbulence"
    Distribution distribution;
};

/// Rank correlation (Spearman's rho) of two varied keys, by a normal copula.
struct Correlation {
    std::string first, second;
    double rho = 0;

    [[nodiscard]] bool is_of_the_keys_of(const Correlation& other) const {
        return (first == other.first && second == other.second) || (first == other.second && second == other.first);
    }
};

enum class Sampling {
    sobol,
    latin_hypercube,
    random,
    grid,
    saltelli,
    table,
    polygons  ///< no sampling: each polygon of the release perimeter is a member of its own
};
enum class Keep { none, failed, all };

/// A region: a study with a polygon for each member, whose attributes say what each is.
struct RegionSpec {
    /// Columns of the release perimeter: what a slope is called, what it belongs to, which of several events it is,
    /// and the return period of that [years].
    std::optional<std::string> name, group, scenario, return_period;
    /// A key of the scene whose value is in a column.
    struct Column {
        std::string key, column;
    };
    std::vector<Column> columns;
    std::optional<double> window;  ///< terrain round a polygon [m]; none: what the flow can reach
    DegreeMatrix degrees;
};

/// A study as specified in its file; the scene is not read yet.
struct StudySpec {
    std::string file;   ///< the study file, absolute
    std::string scene;  ///< absolute
    std::int64_t samples = 200;
    Sampling sampling = Sampling::sobol;
    std::string table;  ///< absolute; sampling by a table alone
    std::int64_t seed = 1;
    std::optional<double> until;  ///< largest standard error of a probability at which no more members are run
    std::optional<std::size_t>
        levels;  ///< cell sizes of a multilevel study; none: members are on the scene's own cells
    Keep keep = Keep::none;
    std::vector<std::string> set;  ///< "key=value" for all members, as after `--set`; paths absolute
    std::vector<Variation> vary;   ///< in the order of the file
    std::vector<Correlation> correlate;
    std::optional<RegionSpec> region;  ///< only with polygons

    [[nodiscard]] bool per_polygon() const noexcept { return sampling == Sampling::polygons; }
};

}  // namespace frana::study
