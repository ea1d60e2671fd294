// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/hazard.h"
#include "core/error.h"
#include "params/keys/scene_spec.h"

namespace frana {

/// Returns the scheme of a file; share/doc/hazard.md describes its keys. Every problem is collected, with `label` for
/// the file; the scheme is then incomplete. Throws Error(input) if the file cannot be read as INI.
HazardScheme read_scheme(const std::string& path, const std::string& label, Problems& problems);

/// Returns the scheme that a scene names; none without one, and with a problem. `where` is where it is named.
std::optional<HazardScheme> resolved_scheme(const HazardSpec& spec, const std::string& share, const Place& where,
                                            Problems& problems);

}  // namespace frana
