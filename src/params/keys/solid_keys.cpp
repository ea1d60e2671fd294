// SPDX-License-Identifier: Apache-2.0
#include "params/keys/solid_keys.h"

#include <algorithm>

namespace frana {

const std::vector<SolidKey>& solid_keys() {
    using declare::Range;
    using Spec = StructuredSpec;
    using Values = SolidValues;
    static const std::vector<SolidKey> keys{
        {"structured.solid-fraction", &Spec::solid_fraction, &Values::solid_fraction, "", Range{0, 1, true},
         "Volume fraction of solids in the release; the rest is fluid.", ""},
        {"structured.confined-fraction", &Spec::confined_fraction, &Values::confined_fraction, "", Range{0, 1},
         "Fraction of that fluid that is confined by the structure; the rest is free from the start.", ""},
        {"structured.grain-density", &Spec::grain_density, &Values::grain_density, "kg/m3", Range{1000, 5000},
         "Density of the grains.", ""},
        {"structured.grain-diameter", &Spec::grain_diameter, &Values::grain_diameter, "m", Range{1e-6, 1},
         "Diameter of the grains, for the drag.", ""},
        {"structured.cohesion", &Spec::cohesion, &Values::cohesion, "Pa", Range{0, 1e12},
         "Cohesion of the intact material; 0: loose from the start.", "required with solids"},
        {"structured.internal-friction-angle", &Spec::internal_friction_angle, &Values::friction, "degrees",
         Range{0, 60, true}, "Internal friction angle.", "required with solids"},
        {"structured.bed-friction-angle", &Spec::bed_friction_angle, &Values::bed_friction, "degrees", Range{0, 60},
         "Friction angle at the bed.", "the internal friction angle", "structured.internal-friction-angle"}};
    return keys;
}

const SolidKey& SolidKey::in_use(const StructuredSpec& spec) const {
    if (instead.empty() || spec.*source) return *this;
    return *std::find_if(solid_keys().begin(), solid_keys().end(),
                         [this](const SolidKey& other) { return other.name == instead; });
}

}  // namespace frana
