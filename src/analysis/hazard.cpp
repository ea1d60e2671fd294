// SPDX-License-Identifier: Apache-2.0
#include "analysis/hazard.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/text.h"
#include "core/words/words.h"

namespace frana {
namespace {

// Greens, so that an intensity is not mistaken for a hazard level (red, blue, yellow), which also depends on the
// frequency.
constexpr Rgb k_light{186, 228, 179}, k_middle{65, 158, 90}, k_dark{0, 68, 27};

const std::string k_swiss =
    "BWW, BRP, BUWAL (1997): Ber\u00FCcksichtigung der Hochwassergefahren bei raumwirksamen T\u00E4tigkeiten, Bern";

// Thresholds of the schemes, in SI units.
constexpr double k_debris_depth = 1, k_debris_speed = 1, k_flood_low = 0.5, k_flood_high = 2, k_torrent_head = 1.5,
                 k_torrent_deposit = 0.7;

const std::string k_metres = " m", k_metres_per_second = " m/s", k_flux_unit = " m\u00B2/s", k_pressure_unit = " kPa";
const std::string k_depth = worded("depth"), k_speed = worded("speed"), k_flux = worded("depth \u00D7 speed");

std::string over(const std::string& what, double limit, const std::string& unit, const char* sign = " > ") {
    return what + sign + shortest_text(limit) + unit;
}

std::string up_to(const std::string& what, double limit, const std::string& unit) {
    return over(what, limit, unit, " \u2264 ");
}

/// A quantity of scheme custom and its limits.
struct LimitedQuantity {
    std::string words, unit;
    const std::vector<double>& limits;
};

/// Returns what puts a cell into the class that exceeds `exceeded` limits: of one quantity its range, of several what
/// each must exceed.
std::string custom_thresholds(const std::vector<LimitedQuantity>& quantities, std::size_t exceeded) {
    if (quantities.size() == 1) {
        const auto& [words, unit, limits] = quantities.front();
        if (exceeded == 0) return up_to(words, limits.front(), unit);
        if (exceeded == limits.size()) return over(words, limits.back(), unit);
        return words + " " + shortest_text(limits[exceeded - 1]) + " \u2013 " + shortest_text(limits[exceeded]) + unit;
    }
    std::string text;
    for (const auto& [words, unit, limits] : quantities) {
        if (limits.size() < exceeded) continue;
        if (!text.empty()) text += exceeded == 0 ? " and " : " or ";
        text += exceeded == 0 ? up_to(words, limits.front(), unit) : over(words, limits[exceeded - 1], unit);
    }
    return text;
}

std::vector<HazardClass> custom_classes(const HazardLimits& limits) {
    std::vector<LimitedQuantity> quantities{{k_depth, k_metres, limits.depth},
                                            {k_speed, k_metres_per_second, limits.velocity},
                                            {k_flux, k_flux_unit, limits.flux},
                                            {worded("pressure"), k_pressure_unit, limits.pressure}};
    std::vector<LimitedQuantity> given;
    std::size_t most = 0;
    for (const LimitedQuantity& one : quantities) {
        most = std::max(most, one.limits.size());
        if (!one.limits.empty()) given.push_back(one);
    }
    std::vector<HazardClass> classes;
    for (std::size_t i = 0; i <= most; ++i) {
        const double t = most == 0 ? 0 : static_cast<double>(i) / static_cast<double>(most);
        const auto mix = [t](std::uint8_t a, std::uint8_t b) {
            return static_cast<std::uint8_t>(std::lround(a + t * (b - a)));
        };
        const std::string thresholds = custom_thresholds(given, i);
        classes.push_back({static_cast<int>(i) + 1,
                           thresholds,
                           thresholds,
                           {mix(k_light.r, k_dark.r), mix(k_light.g, k_dark.g), mix(k_light.b, k_dark.b)}});
    }
    return classes;
}

int count_exceeded(const std::vector<double>& limits, double value) {
    return static_cast<int>(
        std::count_if(limits.begin(), limits.end(), [value](double limit) { return value > limit; }));
}

int swiss_debris_flow(const HazardQuantities& q, std::size_t i) {
    return q.depth.values[i] > k_debris_depth && q.velocity.values[i] > k_debris_speed ? 3 : 2;
}

int swiss_flood(const HazardQuantities& q, std::size_t i) {
    const double worst = std::max(q.depth.values[i], q.flux.values[i]);
    return worst > k_flood_high ? 3 : worst > k_flood_low ? 2 : 1;
}

int austrian_torrent(const HazardQuantities& q, std::size_t i) {
    return q.head.values[i] >= k_torrent_head || q.deposit.values[i] >= k_torrent_deposit ? 2 : 1;
}

int custom(const HazardLimits& limits, const HazardQuantities& q, std::size_t i) {
    return 1 + std::max({count_exceeded(limits.depth, q.depth.values[i]),
                         count_exceeded(limits.velocity, q.velocity.values[i]),
                         count_exceeded(limits.flux, q.flux.values[i]),
                         count_exceeded(limits.pressure, q.pressure.values[i])});
}

HazardScheme known_scheme(const std::string& name, const HazardLimits& limits) {
    if (name == "swiss-debris-flow")
        return {
            name,
            k_swiss,
            {{2, worded("Medium intensity"),
              up_to(k_depth, k_debris_depth, k_metres) + " or " + up_to(k_speed, k_debris_speed, k_metres_per_second),
              k_middle},
             {3, worded("High intensity"),
              over(k_depth, k_debris_depth, k_metres) + " and " + over(k_speed, k_debris_speed, k_metres_per_second),
              k_dark}},
            {}};
    if (name == "swiss-flood")
        return {name,
                k_swiss,
                {{1, worded("Low intensity"),
                  up_to(k_depth, k_flood_low, k_metres) + " and " + up_to(k_flux, k_flood_low, k_flux_unit), k_light},
                 {2, worded("Medium intensity"),
                  over(k_depth, k_flood_low, k_metres) + " or " + over(k_flux, k_flood_low, k_flux_unit), k_middle},
                 {3, worded("High intensity"),
                  over(k_depth, k_flood_high, k_metres) + " or " + over(k_flux, k_flood_high, k_flux_unit), k_dark}},
                {}};
    if (name == "austrian-torrent")
        return {name,
                worded("customary limits, source not read"),
                {{1,
                  worded("Yellow zone"),
                  over(worded("energy head"), k_torrent_head, k_metres, " < ") + " and " +
                      over(worded("deposit"), k_torrent_deposit, k_metres, " < "),
                  {255, 221, 51}},
                 {2,
                  worded("Red zone"),
                  over(worded("energy head"), k_torrent_head, k_metres, " \u2265 ") + " or " +
                      over(worded("deposit"), k_torrent_deposit, k_metres, " \u2265 "),
                  {215, 25, 28}}},
                {},
                worded("Zones")};
    if (name == "custom") return {name, worded("limits of the scene"), custom_classes(limits), limits};
    throw Error(ErrorKind::input, Problem{"is not a hazard scheme", "hazard.scheme", name,
                                          "swiss-debris-flow, swiss-flood, austrian-torrent, custom", ""});
}

}  // namespace

std::string HazardScheme::minimum_label() const {
    return worded("Any class") + (": " + over(k_depth, minimum_depth, k_metres));
}

HazardScheme hazard_scheme(const std::string& name, const HazardLimits& limits, double minimum_depth) {
    HazardScheme scheme = known_scheme(name, limits);
    scheme.minimum_depth = minimum_depth;
    return scheme;
}

Raster hazard_classes(const HazardScheme& scheme, const HazardQuantities& quantities) {
    Raster classes(quantities.depth.grid, k_no_data);
    const auto fill = [&](const auto& class_of) {
        quantities.depth.values.for_each_stored([&](std::size_t cell, double depth) {
            if (depth > scheme.minimum_depth) classes.values[cell] = class_of(quantities, cell);
        });
    };
    if (scheme.name == "swiss-debris-flow")
        fill(swiss_debris_flow);
    else if (scheme.name == "swiss-flood")
        fill(swiss_flood);
    else if (scheme.name == "austrian-torrent")
        fill(austrian_torrent);
    else
        fill([&](const HazardQuantities& q, std::size_t i) { return custom(scheme.limits, q, i); });
    return classes;
}

namespace {

struct NamedDegree {
    HazardDegree degree;
    const char *name, *words;
    Rgb colour;
};
/// Colours as on Swiss hazard maps.
constexpr NamedDegree k_degrees[] = {
    {HazardDegree::residual, "yellow-white", worded("Yellow-white, residual hazard"), {255, 250, 190}},
    {HazardDegree::yellow, "yellow", worded("Yellow, low hazard"), {255, 225, 60}},
    {HazardDegree::blue, "blue", worded("Blue, medium hazard"), {60, 120, 215}},
    {HazardDegree::red, "red", worded("Red, high hazard"), {215, 30, 30}}};

// As the thresholds of intensities are written, so that they can be put into a language.
const std::string k_years = " a", k_up_to = " \u2264 ", k_range = " \u2013 ", k_over = " > ";

}  // namespace

std::string name_of(HazardDegree degree) {
    return k_degrees[static_cast<int>(degree) - 1].name;
}

std::optional<HazardDegree> degree_from(const std::string& name) {
    for (const NamedDegree& one : k_degrees)
        if (name == one.name) return one.degree;
    return std::nullopt;
}

std::string intensity_name(int intensity) {
    return intensity == 1 ? worded("weak") : intensity == 2 ? worded("medium") : worded("strong");
}

HazardDegree DegreeMatrix::of(int intensity, double return_period) const {
    for (std::size_t p = 0; p < k_probabilities; ++p)
        if (return_period <= periods[p]) return degrees[static_cast<std::size_t>(intensity - 1)][p];
    return HazardDegree::residual;
}

std::string DegreeMatrix::conditions_of(HazardDegree degree) const {
    std::string text;
    const auto add = [&](const std::string& words) { text += (text.empty() ? "" : "; ") + words; };
    for (int intensity = k_intensities; intensity >= 1; --intensity) {
        const auto& row = degrees[static_cast<std::size_t>(intensity - 1)];
        for (std::size_t first = 0; first < k_probabilities; ++first) {
            if (row[first] != degree) continue;
            std::size_t last = first;
            while (last + 1 < k_probabilities && row[last + 1] == degree) ++last;
            add(intensity_name(intensity) + (first == 0 ? k_up_to : " " + shortest_text(periods[first - 1]) + k_range) +
                shortest_text(periods[last]) + k_years);
            first = last;
        }
    }
    if (degree == HazardDegree::residual) add(worded("any") + (k_over + shortest_text(periods.back()) + k_years));
    return text;
}

std::vector<HazardClass> degree_classes(const DegreeMatrix& matrix) {
    std::vector<HazardClass> classes;
    for (const NamedDegree& one : k_degrees) {
        const std::string conditions = matrix.conditions_of(one.degree);
        if (conditions.empty()) continue;
        classes.push_back(
            {static_cast<int>(one.degree), one.words, conditions, one.colour, one.degree == HazardDegree::residual});
    }
    return classes;
}

bool has_intensities(const HazardScheme& scheme) {
    const auto& classes = scheme.classes;
    return scheme.name != "austrian-torrent" && !classes.empty() && classes.back().value == k_intensities &&
           std::all_of(classes.begin(), classes.end(), [](const HazardClass& one) { return one.value >= 1; });
}

}  // namespace frana
