// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "params/keys/declare.h"
#include "physics/law.h"

namespace frana {

/// A key of [zones] that gives a quantity by place. The one list, from which follow: declaration, columns of the zones'
/// vector layer, reading, and the error for keys that no law reads. laws.cpp lists the laws that read it;
/// k_zone_rasters of simulation/scene.h lists the rasters that receive it.
struct ZoneKey {
    std::string name;  ///< "zones.friction-angle": the key without its section equals that of the quantity elsewhere
    std::optional<SourceSpec> ZonesSpec::*source;
    std::string what;  ///< the quantity, "friction": two keys may give the same
    std::string unit;
    declare::Range range;              ///< that of the same key elsewhere
    std::vector<std::string> columns;  ///< names of columns used for it if no key names one

    /// An angle, stored as its tangent.
    [[nodiscard]] bool degrees() const { return unit == "degrees"; }
    [[nodiscard]] double stored(double value) const { return degrees() ? tangent_of(value) : value; }
};
const std::vector<ZoneKey>& zone_keys();

}  // namespace frana
