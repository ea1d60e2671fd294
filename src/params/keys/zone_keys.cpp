// SPDX-License-Identifier: Apache-2.0
#include "params/keys/zone_keys.h"

namespace frana {
namespace {

using declare::Range;
using ColumnNames = std::vector<std::string>;
using Zones = ZonesSpec;

ZoneKey zone(const std::string& key, std::optional<SourceSpec> ZonesSpec::*source, const std::string& what,
             const std::string& unit, Range range, const ColumnNames& columns) {
    return {"zones." + key, source, what, unit, range, columns};
}

}  // namespace

const std::vector<ZoneKey>& zone_keys() {
    static const std::vector<ZoneKey> keys{
        zone("friction-angle", &Zones::friction_angle, "friction", "degrees", Range{0, 60},
             ColumnNames{"friction_angle", "phi"}),
        zone("friction-coefficient", &Zones::friction_coefficient, "friction", "", Range{0, 2},
             ColumnNames{"friction_coefficient", "mu"}),
        zone("turbulence", &Zones::turbulence, "turbulence", "m/s2", Range{0, 1e9, true},
             ColumnNames{"turbulence", "xi"}),
        zone("cohesion", &Zones::cohesion, "cohesion", "Pa", Range{0, 1e6}, ColumnNames{"cohesion"}),
        zone("erodible-depth", &Zones::erodible_depth, "erodible depth", "m", Range{0, 1000},
             ColumnNames{"erodible_depth"}),
        zone("detrainment-coefficient", &Zones::detrainment_coefficient, "detrainment", "Pa", Range{0, 1e4},
             ColumnNames{"detrainment_coefficient", "detrainment"})};
    return keys;
}

}  // namespace frana
