// SPDX-License-Identifier: Apache-2.0
#include "gis/crs/vertical_unit.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>

#include "core/error.h"
#include "core/words/words.h"
#include "gis/crs/crs.h"

namespace frana::gis {
namespace {

/// A unit of elevations.
struct Unit {
    const char* key;  ///< of terrain.vertical-unit
    const char* name;
    double metres;
    std::initializer_list<const char*> words;  ///< in files, letters only
};

// The feet are exact by definition.
constexpr Unit k_units[] = {
    {"metre", worded("metre"), 1, {"m", "metre", "metres", "meter", "meters"}},
    {"decimetre", worded("decimetre"), 0.1, {"dm", "decimetre", "decimeter"}},
    {"centimetre", worded("centimetre"), 0.01, {"cm", "centimetre", "centimeter"}},
    {"millimetre", worded("millimetre"), 0.001, {"mm", "millimetre", "millimeter"}},
    {"foot", worded("foot"), 0.3048, {"ft", "foot", "feet", "internationalfoot"}},
    {"us-survey-foot",
     worded("US survey foot"),
     1200.0 / 3937.0,
     {"ftus", "usft", "ussurveyfoot", "ussurveyfeet", "footus", "footussurvey", "sft"}},
};

VerticalUnit known(const Unit& unit) {
    return {unit.name, unit.metres, true, true};
}

std::string simplified(const std::string& text) {
    std::string simple;
    for (const char c : text) {
        if (std::isalpha(static_cast<unsigned char>(c))) {
            simple += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        }
    }
    return simple;
}

bool one_of(const std::string& word, std::initializer_list<const char*> words) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

}  // namespace

VerticalUnit vertical_unit_of(const std::string& band_unit, const std::string& crs_wkt) {
    const std::string word = simplified(band_unit);
    for (const Unit& unit : k_units)
        if (one_of(word, unit.words)) return known(unit);
    if (!band_unit.empty()) return {band_unit, 1, false, true};
    const double metres = crs_wkt.empty() ? 0 : vertical_metres_per_unit(crs_wkt);
    if (metres == 0) return {};
    // Units are stored with rounded factors in some files.
    for (const Unit& unit : k_units)
        if (std::abs(metres - unit.metres) < (unit.metres == 1 ? 1e-12 : 1e-9)) return known(unit);
    return {"unit of " + std::to_string(metres) + " m", metres, true, true};
}

VerticalUnit vertical_unit_named(const std::string& name) {
    std::string names;
    for (const Unit& unit : k_units) {
        if (name == unit.key) return known(unit);
        names += (names.empty() ? "" : ", ") + std::string(unit.key);
    }
    throw Error(ErrorKind::input, Problem{"unknown vertical unit", "", name, names, ""});
}

}  // namespace frana::gis
