// SPDX-License-Identifier: Apache-2.0
#include "app/text/text_file.h"

#include "core/file_aside.h"

namespace frana::app {

void write_text_file(const std::string& path, const std::string& text) {
    write_file(path, text);
}

}  // namespace frana::app
