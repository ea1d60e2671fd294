// SPDX-License-Identifier: Apache-2.0
#include "analysis/hazard.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/shortest_text.h"

namespace frana {
namespace {

// Greens, so that an intensity is not mistaken for a hazard level (red, blue, yellow), which also depends on the
// frequency.
constexpr Rgb k_light{186, 228, 179}, k_middle{65, 158, 90}, k_dark{0, 68, 27};

const std::string k_swiss =
    "BWW, BRP, BUWAL (1997): Beruecksichtigung der Hochwassergefahren bei raumwirksamen Taetigkeiten, Bern "
    "(Loat and Petrascheck)";

std::vector<HazardClass> custom_classes(const HazardLimits& limits) {
    std::size_t most = 0;
    for (const auto* list : {&limits.depth, &limits.velocity, &limits.flux, &limits.pressure})
        most = std::max(most, list->size());
    std::vector<HazardClass> classes;
    for (std::size_t i = 0; i <= most; ++i) {
        const double t = most == 0 ? 0 : static_cast<double>(i) / static_cast<double>(most);
        const auto mix = [t](std::uint8_t a, std::uint8_t b) {
            return static_cast<std::uint8_t>(std::lround(a + t * (b - a)));
        };
        classes.push_back({static_cast<int>(i) + 1,
                           "Class " + std::to_string(i + 1),
                           {mix(k_light.r, k_dark.r), mix(k_light.g, k_dark.g), mix(k_light.b, k_dark.b)}});
    }
    return classes;
}

int count_exceeded(const std::vector<double>& limits, double value) {
    return static_cast<int>(
        std::count_if(limits.begin(), limits.end(), [value](double limit) { return value > limit; }));
}

int swiss_debris_flow(const HazardQuantities& q, std::size_t i) {
    return q.depth.values[i] > 1 && q.velocity.values[i] > 1 ? 3 : 2;
}

int swiss_flood(const HazardQuantities& q, std::size_t i) {
    const double worst = std::max(q.depth.values[i], q.flux.values[i]);
    return worst > 2 ? 3 : worst > 0.5 ? 2 : 1;
}

int austrian_torrent(const HazardQuantities& q, std::size_t i) {
    return q.head.values[i] >= 1.5 || q.deposit.values[i] >= 0.7 ? 2 : 1;
}

int custom(const HazardLimits& limits, const HazardQuantities& q, std::size_t i) {
    return 1 + std::max({count_exceeded(limits.depth, q.depth.values[i]),
                         count_exceeded(limits.velocity, q.velocity.values[i]),
                         count_exceeded(limits.flux, q.flux.values[i]),
                         count_exceeded(limits.pressure, q.pressure.values[i])});
}

}  // namespace

HazardScheme hazard_scheme(const std::string& name, const HazardLimits& limits) {
    if (name == "swiss-debris-flow")
        return {name, k_swiss, {{2, "Medium intensity", k_middle}, {3, "High intensity", k_dark}}, {}};
    if (name == "swiss-flood")
        return {name,
                k_swiss,
                {{1, "Low intensity", k_light}, {2, "Medium intensity", k_middle}, {3, "High intensity", k_dark}},
                {}};
    if (name == "austrian-torrent")
        return {name,
                "BMLFUW (2011): Richtlinie fuer die Gefahrenzonenplanung, Vienna (torrents, design event)",
                {{1, "Yellow zone", {255, 221, 51}}, {2, "Red zone", {215, 25, 28}}},
                {}};
    if (name == "custom") return {name, "limits of the scene", custom_classes(limits), limits};
    throw Error(ErrorKind::input, Problem{"is not a hazard scheme", "hazard.scheme", name,
                                          "swiss-debris-flow, swiss-flood, austrian-torrent, custom", ""});
}

Raster hazard_classes(const HazardScheme& scheme, const HazardQuantities& quantities) {
    Raster classes(quantities.depth.grid, k_no_data);
    const auto fill = [&](const auto& class_of) {
        quantities.depth.values.for_each_stored([&](std::size_t cell, double depth) {
            if (!std::isnan(depth)) classes.values[cell] = class_of(quantities, cell);
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

}  // namespace frana
