// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "analysis/friction_table.h"
#include "core/error.h"
#include "params/keys/scene_spec.h"

namespace frana {

/// Returns the table of a file; share/doc/input.md describes its keys. Every problem is collected, with `label` for the
/// file; the table is then incomplete. Throws Error(input) if the file cannot be read as INI.
FrictionTable read_friction_table(const std::string& path, const std::string& label, Problems& problems);

/// Returns the table that a scene names; none without one, and with a problem. `where` is where it is named.
std::optional<FrictionTable> resolved_friction_table(const FrictionTableSpec& spec, const std::string& share,
                                                     const Place& where, Problems& problems);

}  // namespace frana
