// SPDX-License-Identifier: Apache-2.0
#include "harness.h"

#include <cpl_vsi.h>

#include <utility>

namespace frana::fuzz {

MemoryFile::MemoryFile(std::string path, const std::uint8_t* data, std::size_t size) : path_(std::move(path)) {
    // GDAL reads the bytes in place.
    VSIFCloseL(VSIFileFromMemBuffer(path_.c_str(), const_cast<GByte*>(data), size, FALSE));
}

MemoryFile::~MemoryFile() {
    VSIUnlink(path_.c_str());
}

Input split(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return {};
    return {static_cast<char>(data[0]), data + 1, size - 1};
}

}  // namespace frana::fuzz
