// SPDX-License-Identifier: Apache-2.0
#include "core/module.h"

#include "study/openturns/designs.h"
#include "study/openturns/distributions.h"
#include "study/openturns/functions.h"
#include "study/openturns/indices.h"
#include "study/openturns/refined.h"

FRANA_MODULE(frana::study::OpenturnsFunctions, {.quantiles = frana::study::quantiles,
                                                .independent_places = frana::study::independent_places,
                                                .correlate = frana::study::correlate,
                                                .refined = frana::study::refined,
                                                .indices = frana::study::indices})
