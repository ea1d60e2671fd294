// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "params/keys/declare.h"

namespace frana {

/// A key of [zones] that gives a quantity by place. The one list: declaration, columns of the zones' layer, reading,
/// and what is refused because no law reads it follow from it. Which laws read it, laws.cpp says; where its raster
/// goes, k_zone_rasters of simulation/scene.h.
struct ZoneKey {
    std::string name;  ///< "zones.friction-angle": the key without its section is that of the quantity elsewhere
    std::optional<SourceSpec> ZonesSpec::*source;
    std::string what;  ///< it gives, "friction": two keys may give the same
    std::string unit;
    declare::Range range;              ///< that of the quantity's key elsewhere
    std::vector<std::string> columns;  ///< names of columns that are taken for it where no key names one
    std::string meaning;

    /// An angle, of which the tangent is kept.
    [[nodiscard]] bool degrees() const { return unit == "degrees"; }
};
const std::vector<ZoneKey>& zone_keys();

}  // namespace frana
