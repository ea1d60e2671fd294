// SPDX-License-Identifier: Apache-2.0
#include "app/input/share_directory.h"

#include <cstdlib>
#include <filesystem>
#include <vector>

#include "core/error.h"

namespace frana::app {

std::string share_directory() {
    namespace fs = std::filesystem;
    if (const char* named = std::getenv("FRANA_SHARE"); named != nullptr && *named != '\0') {
        if (fs::is_directory(named)) return named;
        throw Error(ErrorKind::environment, Problem{"is not a folder", "FRANA_SHARE", named, "",
                                                    "Set it to frana's share folder, or unset it"});
    }
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    std::vector<fs::path> candidates;
    for (const char* folder : {"share/frana", "../share/frana"})
        candidates.push_back((program.parent_path() / folder).lexically_normal());
    for (const fs::path& candidate : candidates)
        if (fs::is_directory(candidate / "materials", error)) return candidate.string();
    throw Error(ErrorKind::environment, Problem{"the share folder with the material presets is missing",
                                                candidates.back().string(), "", "", "Set FRANA_SHARE to it"});
}

std::string materials_directory() {
    return (std::filesystem::path(share_directory()) / "materials").string();
}

}  // namespace frana::app
