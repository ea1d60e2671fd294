// SPDX-License-Identifier: Apache-2.0
#include "app/text/today.h"

#include <array>
#include <ctime>

namespace frana::app {

std::string today() {
    const std::time_t now = std::time(nullptr);
    std::tm parts{};
    ::localtime_r(&now, &parts);
    std::array<char, 32> text{};
    std::strftime(text.data(), text.size(), "%Y-%m-%d", &parts);
    return text.data();
}

}  // namespace frana::app
