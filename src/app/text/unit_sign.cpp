// SPDX-License-Identifier: Apache-2.0
#include "app/text/unit_sign.h"

#include "app/text/number_text.h"

namespace frana::app {

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

std::string signed_number_text(double value) {
    return (value > 0 ? "+" : "") + number_text(value, 3);
}

}  // namespace frana::app
