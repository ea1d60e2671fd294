// SPDX-License-Identifier: Apache-2.0
#include "bench/stability/stability.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "analysis/energy_line.h"
#include "params/keys/laws.h"
#include "simulation/run_warnings.h"
#include "simulation/stepped_run.h"

namespace frana::bench {
namespace {

constexpr double k_volume_limit = 1e-12;  // rounding of sums over some 1e5 particles

// Limits of the figures of every case, each for a reason that has nothing to do with the values found.
// The mean way of the fastest in a step, over the Courant number: material that particles move may go 5/4 of it
// (StepBounds); waves here go as on level ground, on 25 degrees faster by 1 / cos^3 = 1.34.
constexpr double k_courant_limit = 1.35;
// The order of sums differs in the mirror: their rounding, 1e-16, grows in cells with their number, among particles
// with the gradients of the flow. Where all rows of particles are alike, rounding decides which of them split and
// merge.
constexpr double k_mirror_of_cells = 1e-12, k_mirror_of_particles = 1e-6, k_mirror_of_ties = 1e-2;
// Solids yield or hold by comparisons, whose outcome rounding decides for single ones, but not for the whole [cells].
constexpr double k_mirror_of_solids = 0.1;
// Fronts and turns are of first order: from cells to half of them changes by half of the error. Accepted is an error of
// a cell and a tenth of the way.
constexpr double k_cell_limit = 1, k_way_limit = 0.05;
// What a basin holds does not depend on its cells.
constexpr double k_trap_limit = 0.05;

Setup set_up(const HardCase& one, const Variant& variant) {
    Setup setup = one.make(variant);
    if (!variant.structured || setup.structured) return setup;
    // Water, or with friction debris of grains and water.
    StructuredMaterial& of = setup.structured.emplace();
    of.friction = of.bed_friction = friction_coefficient_of(setup.material).value_or(0);
    of.solids = of.friction > 0;
    if (!of.solids) of.manning = 0;
    of.solid_fraction = 0.6;
    return setup;
}

// Where the volume of a flow is.
struct Places {
    double x = 0, y = 0;  // middle [m]
    double reach = 0;     // distance from the middle of the release within which 99 % lies [m]
    double trapped = 0;   // [m3]
    Point from;           // middle of the release [m]
};

Places places_of(const Raster& depth, const ParticleSet& seeds, const std::function<bool(Point)>& trap) {
    Places places;
    Point& from = places.from;
    double all = 0;
    for (std::size_t p = 0; p < seeds.size(); ++p) {
        const double volume = seeds[Field::volume][p];
        from.x += volume * seeds[Field::x][p];
        from.y += volume * seeds[Field::y][p];
        all += volume;
    }
    from = {from.x / all, from.y / all};
    const GridSpec& grid = depth.grid;
    std::vector<std::pair<double, double>> by_distance;
    double inside = 0;
    for (std::int64_t row = 0; row < grid.rows; ++row) {
        for (std::int64_t column = 0; column < grid.columns; ++column) {
            const double volume = depth.at(row, column) * grid.cell_area();
            if (!(volume > 0)) continue;
            const Point at = grid.local_from_map(grid.cell_centre(row, column));
            places.x += volume * at.x;
            places.y += volume * at.y;
            inside += volume;
            if (trap && trap(at)) places.trapped += volume;
            by_distance.emplace_back(std::hypot(at.x - from.x, at.y - from.y), volume);
        }
    }
    if (!(inside > 0)) return places;
    places.x /= inside;
    places.y /= inside;
    std::sort(by_distance.begin(), by_distance.end());
    double nearer = 0;
    for (const auto& [distance, volume] : by_distance) {
        if (nearer < 0.99 * inside) places.reach = distance;
        nearer += volume;
    }
    return places;
}

void add_mirror(const HardCase& one, const Variant& variant, const Setup& setup, TimedFlow& run, int threads,
                StabilityRow& row) {
    const bool particles = run.model().particle_set() != nullptr, solids = particles && variant.structured;
    const Raster depth = run.fields().depth;
    const double cell = setup.bed.grid.cell_size;
    double apart = 0;
    for (const bool swaps_west : {false, true}) {
        TimedFlow mirror(mirrored(setup, swaps_west), threads);
        mirror.advance_to(one.end);
        const Raster back = mirrored(mirror.fields().depth, swaps_west);
        const Places here = places_of(depth, setup.seeds, {}), there = places_of(back, setup.seeds, {});
        apart =
            std::max(apart, solids ? std::hypot(here.x - there.x, here.y - there.y) / cell : elsewhere(depth, back));
    }
    const double limit = solids                 ? k_mirror_of_solids
                         : !particles           ? k_mirror_of_cells
                         : one.figures & k_ties ? k_mirror_of_ties
                                                : k_mirror_of_particles;
    row.figures.push_back({solids ? "middle in the mirror [cells]" : "volume elsewhere in the mirror", apart, limit});
}

void add_cells(const HardCase& one, Variant variant, const Setup& setup, TimedFlow& run, int threads,
               StabilityRow& row) {
    variant.cells = 0.5;
    const Setup half = set_up(one, variant);
    TimedFlow finer(half, threads);
    finer.advance_to(one.end);
    const Places a = places_of(run.fields().depth, setup.seeds, one.trap),
                 b = places_of(finer.fields().depth, half.seeds, one.trap);
    const double cell = setup.bed.grid.cell_size;
    if (one.trap) {
        row.figures.push_back(
            {"trapped volume on half the cells, relative", std::abs(a.trapped / b.trapped - 1), k_trap_limit});
    } else {
        const auto add = [&](const char* name, double apart, double way) {
            row.figures.push_back({name, apart / cell, k_cell_limit + k_way_limit * way / cell});
        };
        add("middle on half the cells [cells]", std::hypot(a.x - b.x, a.y - b.y),
            std::hypot(b.x - b.from.x, b.y - b.from.y));
        add("run-out on half the cells [cells]", std::abs(a.reach - b.reach), b.reach);
    }
}

std::string line_of(const StabilityRow& row) {
    char line[400];
    const Figure &first = row.figures.front(), &nearest = row.nearest();
    std::snprintf(line, sizeof line,
                  "%-18s %-13s %-6s %-46s %10.3g of %-6g  nearest: %.3g of %g, %s; %lld particles, %lld steps, %.2f s",
                  row.case_name.c_str(), row.scheme.c_str(), row.passed ? "passed" : "FAILED", first.name.c_str(),
                  first.value, first.limit, nearest.value, nearest.limit, nearest.name.c_str(),
                  static_cast<long long>(row.sound.particles), static_cast<long long>(row.sound.steps),
                  row.sound.wall_seconds);
    return line;
}

const Figure& most_used(const std::vector<Figure>& figures, std::size_t from) {
    return *std::max_element(figures.begin() + static_cast<std::ptrdiff_t>(from), figures.end(),
                             [](const Figure& a, const Figure& b) { return a.used() < b.used(); });
}

}  // namespace

StabilityRow run_case(const HardCase& one, const Variant& variant, int threads) {
    StabilityRow row{one.name, one.what, variant.word(), false, {}, {}};
    const Setup setup = set_up(one, variant);
    TimedFlow run(setup, threads);
    const Soundness& s = row.sound = watch(run, setup, one.end);
    if (one.own) row.figures.push_back(one.own(setup, run));
    row.figures.push_back({"speed over the highest possible", s.speed_ratio, 1});
    if (!variant.structured && (one.figures & k_energy))
        row.figures.push_back({"energy rise, of the work of gravity", s.energy_rise, k_energy_error});
    row.figures.push_back({"above the energy line, of the fall", s.above_line, k_line_error});
    row.figures.push_back({"volume error", s.volume_error, k_volume_limit});
    row.figures.push_back({"non-finite values", static_cast<double>(s.non_finite), 0});
    row.figures.push_back({"way of a wave in a step, of the Courant number",
                           s.courant / courant_number(setup.numerics, setup.material), k_courant_limit});
    // Water between grains at rest still flows.
    const bool grains = setup.structured && setup.structured->solids;
    if ((one.figures & k_rest) && !grains)
        row.figures.push_back({"speed at the end [m/s]", s.last_speed, StillWatch::k_crawl});
    if (one.figures & k_mirror) add_mirror(one, variant, setup, run, threads, row);
    if (one.figures & k_cells) add_cells(one, variant, setup, run, threads, row);
    row.passed = row.good();
    return row;
}

bool StabilityRow::good() const {
    return std::all_of(figures.begin(), figures.end(), [](const Figure& f) { return f.within(); });
}

const Figure& StabilityRow::nearest() const {
    return most_used(figures, 0);
}

const Figure& StabilityRow::second() const {
    return most_used(figures, 1);
}

std::vector<HardCase> hard_cases() {
    std::vector<HardCase> all;
    for (auto* make : {hard_terrain_cases, hard_release_cases, hard_material_cases, hard_numerics_cases})
        for (HardCase& one : make()) all.push_back(std::move(one));
    return all;
}

std::vector<StabilityRow> run_stability(const StabilityOptions& options) {
    std::vector<StabilityRow> rows;
    constexpr std::pair<unsigned, Variant> k_variants[] = {
        {k_particles, {}}, {k_volumes, {Scheme::finite_volume}}, {k_structured, {Scheme::finite_volume, true}}};
    for (const HardCase& one : choose(hard_cases(), options.only, "stability")) {
        for (const auto& [flag, variant] : k_variants) {
            if (!(one.variants & flag)) continue;
            rows.push_back(run_case(one, variant, options.threads));
            if (options.report) options.report(line_of(rows.back()));
        }
    }
    return rows;
}

std::string stability_csv(const std::vector<StabilityRow>& rows) {
    std::string out = "case,scheme,passed,figure,limit,second_name,second_figure,second_limit\n";
    for (const StabilityRow& row : rows) {
        char line[240];
        const Figure &first = row.figures.front(), &second = row.second();
        std::snprintf(line, sizeof line, "%s,%s,%s,%.6g,%g,\"%s\",%.6g,%g\n", row.case_name.c_str(), row.scheme.c_str(),
                      row.passed ? "true" : "false", first.value, first.limit, second.name.c_str(), second.value,
                      second.limit);
        out += line;
    }
    return out;
}

std::string stability_table(const std::vector<StabilityRow>& rows) {
    std::string out;
    std::size_t passed = 0;
    for (const StabilityRow& row : rows) {
        out += line_of(row) + "\n";
        passed += row.passed ? 1 : 0;
    }
    char line[96];
    std::snprintf(line, sizeof line, "%zu of %zu hard cases passed\n", passed, rows.size());
    out += line;
    for (const StabilityRow& row : rows) {
        if (row.passed) continue;
        out += "  failed: " + row.case_name + " with scheme " + row.scheme + " (" + row.what + ")\n";
        for (const Figure& figure : row.figures) {
            char value[160];
            if (figure.within()) continue;
            std::snprintf(value, sizeof value, "    %s: %.4g of %g\n", figure.name.c_str(), figure.value, figure.limit);
            out += value;
        }
    }
    return out;
}

}  // namespace frana::bench
