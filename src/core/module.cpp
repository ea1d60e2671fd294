// SPDX-License-Identifier: Apache-2.0
#include "core/module.h"

#include <dlfcn.h>

#include <cstring>
#include <filesystem>
#include <vector>

#include "core/error.h"

namespace frana {
namespace {

namespace fs = std::filesystem;

/// Folders for modules, relative to that of the program: in a build, installed.
constexpr const char* k_folders[] = {"modules", "../lib/frana"};

std::vector<fs::path> places_of(const std::string& name) {
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error).parent_path();
    std::vector<fs::path> places;
    for (const char* folder : k_folders) places.push_back((program / folder / (name + ".so")).lexically_normal());
    return places;
}

[[noreturn]] void fail(const std::string& what, const fs::path& file, const std::string& value) {
    throw Error(
        ErrorKind::environment,
        Problem{what, file.string(), value, "",
                "Install Debian's package of it (frana-pictures, frana-studies, frana-mpi), or build frana anew "
                "with ./build.sh build"});
}

fs::path file_of(const std::string& name) {
    const std::vector<fs::path> places = places_of(name);
    std::error_code error;
    for (const fs::path& file : places)
        if (fs::exists(file, error)) return file;
    fail("a part of frana is missing", places.front(), "");
}

}  // namespace

void require_module(const std::string& name) {
    static_cast<void>(file_of(name));
}

const void* module_table(const std::string& name, ModuleScope scope, const char* type, std::size_t size) {
    const fs::path file = file_of(name);
    // Bound when called: most of its functions never are. Never unloaded: its library may have started threads.
    void* const library = ::dlopen(file.c_str(), RTLD_LAZY | (scope == ModuleScope::own ? RTLD_LOCAL : RTLD_GLOBAL));
    if (library == nullptr) fail("a part of frana cannot be loaded", file, ::dlerror());
    void* const entry = ::dlsym(library, k_module_entry);
    if (entry == nullptr) fail("is no part of frana", file, "");
    const ModuleContent content = reinterpret_cast<ModuleContent (*)()>(entry)();
    if (std::strcmp(content.build, FRANA_BUILD) != 0 || std::strcmp(content.type, type) != 0 || content.size != size)
        fail("is a part of another version of frana", file, content.build);
    return content.table;
}

}  // namespace frana
