// SPDX-License-Identifier: Apache-2.0
#include "bench/stability/usual_slide.h"

#include <cmath>

namespace frana::bench {
namespace {

constexpr double k_heap_radius = 15, k_heap_deep = 3;
constexpr Point k_heap_middle{30, 40};

}  // namespace

double usual_slope(Point place) {
    return place.x < 80 ? 0.5 * (80 - place.x) : 0;
}

double usual_cap(Point place) {
    const double x = place.x - k_heap_middle.x, y = place.y - k_heap_middle.y;
    return k_heap_deep * (1 - (x * x + y * y) / (k_heap_radius * k_heap_radius));
}

Setup usual_slide_on(const Variant& variant, double cell_size, const std::function<double(Point)>& bed) {
    Setup setup;
    cell_size *= variant.cells;
    setup.bed = sample_raster(plain_grid(std::llround(160 / cell_size), std::llround(80 / cell_size), cell_size), bed);
    setup.seeds = fill_lattice(setup.bed.grid, 2, 0, [](Point p) { return Seed{usual_cap(p)}; });
    setup.material = voellmy(15, 500);
    setup.material.density = 2000;
    setup.numerics = numerics_of(variant.scheme, SlopeCorrection::normal, Boundary::open);
    return setup;
}

Setup usual_slide(const Variant& variant) {
    return usual_slide_on(variant, 2, usual_slope);
}

HardCase slide_on(const char* name, const char* what, double end, const Surface& bed, const Change& change,
                  double cell) {
    return {name, what, end, [=](const Variant& variant) {
                Setup setup = usual_slide_on(variant, cell, bed);
                if (change) change(setup);
                return setup;
            }};
}

HardCase slide(const char* name, const char* what, double end, const Change& change) {
    return slide_on(name, what, end, usual_slope, change);
}

HardCase of(HardCase one, unsigned variants, unsigned figures, std::function<Figure(const Setup&, TimedFlow&)> own) {
    one.variants = variants;
    one.figures = figures;
    one.own = std::move(own);
    return one;
}

Change seeded(const std::function<Seed(Point)>& state) {
    return [=](Setup& setup) { setup.seeds = fill_lattice(setup.bed.grid, 2, 0, state); };
}

Change both(const Change& first, const Change& second) {
    return [=](Setup& setup) {
        first(setup);
        second(setup);
    };
}

void as_water(Setup& setup) {
    setup.material = water();
}

void walled(Setup& setup) {
    setup.numerics.boundary = Boundary::wall;
}

}  // namespace frana::bench
