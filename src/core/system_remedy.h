// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace frana {

/// What a user can do about a call to the system that failed for this reason (errno), as a sentence without
/// its full stop.
std::string system_remedy(int reason);

}  // namespace frana
