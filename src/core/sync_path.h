// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace frana {

/// Waits until an open file's bytes, or a folder's names, are on the disk and survive a power failure. Returns 0, or
/// the reason why the disk could not store them (errno); a file system that does not support syncing is not a problem.
int sync_descriptor(int descriptor);

/// The same for a file or folder given by path; one that cannot be opened is ignored.
int sync_path(const std::string& path);

}  // namespace frana
