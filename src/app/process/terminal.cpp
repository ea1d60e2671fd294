// SPDX-License-Identifier: Apache-2.0
#include "app/process/terminal.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdlib>

namespace frana::app {

std::size_t output_width() {
    constexpr std::size_t k_usual = 80;
    if (::isatty(STDOUT_FILENO) != 1) return k_any_width;
    winsize size{};
    if (::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0) return size.ws_col;
    const char* const columns = std::getenv("COLUMNS");
    const long given = columns != nullptr ? std::strtol(columns, nullptr, 10) : 0;
    return given > 0 ? static_cast<std::size_t>(given) : k_usual;
}

}  // namespace frana::app
