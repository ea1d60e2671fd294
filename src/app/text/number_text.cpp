// SPDX-License-Identifier: Apache-2.0
#include "app/text/number_text.h"

#include <array>
#include <ctime>

namespace frana::app {

std::string bytes_text(double bytes) {
    const char* const units[] = {"B", "kB", "MB", "GB", "TB"};
    int unit = 0;
    while (bytes >= 1000 && unit < 4) {
        bytes /= 1000;
        ++unit;
    }
    return number_text(bytes, 3) + " " + units[unit];
}

std::string duration_text(double seconds) {
    if (seconds < 120) return number_text(seconds, 2) + " s";
    if (seconds < 7200) return number_text(seconds / 60, 2) + " min";
    return number_text(seconds / 3600, 2) + " h";
}

std::string unit_sign(const std::string& unit) {
    if (unit == "degrees") return "°";
    std::string sign;
    for (const char c : unit) {
        const bool is_power = !sign.empty() && (sign.back() == 'm' || sign.back() == 's');
        if (is_power && c == '2')
            sign += "²";
        else if (is_power && c == '3')
            sign += "³";
        else
            sign += c;
    }
    return sign;
}

std::string with_unit(const std::string& title, const std::string& unit) {
    return unit.empty() || unit == "-" ? title : title + " [" + unit_sign(unit) + "]";
}

std::string signed_number_text(double value) {
    return (value > 0 ? "+" : "") + number_text(value, 3);
}

std::string today() {
    const std::time_t now = std::time(nullptr);
    std::tm parts{};
    ::localtime_r(&now, &parts);
    std::array<char, 32> text{};
    std::strftime(text.data(), text.size(), "%Y-%m-%d", &parts);
    return text.data();
}

}  // namespace frana::app
