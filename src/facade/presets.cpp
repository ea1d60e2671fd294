// SPDX-License-Identifier: Apache-2.0
#include "facade/presets.h"

#include <dlfcn.h>

#include <cstdlib>
#include <filesystem>

#include "core/error.h"

namespace frana::facade {

namespace fs = std::filesystem;

std::string presets_directory() {
    if (const char* named = std::getenv("FRANA_SHARE"); named != nullptr && *named != '\0')
        return (fs::path(named) / "materials").string();
    // PREFIX/lib/libfrana.so, PREFIX/lib/x86_64-linux-gnu/libfrana.so, PREFIX/lib/python3/dist-packages/frana/...
    Dl_info here{};
    std::error_code error;
    if (dladdr(reinterpret_cast<const void*>(&presets_directory), &here) != 0 && here.dli_fname != nullptr) {
        const fs::path library = fs::canonical(here.dli_fname, error);
        for (fs::path folder = library.parent_path(); folder.has_relative_path(); folder = folder.parent_path())
            for (const char* share : {"share/frana/materials", "share/materials"})
                if (fs::is_directory(folder / share, error)) return (folder / share).string();
    }
    throw frana::Error(ErrorKind::environment, frana::Problem{"the share folder with the material presets is missing",
                                                              here.dli_fname == nullptr ? "frana" : here.dli_fname, "",
                                                              "", "Set FRANA_SHARE to it"});
}

}  // namespace frana::facade
