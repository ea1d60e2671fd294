// SPDX-License-Identifier: Apache-2.0
#include "app/text_file.h"

#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>

#include "core/error.h"

namespace frana::app {

void write_text_file(const std::string& path, const std::string& text) {
    const std::string aside = path + ".partial-" + std::to_string(::getpid());
    std::error_code failure;
    {
        std::ofstream file(aside, std::ios::binary);
        file << text;
        file.flush();
        if (!file) failure = std::make_error_code(std::errc::io_error);
    }
    if (!failure) std::filesystem::rename(aside, path, failure);
    if (!failure) return;
    std::error_code ignored;
    std::filesystem::remove(aside, ignored);
    throw Error(ErrorKind::environment, Problem{"cannot be written: " + failure.message(), path, "", "",
                                                "Check the disk's space and the rights"});
}

}  // namespace frana::app
