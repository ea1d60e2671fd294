// SPDX-License-Identifier: Apache-2.0
#include "app/text/text_file.h"

#include <fstream>
#include <iterator>

#include "core/file_aside.h"

namespace frana::app {

void write_text_file(const std::string& path, const std::string& text) {
    write_file(path, text);
}

std::string read_text_file(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace frana::app
