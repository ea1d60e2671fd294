// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace frana {

/// Returns a remedy for the user after a system call failed for this reason (errno), as a sentence without its full
/// stop.
std::string system_remedy(int reason);

}  // namespace frana
