// SPDX-License-Identifier: Apache-2.0
#include "sample_data/bindo_landslide.h"

#include <cmath>
#include <numbers>

namespace frana::sample {
namespace {

constexpr Point k_middle{742, 898};  // local metres
constexpr double k_half_length = 201, k_half_width = 99;
constexpr double k_lean = 0.09;  // angle of the axis from north to the east, uphill
constexpr int k_rim_points = 120;

/// Returns the distance from the middle to the edge [m] at an angle from the uphill axis: egg-shaped, blunt below,
/// slightly irregular.
double rim_distance(double angle) {
    const double along = std::cos(angle) / k_half_length, across = std::sin(angle) / k_half_width;
    const double ellipse = 1 / std::sqrt(along * along + across * across);
    return ellipse *
           (1 - 0.045 * std::cos(angle) + 0.030 * std::sin(2 * angle + 0.4) + 0.026 * std::sin(3 * angle + 1.9) +
            0.018 * std::sin(5 * angle + 0.7) + 0.013 * std::sin(9 * angle + 2.2) + 0.009 * std::sin(14 * angle + 4.1));
}

double angle_of(Point local) {
    return std::atan2(local.x - k_middle.x, local.y - k_middle.y) - k_lean;
}

/// Half the squared edge distance summed over all angles: the area inside [m2].
double rim_area() {
    constexpr int k_steps = 3600;
    double sum = 0;
    for (int i = 0; i < k_steps; ++i) {
        const double r = rim_distance(2 * std::numbers::pi * (i + 0.5) / k_steps);
        sum += 0.5 * r * r;
    }
    return sum * 2 * std::numbers::pi / k_steps;
}

}  // namespace

GridSpec bindo_grid() {
    return {528700, 5094800, 5, 300, 270, ""};
}

double release_radius(Point local) {
    const double distance = std::hypot(local.x - k_middle.x, local.y - k_middle.y);
    return distance == 0 ? 0 : distance / rim_distance(angle_of(local));
}

double release_thickness(Point local) {
    const double r = release_radius(local);
    if (r >= 1) return 0;
    // A bowl T (1 - r^2)^p over an outline of area A has the volume T A / (p + 1): p follows from the volume.
    static const double power = k_release_thickest * rim_area() / k_release_volume - 1;
    return k_release_thickest * std::pow(1 - r * r, power);
}

Ring release_rim() {
    Ring rim;
    for (int i = 0; i < k_rim_points; ++i) {
        const double angle = -2 * std::numbers::pi * i / k_rim_points;
        const double r = rim_distance(angle);
        rim.push_back({k_middle.x + r * std::sin(angle + k_lean), k_middle.y + r * std::cos(angle + k_lean)});
    }
    return rim;
}

Ring scar_outline() {
    // Northing, western and eastern edge at stations from the crown to the toe, as mapped from an orthophoto.
    struct Station {
        double y, west, east;
    };
    static const Station stations[] = {
        {1112, 750, 777}, {1101, 729, 799}, {1083, 705, 818}, {1057, 689, 833}, {1031, 677, 838}, {1002, 664, 843},
        {974, 657, 848},  {947, 648, 846},  {918, 641, 845},  {889, 636, 847},  {861, 640, 841},  {832, 631, 834},
        {803, 627, 833},  {776, 622, 823},  {748, 618, 826},  {721, 622, 819},  {694, 617, 808},  {667, 624, 802},
        {641, 631, 789},  {617, 646, 778},  {598, 665, 757},  {586, 690, 731}};
    Ring outline;
    for (const Station& station : stations) outline.push_back({station.west, station.y});
    for (std::size_t i = std::size(stations); i-- > 0;) outline.push_back({stations[i].east, stations[i].y});
    return outline;
}

}  // namespace frana::sample
