// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "params/keys/declare.h"
#include "params/keys/parameter.h"

namespace frana {

/// Adds the keys of [structured].
void add_structured(std::vector<Parameter>& list);

/// A key of [structured] for a property of the solids, given by a number, a column or a raster. The one list, from
/// which follow: its declaration, the uniform value and the values by place of simulation/scene.h.
struct SolidKey {
    std::string name;
    std::optional<SourceSpec> StructuredSpec::*source;
    double SolidValues::*value;
    std::string unit;
    declare::Range range;
    std::string meaning;
    std::string absent;        ///< default, in words, if the key is not given
    std::string instead = {};  ///< key whose value is then used

    /// An angle, stored as its tangent.
    [[nodiscard]] bool degrees() const { return unit == "degrees"; }
    /// Returns the key that defines the value: this one, or `instead`.
    [[nodiscard]] const SolidKey& in_use(const StructuredSpec& spec) const;
};
const std::vector<SolidKey>& solid_keys();

/// Adds the keys of [material].
void add_material(std::vector<Parameter>& list);
/// Adds the keys of [entrainment].
void add_entrainment(std::vector<Parameter>& list);

}  // namespace frana
