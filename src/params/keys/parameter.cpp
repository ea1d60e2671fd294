// SPDX-License-Identifier: Apache-2.0
#include "params/keys/parameter.h"

namespace frana {

const std::vector<FormerName>& former_names() {
    static const std::vector<FormerName> names{
        {"scar.perimeter", "observed.perimeter"}, {"scar.perimeter-crs", "observed.perimeter-crs"},
        {"scar.front", "observed.front"},         {"scar.deposit", "observed.deposit"},
        {"scar.threshold", "observed.threshold"}, {"scar.perimeter-filter", "observed.perimeter-filter"},
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
