// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "params/keys/parameter.h"
#include "study/study_spec.h"

namespace frana::study {

/// Returns why a key of the scene cannot vary in a study; none: it can. Members must have the same cells and the same
/// outputs, otherwise their maps could not be combined.
std::optional<ValueProblem> refusal_to_vary(const Parameter& key);

/// Returns why a key cannot have a distribution: no number, a support beyond its range, a value it does not accept.
std::optional<ValueProblem> refusal_of(const Parameter& key, const Distribution& distribution);

}  // namespace frana::study
