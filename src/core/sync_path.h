// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace frana {

/// Waits until a file, or a folder's names, is on the disk and outlasts a power cut. What cannot be is left.
void sync_path(const std::string& path);

}  // namespace frana
