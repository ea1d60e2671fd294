// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace frana {

/// Returns what a user can do about a system call that failed for this reason (errno), as a sentence without its full
/// stop.
std::string system_remedy(int reason);

}  // namespace frana
