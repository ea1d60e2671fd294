// SPDX-License-Identifier: Apache-2.0
#include "params/keys/parameter.h"

namespace frana {

const std::vector<FormerName>& former_names() {
    static const std::vector<FormerName> names{
        {"structured.confined-share", "structured.confined-fraction"},
        {"structured.initial-structured-share", "structured.initial-structured-fraction"},
        {"structured.softening", "structured.modulus-reduction"},
        {"structured.pore-pressure-share", "structured.basal-pore-pressure-fraction"},
        {"structured.pic-share", "structured.pic-fraction"},
        {"structured.velocity-shape", "structured.velocity-profile-factor"},
        {"structured.solids-shape", "structured.solids-profile-factor"},
        {"entrainment.critical-shear", "entrainment.critical-shear-stress"},
        {"entrainment.deposition-shear", "entrainment.deposition-shear-stress"},
        {"entrainment.potential-depth", "entrainment.erosion-depth-per-stress"},
        {"time.stop-energy-share", "time.stop-energy-fraction"},
        {"time.stop-moving-share", "time.stop-moving-fraction"},
        {"scar.perimeter", "observed.perimeter", true},
        {"scar.perimeter-layer", "observed.perimeter-layer", true},
        {"scar.perimeter-filter", "observed.perimeter-filter", true},
        {"scar.perimeter-crs", "observed.perimeter-crs", true},
        {"scar.front", "observed.front", true},
        {"scar.deposit", "observed.deposit", true},
        {"scar.threshold", "observed.threshold", true},
    };
    return names;
}

const FormerName* former_name(const std::string& name) {
    for (const FormerName& key : former_names())
        if (name == key.former) return &key;
    return nullptr;
}

std::string present_name(const std::string& name) {
    const FormerName* const former = former_name(name);
    return former != nullptr ? former->now : name;
}

}  // namespace frana
