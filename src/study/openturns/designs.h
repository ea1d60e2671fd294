// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "study/openturns/functions.h"

namespace frana::study {

/// OpenturnsFunctions::independent_places.
Places independent_places(const StudySpec& study);
/// OpenturnsFunctions::correlate.
bool correlate(const StudySpec& study, Places& places);

}  // namespace frana::study
