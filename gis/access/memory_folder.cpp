// SPDX-License-Identifier: Apache-2.0
#include "gis/access/memory_folder.h"

#include <cpl_string.h>
#include <cpl_vsi.h>

#include <filesystem>

namespace frana::gis {

namespace fs = std::filesystem;

// The address makes the name unique.
MemoryFolder::MemoryFolder() : folder_("/vsimem/frana_" + std::to_string(reinterpret_cast<std::uintptr_t>(this))) {
    VSIMkdir(folder_.c_str(), 0700);
}

MemoryFolder::~MemoryFolder() {
    VSIRmdirRecursive(folder_.c_str());
}

std::string MemoryFolder::place_of(const std::string& path) const {
    return folder_ + "/" + fs::path(path).filename().string();
}

void MemoryFolder::write_to_disk(const std::string& path, Sync sync) const {
    const CPLStringList names(VSIReadDir(folder_.c_str()), TRUE);
    for (int i = 0; i < names.size(); ++i) {
        const std::string name = names[i];
        vsi_l_offset size = 0;
        const GByte* bytes = VSIGetMemFileBuffer((folder_ + "/" + name).c_str(), &size, FALSE);
        write_file((fs::path(path).parent_path() / name).string(),
                   {reinterpret_cast<const char*>(bytes), bytes == nullptr ? 0 : static_cast<std::size_t>(size)}, sync);
    }
}

}  // namespace frana::gis
