// SPDX-License-Identifier: Apache-2.0
#include "gis/access/time_origin.h"

#include <chrono>
#include <cmath>
#include <cstdio>

namespace frana::gis {

std::string date_text(double seconds) {
    using namespace std::chrono;
    constexpr sys_days k_origin = year{2000} / January / 1;
    const auto passed = milliseconds(std::llround(seconds * 1000));
    const days whole = floor<days>(passed);
    const year_month_day date{k_origin + whole};
    const hh_mm_ss<milliseconds> time{passed - whole};
    char text[80];
    std::snprintf(text, sizeof text, "%04d-%02u-%02uT%02lld:%02lld:%02lld.%03lldZ", static_cast<int>(date.year()),
                  static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()),
                  static_cast<long long>(time.hours().count()), static_cast<long long>(time.minutes().count()),
                  static_cast<long long>(time.seconds().count()), static_cast<long long>(time.subseconds().count()));
    return text;
}

}  // namespace frana::gis
