// SPDX-License-Identifier: Apache-2.0
#include "app/text_file.h"

#include <cerrno>
#include <cstring>
#include <fstream>

#include "core/error.h"
#include "core/file_aside.h"

namespace frana::app {

void write_text_file(const std::string& path, const std::string& text) {
    FileAside aside(path);
    errno = 0;
    std::ofstream file(aside.partial_path(), std::ios::binary);
    file << text;
    file.close();
    if (!file) {
        throw Error(ErrorKind::environment, Problem{std::string("cannot be written: ") + std::strerror(errno),
                                                    path, "", "", "Check the disk's space and the rights"});
    }
    aside.rename_into_place();
}

}  // namespace frana::app
