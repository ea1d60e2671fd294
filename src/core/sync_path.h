// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace frana {

/// Waits until an open file's bytes, or a folder's names, are on the disk and outlast a power cut. Returns 0,
/// or why the disk could not take them (errno); a file system that knows no such thing is no problem.
int sync_descriptor(int descriptor);

/// The same of a file or folder by its path; one that cannot be opened is left.
int sync_path(const std::string& path);

}  // namespace frana
