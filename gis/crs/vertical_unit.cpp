// SPDX-License-Identifier: Apache-2.0
#include "gis/crs/vertical_unit.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>

#include "core/error.h"
#include "gis/crs/crs.h"

namespace frana::gis {
namespace {

constexpr double k_foot = 0.3048;                     // international foot, exact
constexpr double k_us_survey_foot = 1200.0 / 3937.0;  // exact by definition

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
    if (one_of(word, {"m", "metre", "metres", "meter", "meters"})) return {"metre", 1, true, true};
    if (one_of(word, {"ft", "foot", "feet", "internationalfoot"})) return {"foot", k_foot, true, true};
    if (one_of(word, {"ftus", "usft", "ussurveyfoot", "ussurveyfeet", "footus", "footussurvey", "sft"})) {
        return {"US survey foot", k_us_survey_foot, true, true};
    }
    if (word == "cm") return {"centimetre", 0.01, true, true};
    if (word == "mm") return {"millimetre", 0.001, true, true};
    if (!band_unit.empty()) return {band_unit, 1, false, true};
    const double metres = crs_wkt.empty() ? 0 : vertical_metres_per_unit(crs_wkt);
    if (metres == 0) return {};
    if (std::abs(metres - 1) < 1e-12) return {"metre", 1, true, true};
    // Units are stored with rounded factors in some files; these are the only two in use for heights.
    if (std::abs(metres - k_foot) < 1e-9) return {"foot", k_foot, true, true};
    if (std::abs(metres - k_us_survey_foot) < 1e-9) return {"US survey foot", k_us_survey_foot, true, true};
    return {"unit of " + std::to_string(metres) + " m", metres, true, true};
}

VerticalUnit vertical_unit_named(const std::string& name) {
    if (name == "metre") return {"metre", 1, true, true};
    if (name == "foot") return {"foot", k_foot, true, true};
    if (name == "us-survey-foot") return {"US survey foot", k_us_survey_foot, true, true};
    throw Error(ErrorKind::input, Problem{"unknown vertical unit", "", name, "metre, foot, us-survey-foot", ""});
}

}  // namespace frana::gis
