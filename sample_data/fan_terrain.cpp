// SPDX-License-Identifier: Apache-2.0
#include "sample_data/fan_terrain.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sample_data/relief.h"

namespace frana::sample {
namespace {

constexpr double k_middle = 600;      // of the fan, local metres
constexpr double k_floor = 620;       // height of the valley floor in the south [m]
constexpr double k_mouth = 200;       // distance of the gullies' mouths from the foot [m]
constexpr double k_apex_height = 61;  // of the fan, above the floor [m]
constexpr double k_fan_length = 360;

// From the foot uphill.
constexpr std::array<Station, 7> k_side{
    {{0, 0.03}, {40, 0.25}, {120, 0.45}, {350, 0.55}, {700, 0.64}, {1000, 0.70}, {1300, 0.70}}};
// From a mouth uphill.
constexpr std::array<Station, 6> k_bed{{{0, 0.23}, {60, 0.42}, {150, 0.52}, {500, 0.64}, {800, 0.70}, {1100, 0.70}}};
// From the fan's toe to its apex: 8 to 12 degrees.
constexpr std::array<Station, 3> k_cone{{{0, 0.12}, {40, 0.14}, {k_fan_length, 0.21}}};

struct Gully {
    double mouth, lean_uphill, lean_on_fan;  ///< easting [m]; easting per metre uphill
    unsigned seed;
};
constexpr Gully k_gullies[k_fan_gullies] = {{555, -0.13, 0.24, 811}, {650, 0.16, -0.20, 823}};

/// Depth of a gully's bed below the mountain side [m].
double incision(double distance) {
    constexpr double k_deepest = 24;
    const double most = k_deepest * (1 - 0.8 * smooth_step(780, 1150, distance));
    return std::clamp(rise(k_side, distance) - k_apex_height - rise(k_bed, distance - k_mouth), 0.0, most);
}

/// Height of one gully's cone above the floor [m]; negative beyond its toe.
double cone(const Gully& gully, Point p, double distance) {
    constexpr double k_narrow = 1.8;  // a fan between mountain sides is longer than wide
    const double away = std::hypot(k_narrow * (p.x - gully.mouth), std::min(0.0, distance - k_mouth)) +
                        12 * noise(p.x / 90, p.y / 90, gully.seed + 2);
    return away < k_fan_length ? k_apex_height * rise(k_cone, k_fan_length - away) / rise(k_cone, k_fan_length) : -1;
}

}  // namespace

GridSpec fan_grid() {
    return {604200, 5142900, 5, 240, 306, ""};
}

double fan_foot(double x) {
    return 300 + 30 * noise(x / 260, 0.5, 801);
}

double gully_line(int gully, double distance) {
    const Gully& one = k_gullies[gully];
    const double from_mouth = distance - k_mouth, grown = smooth_step(0, 200, from_mouth);
    return one.mouth + (from_mouth > 0 ? one.lean_uphill : -one.lean_on_fan) * from_mouth +
           grown * (26 * noise(distance / 190, 0.37, one.seed) + 8 * noise(distance / 60, 0.71, one.seed + 1)) +
           6 * noise(distance / 80, 0.21, one.seed + 3);
}

double fan_height(Point p) {
    const double distance = p.y - fan_foot(p.x) + 8 * noise(p.x / 60, p.y / 90, 839);
    double height = k_floor + 0.03 * p.y + 0.004 * (k_middle - p.x) + rise(k_side, std::max(0.0, distance));
    // Weathered relief grows uphill; a floor of meadows has little.
    const double grown = smooth_step(20, 220, distance);
    const double bent = p.x + 40 * noise(p.x / 220, p.y / 220, 853);
    height += grown * (9 * fractal(bent / 300, p.y / 420, 857, 3, 0.45) +
                       7 * (ridged(bent / 80, p.y / 200, 859, 3, 0.5) - 0.72)) +
              (0.15 + 0.6 * grown) * fractal(p.x / 30, p.y / 38, 863, 3, 0.5);
    // Where gullies meet, the deeper one counts, and where cones do, the higher one.
    double deepest = 0, highest = -1, channel = 0;
    for (int g = 0; g < k_fan_gullies; ++g) {
        const double aside = std::abs(p.x - gully_line(g, distance));
        if (distance > 0) {  // a V rounded at the bottom
            const double a = aside / 30;
            deepest = std::max(deepest, incision(distance) * std::exp(0.25 - std::sqrt(a * a + 0.0625)));
        }
        highest = std::max(highest, cone(k_gullies[g], p, distance));
        // The torrent's bed on the fan: deep at the mouth, none at two thirds of the way to the toe.
        channel = std::max(channel, 2.2 * smooth_step(-40, 160, distance) * (1 - smooth_step(k_mouth, 320, distance)) *
                                        (1 - smooth_step(4, 14, aside)));
    }
    const double ground =
        k_floor + 0.03 * p.y + 0.004 * (k_middle - p.x) + highest + 0.25 * fractal(p.x / 24, p.y / 30, 877, 3, 0.5);
    return std::max(height - deepest, highest > 0 ? ground : height - deepest) - channel;
}

}  // namespace frana::sample
