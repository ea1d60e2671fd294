// SPDX-License-Identifier: Apache-2.0
#include "sample_data/bindo_terrain.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "sample_data/relief.h"

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
    struct Width {
        double y, west, east;
    };
    static const Width stations[] = {
        {1112, 750, 777}, {1101, 729, 799}, {1083, 705, 818}, {1057, 689, 833}, {1031, 677, 838}, {1002, 664, 843},
        {974, 657, 848},  {947, 648, 846},  {918, 641, 845},  {889, 636, 847},  {861, 640, 841},  {832, 631, 834},
        {803, 627, 833},  {776, 622, 823},  {748, 618, 826},  {721, 622, 819},  {694, 617, 808},  {667, 624, 802},
        {641, 631, 789},  {617, 646, 778},  {598, 665, 757},  {586, 690, 731}};
    Ring outline;
    for (const Width& station : stations) outline.push_back({station.west, station.y});
    for (std::size_t i = std::size(stations); i-- > 0;) outline.push_back({stations[i].east, stations[i].y});
    return outline;
}

namespace {

constexpr double k_river_height = 478;  // where it enters in the west [m]
constexpr double k_valley_edge = 60;    // gullies that begin here reach the valley and have fans
constexpr double k_river_gradient = 0.013;

// Flat by the river, a concave foot, steepest in the middle, gentler towards the shoulder: 28 degrees on average.
constexpr std::array<Station, 11> k_north_side{{{0, 0.00},
                                                {34, 0.01},
                                                {58, 0.12},
                                                {105, 0.34},
                                                {180, 0.48},
                                                {280, 0.58},
                                                {400, 0.64},
                                                {540, 0.67},
                                                {690, 0.62},
                                                {850, 0.47},
                                                {1100, 0.34}}};
constexpr std::array<Station, 6> k_south_side{
    {{0, 0.00}, {28, 0.01}, {46, 0.14}, {90, 0.34}, {180, 0.46}, {420, 0.52}}};

/// Northing of the valley's middle; the river meanders about it.
double valley_axis(double x) {
    return 272 + 58 * noise(x / 560, 0.5, 701) + 20 * noise(x / 230, 0.5, 709) + 0.035 * (x - 750);
}

/// A gully on the northern hillside: its path, depth, width, and its range of distances from the river.
struct Gully {
    double x, drift, depth, width, from, to;
    unsigned seed;
};

constexpr std::array<Gully, 9> k_gullies{{{1085, -0.16, 26, 34, 60, 1150, 501},
                                          {1002, 0.13, 10, 17, 420, 900, 507},
                                          {388, 0.10, 22, 30, 60, 1150, 521},
                                          {470, -0.22, 11, 18, 330, 1000, 533},
                                          {150, 0.12, 17, 26, 60, 960, 541},
                                          {1345, -0.08, 19, 28, 60, 1010, 557},
                                          {1252, 0.20, 8, 15, 300, 820, 563},
                                          {262, -0.18, 7, 14, 280, 760, 569},
                                          {905, 0.05, 7, 15, 90, 560, 577}}};

double incision(const Gully& gully, double x, double distance) {
    const double along =
        smooth_step(gully.from, gully.from + 160, distance) * (1 - smooth_step(gully.to - 420, gully.to, distance));
    if (along <= 0) return 0;
    const double middle = gully.x + gully.drift * (distance - 500) + 34 * noise(distance / 170, 0.37, gully.seed) +
                          11 * noise(distance / 55, 0.71, gully.seed + 1);
    const double aside = std::abs(x - middle) / (gully.width * (0.7 + 0.5 * along));
    // A V rounded at the bottom, with shoulders that merge with the slope.
    return gully.depth * along * std::exp(0.25 - std::sqrt(aside * aside + 0.0625));
}

/// An old slide close to failure: its foot bulges, its head has subsided.
double slide_body(Point local) {
    const double r = release_radius(local);
    if (r >= 1.25) return 0;
    const double inside = 1 - smooth_step(0.15, 1.25, r);
    const double lower = smooth_step(1010, 830, local.y) - smooth_step(950, 1080, local.y);
    return inside * (7 * lower + 5);
}

double hillside_relief(Point p, double distance) {
    const double grown = smooth_step(45, 260, distance);
    // Distorting the coordinates first prevents crests and hollows from following a lattice.
    const double bent_x = p.x + 60 * noise(p.x / 310, p.y / 310, 611),
                 bent_y = p.y + 60 * noise(p.x / 310, p.y / 310, 613);
    const double broad = 22 * fractal(bent_x / 420, bent_y / 560, 617, 3, 0.45);
    // Crags run down the slope, so the noise is stretched in that direction.
    const double crags = 9 * (ridged(bent_x / 85, bent_y / 210, 631, 4, 0.5) - 0.72);
    const double rough = 1.3 * fractal(p.x / 34, p.y / 44, 641, 4, 0.55);
    const double calm = 1 - 0.75 * (1 - smooth_step(0.7, 1.6, release_radius(p)));  // the old slide is smoother
    return grown * (broad + calm * (crags + rough));
}

double other_bank_relief(Point p, double distance) {
    const double grown = smooth_step(40, 210, distance);
    const double bent_x = p.x + 45 * noise(p.x / 190, p.y / 190, 653);
    const double spurs = 26 * (ridged(bent_x / 240, p.y / 700, 659, 2, 0.4) - 0.75);
    const double furrows = 7 * (ridged(bent_x / 70, p.y / 190, 677, 3, 0.5) - 0.72);
    return grown * (12 * fractal(p.x / 330, p.y / 330, 661, 3, 0.45) + spurs + furrows +
                    1.1 * fractal(p.x / 30, p.y / 30, 683, 3, 0.55));
}

/// Material from the gullies: cones at their mouths, on the flat and up the slope.
double fan(const Gully& gully, Point p) {
    const double mouth_x = gully.x + gully.drift * (110 - 500) + 34 * noise(110.0 / 170, 0.37, gully.seed) +
                           11 * noise(110.0 / 55, 0.71, gully.seed + 1);
    const double reach = 3.4 * gully.width + 10;
    const double away = std::hypot(0.8 * (p.x - mouth_x), p.y - valley_axis(mouth_x) - 92) +
                        7 * noise(p.x / 30, p.y / 30, gully.seed + 2);
    return 0.11 * reach * smooth_step(1, 0, away / reach);
}

/// The flat by the river: terraces and old arms, with the meandering bed.
double valley_floor(Point p, double distance) {
    const double from_river = std::abs(p.y - river_line(p.x));
    const double floor = 1 - smooth_step(34, 95, std::abs(distance));
    const double arms = 1.1 * fractal(p.x / 120, p.y / 34, 673, 3, 0.5);
    const double terrace = 1.8 * smooth_step(15, 22, from_river + 9 * noise(p.x / 60, p.y / 40, 691));
    const double bed = -2.4 * (1 - smooth_step(4, 12, from_river));
    return bed + floor * (terrace + arms * smooth_step(8, 20, from_river));
}

}  // namespace

double river_line(double x) {
    return valley_axis(x) + 24 * noise(x / 150, 0.5, 719) + 9 * noise(x / 62, 0.5, 727);
}

double bindo_height(Point p) {
    // The slope's foot is irregular by some tens of metres.
    const double distance = p.y - valley_axis(p.x) + 20 * noise(p.x / 130, p.y / 260, 739);
    const double river = k_river_height - k_river_gradient * p.x;
    const double height = river + valley_floor(p, distance);
    if (distance < 0) return height + rise(k_south_side, -distance) + other_bank_relief(p, -distance);
    // Where gullies meet, the deeper one counts, and where fans do, the higher one; sums would give pits and mounds.
    double deepest = 0, highest = 0;
    for (const Gully& gully : k_gullies) {
        deepest = std::max(deepest, incision(gully, p.x, distance));
        if (gully.from <= k_valley_edge) highest = std::max(highest, fan(gully, p));
    }
    return height + rise(k_north_side, distance) + hillside_relief(p, distance) + slide_body(p) - deepest + highest;
}

}  // namespace frana::sample
