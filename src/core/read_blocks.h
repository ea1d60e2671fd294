// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace frana {

/// Passes a file's bytes to `consume`, block by block from the beginning; a read interrupted by a signal is repeated.
/// Returns 0, or the reason why not everything could be read (errno; EINVAL: a FIFO, a device or another file that is
/// not regular).
int read_blocks(const std::string& path, const std::function<void(std::string_view)>& consume);

}  // namespace frana
