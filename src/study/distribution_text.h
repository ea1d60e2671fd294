// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <variant>

#include "params/keys/parameter.h"
#include "study/study_spec.h"

namespace frana::study {

/// The forms that a distribution may have, for messages.
inline constexpr const char* k_distributions =
    "uniform(a, b), log-uniform(a, b), normal(mean, sd), normal(mean, sd, low, high), log-normal(mean, sd), "
    "log-normal(mean, sd, low, high), triangular(a, likeliest, b), choice(value: weight, ...), gaussian-field(sd, "
    "range)";

/// Reads "uniform(0.1, 0.3)", "choice(a.shp: 0.7, \"b, c.shp\": 0.3)": a value with a comma is in quotes; without
/// weights all values are alike.
std::variant<Distribution, ValueProblem> distribution_from_text(const std::string& text);

/// Least and greatest value; infinite where there is none. Not for choices and fields.
struct Support {
    double low = 0, high = 0;
};
Support support_of(const Distribution& distribution);

}  // namespace frana::study
