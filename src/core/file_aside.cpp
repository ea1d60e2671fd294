// SPDX-License-Identifier: Apache-2.0
#include "core/file_aside.h"

#include <unistd.h>

#include <filesystem>
#include <system_error>
#include <utility>

#include "core/error.h"

namespace frana {
namespace {

std::string beside(const std::filesystem::path& path) {
    std::filesystem::path name = path.stem();
    name += ".partial" + std::to_string(getpid());
    name += path.extension();
    return (path.parent_path() / name).string();
}

}  // namespace

FileAside::FileAside(std::string path) : path_(std::move(path)), partial_(beside(path_)) {}

FileAside::~FileAside() {
    if (done_) return;
    std::error_code ignored;
    std::filesystem::remove(partial_, ignored);
}

void FileAside::rename_into_place() {
    std::error_code code;
    std::filesystem::rename(partial_, path_, code);
    if (code) {
        throw Error(ErrorKind::environment, Problem{"a finished file cannot take its name", path_,
                                                    code.message(), "", "Choose another name or folder"});
    }
    done_ = true;
}

}  // namespace frana
