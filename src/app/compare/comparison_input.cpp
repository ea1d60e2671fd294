// SPDX-License-Identifier: Apache-2.0
#include "app/compare/comparison_input.h"

#include "app/input/scene_language.h"
#include "app/store/provenance.h"
#include "params/keys/scene_parameters.h"

namespace frana::app {

ComparisonInput surveyed(const Prepared& prepared) {
    ComparisonInput input;
    input.survey = prepared.extra.survey;
    if (prepared.scar) {
        input.survey.scar = parts_of(prepared.scar->features);
        input.survey.scar_label = prepared.spec.observed.perimeter.value();
    }
    if (input.survey.empty()) return input;
    input.threshold = observed_threshold(prepared.spec);
    input.depth_label = "max_depth.tif";
    input.metadata = provenance(prepared);
    input.words = words_of(prepared.spec);
    return input;
}

}  // namespace frana::app
