// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace frana {

/// Hands a file's bytes over, block by block from its beginning; a read that a signal interrupts is repeated.
/// Returns 0, or why not all could be read (errno; EINVAL: a FIFO, a device or another that is no regular
/// file).
int read_blocks(const std::string& path, const std::function<void(std::string_view)>& consume);

}  // namespace frana
