// SPDX-License-Identifier: Apache-2.0
#include "gis/crs/crs.h"

#include <ogr_spatialref.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>
#include <numbers>
#include <optional>

#include "core/error.h"
#include "core/words/words.h"
#include "gis/access/gdal_session.h"
#include "gis/crs/crs_transform.h"

namespace frana::gis {
namespace {

const char* const k_crs_remedy =
    "Write an EPSG code such as EPSG:32632, a PROJ string or WKT; \"local\" means plain metres";

std::string wkt2(const OGRSpatialReference& crs) {
    const char* const options[] = {"FORMAT=WKT2_2019", "MULTILINE=NO", nullptr};
    char* text = nullptr;
    const bool good = crs.exportToWkt(&text, options) == OGRERR_NONE;
    std::string wkt = good && text ? text : "";
    CPLFree(text);
    return wkt;
}

std::optional<OGRSpatialReference> parse(const std::string& text) {
    OGRSpatialReference crs;
    // A CRS is text here: a name must never make the program read a file or use the network.
    const char* const options[] = {"ALLOW_NETWORK_ACCESS=NO", "ALLOW_FILE_ACCESS=NO", nullptr};
    if (text.empty() || crs.SetFromUserInput(text.c_str(), options) != OGRERR_NONE) return std::nullopt;
    crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    return crs;
}

void drop_heights(OGRSpatialReference& crs) {
    if (crs.IsCompound()) crs.StripVertical();
    if (crs.GetAxesCount() == 3) crs.DemoteTo2D(nullptr);
}

bool axes_run_east_and_north(const OGRSpatialReference& crs) {
    int east = 0, north = 0, south = 0;
    for (int axis = 0; axis < 2; ++axis) {
        OGRAxisOrientation direction = OAO_Other;
        crs.GetAxis("PROJCS", axis, &direction);
        east += direction == OAO_East;
        north += direction == OAO_North;
        south += direction == OAO_South;
    }
    // Around a pole both axes run along meridians, away from the north pole or towards it from the south pole.
    return (east == 1 && north == 1) || south == 2 || north == 2;
}

}  // namespace

std::string layer_crs(const OGRSpatialReference* crs) {
    if (!crs || !(crs->IsProjected() || crs->IsGeographic() || crs->IsCompound())) return {};
    // GeoPackage's name for "unknown", which GDAL presents in degrees.
    if (std::string(crs->GetName()).rfind("Undefined", 0) == 0) return {};
    return wkt2(*crs);
}

std::string crs_from_user(const std::string& text, const Place& where) {
    const GdalSession session;
    const auto error_of = [&](const std::string& what) {
        return Error(ErrorKind::input, Problem{what, where, text.empty() ? "nothing" : text, "", k_crs_remedy});
    };
    auto crs = parse(text);
    if (!crs) {
        const std::string reason = session.last_message();
        throw error_of("is not a coordinate reference system" + (reason.empty() ? "" : ": " + reason));
    }
    if (!crs->IsProjected() && !crs->IsGeographic() && !crs->IsCompound()) {
        throw error_of("the coordinate reference system is neither projected nor geographic");
    }
    std::string wkt = wkt2(*crs);
    if (wkt.empty()) throw error_of("the coordinate reference system cannot be written as WKT");
    return wkt;
}

std::string crs_name(const std::string& wkt) {
    if (wkt.empty()) return "local";
    const GdalSession session;
    const auto crs = parse(wkt);
    if (!crs) return "unknown";
    const char* name = crs->GetName();
    const char* authority = crs->GetAuthorityName(nullptr);
    const char* code = crs->GetAuthorityCode(nullptr);
    const std::string label = name ? name : "unnamed";
    return authority && code ? std::string(authority) + ":" + code + " (" + label + ")" : label;
}

bool is_projected_in_metres(const std::string& wkt) {
    const GdalSession session;
    auto crs = parse(wkt);
    if (!crs) return false;
    drop_heights(*crs);
    return crs->IsProjected() && std::abs(crs->GetLinearUnits() - 1.0) < 1e-9 && axes_run_east_and_north(*crs);
}

double metres_per_unit(const std::string& wkt) {
    const GdalSession session;
    const auto crs = parse(wkt);
    return crs && crs->IsProjected() ? crs->GetLinearUnits() : 1;
}

std::string horizontal_crs(const std::string& wkt) {
    const GdalSession session;
    auto crs = parse(wkt);
    if (!crs) return {};
    drop_heights(*crs);
    return wkt2(*crs);
}

double vertical_metres_per_unit(const std::string& wkt) {
    const GdalSession session;
    const auto crs = parse(wkt);
    if (!crs || !(crs->IsCompound() || crs->IsVertical())) return 0;
    const double unit = crs->GetTargetLinearUnits("VERT_CS");
    return unit > 0 ? unit : 0;
}

double longitude_turn(const std::string& wkt) {
    const GdalSession session;
    const auto crs = parse(wkt);
    return crs && crs->IsGeographic() ? 2 * std::numbers::pi / crs->GetAngularUnits() : 0;
}

std::string utm_crs_for(double longitude, double latitude) {
    const GdalSession session;
    if (longitude > 180) longitude -= 360;  // of a map that crosses the antimeridian
    const int zone = std::clamp(static_cast<int>(std::floor((longitude + 180) / 6)) + 1, 1, 60);
    OGRSpatialReference crs;
    crs.importFromEPSG((latitude < 0 ? 32700 : 32600) + zone);
    return wkt2(crs);
}

Point to_longitude_latitude(const std::string& wkt, Point map) {
    return CrsTransform(wkt, "OGC:CRS84", Bounds{map.x, map.y, map.x, map.y})(map);
}

double meridian_convergence_deg(const std::string& wkt, Point map) {
    if (wkt.empty()) return 0;
    const CrsTransform to_degrees(wkt, "OGC:CRS84", Bounds{map.x, map.y, map.x, map.y});
    const Point here = to_degrees(map);
    // Some 100 m either way along the meridian: long compared with rounding, short compared with its curvature.
    const double step = 1e-3;
    const Point north = to_degrees.inverse({here.x, here.y + step});
    const Point south = to_degrees.inverse({here.x, here.y - step});
    return std::atan2(north.x - south.x, north.y - south.y) * 180 / std::numbers::pi;
}

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
    {"metre", "m", 1, {"m", "metre", "metres", "meter", "meters"}},
    {"decimetre", "dm", 0.1, {"dm", "decimetre", "decimeter"}},
    {"centimetre", "cm", 0.01, {"cm", "centimetre", "centimeter"}},
    {"millimetre", "mm", 0.001, {"mm", "millimetre", "millimeter"}},
    {"foot", "ft", 0.3048, {"ft", "foot", "feet", "internationalfoot"}},
    {"us-survey-foot",
     "ftUS",
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
