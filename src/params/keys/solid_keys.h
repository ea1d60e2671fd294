// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "params/keys/declare.h"

namespace frana {

/// A key of [structured] for a property of the solids, which a number, a column or a raster may give. The one list: its
/// declaration, the uniform value and the values by place of simulation/scene.h follow from it.
struct SolidKey {
    std::string name;
    std::optional<SourceSpec> StructuredSpec::*source;
    double SolidValues::*value;
    std::string unit;
    declare::Range range;
    std::string meaning;
    std::string absent;        ///< what holds where it is not given, in words
    std::string instead = {};  ///< key whose value it then is

    /// An angle, of which the tangent is kept.
    [[nodiscard]] bool degrees() const { return unit == "degrees"; }
    /// The key that gives the value: this one, or the one instead.
    [[nodiscard]] const SolidKey& giving(const StructuredSpec& spec) const;
};
const std::vector<SolidKey>& solid_keys();

}  // namespace frana
