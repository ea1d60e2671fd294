// SPDX-License-Identifier: Apache-2.0
#include "bench/stability/stability.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "bench/set_up/setup.h"
#include "physics/laws.h"
#include "simulation/run_check.h"

namespace frana::bench {
namespace {

constexpr double k_heap_radius = 15, k_heap_deep = 3;
constexpr Point k_heap_middle{30, 40};

double speed_limit(const Setup& setup, double fastest) {
    double lowest = std::numeric_limits<double>::infinity();
    for (const double z : setup.bed.values)
        if (!std::isnan(z)) lowest = std::min(lowest, z);
    const GridSpec& grid = setup.bed.grid;
    double drop = 0, deepest = 0;
    const ParticleSet& seeds = setup.seeds;
    for (std::size_t p = 0; p < seeds.size(); ++p) {
        const auto column = static_cast<std::int64_t>(seeds[Field::x][p] / grid.cell_size);
        const auto row = grid.rows - 1 - static_cast<std::int64_t>(seeds[Field::y][p] / grid.cell_size);
        const double depth = seeds[Field::volume][p] / seeds[Field::area][p];
        deepest = std::max(deepest, depth);
        const double z = setup.bed.at(row, column);
        if (!std::isnan(z)) drop = std::max(drop, z + depth - lowest);
    }
    return speed_bound(k_gravity, drop, deepest, fastest);
}

std::int64_t count_non_finite(const ParticleSet& particles) {
    std::int64_t count = 0;
    for (std::size_t f = 0; f < k_fields; ++f) {
        const double* values = particles[static_cast<Field>(f)];
        if (values == nullptr) continue;
        for (std::size_t p = 0; p < particles.size(); ++p) count += std::isfinite(values[p]) ? 0 : 1;
    }
    return count;
}

}  // namespace

Soundness watch(TimedFlow& run, const Setup& setup, double end) {
    Soundness s;
    const Model& model = run.model();
    const double volume = model.volume();
    double fastest = 0;
    for (std::size_t p = 0; p < setup.seeds.size(); ++p)
        fastest = std::max(fastest, std::hypot(setup.seeds[Field::u][p], setup.seeds[Field::v][p]));
    const double limit = speed_limit(setup, fastest);
    run.advance_to(end, [&](const voellmy_bingham::StepReport& report) {
        s.speed_ratio = std::max({s.speed_ratio, report.particles.speeds.flow / limit, report.nodes.max_speed / limit});
        s.volume_error = std::max(s.volume_error, std::abs(model.volume() + model.volume_left() - volume) / volume);
        s.clamped += report.particles.clamped;
    });
    s.non_finite = run.non_finite() + count_non_finite(run.particles());
    s.particles = run.peak_particles();
    s.steps = model.steps();
    s.wall_seconds = run.seconds();
    return s;
}

void DepthAgreement::compare(TimedFlow& run) {
    const Raster depth = run.fields().depth;
    if (!first_) first_ = depth;
    for (std::size_t c = 0; c < depth.values.size(); ++c)
        greatest_ = std::max(greatest_, std::abs(depth.values[c] - first_->values[c]));
}

void merge(Soundness& into, const Soundness& other) {
    into.non_finite += other.non_finite;
    into.volume_error = std::max(into.volume_error, other.volume_error);
    into.speed_ratio = std::max(into.speed_ratio, other.speed_ratio);
    into.clamped += other.clamped;
    into.particles = std::max(into.particles, other.particles);
    into.steps += other.steps;
    into.wall_seconds += other.wall_seconds;
}

double usual_slope(Point place) {
    return place.x < 80 ? 0.5 * (80 - place.x) : 0;
}

double usual_cap(Point place) {
    const double x = place.x - k_heap_middle.x, y = place.y - k_heap_middle.y;
    return k_heap_deep * (1 - (x * x + y * y) / (k_heap_radius * k_heap_radius));
}

Setup usual_slide_on(double cell_size, const std::function<double(Point)>& bed) {
    Setup setup;
    setup.bed = sample_raster(plain_grid(std::llround(160 / cell_size), std::llround(80 / cell_size), cell_size), bed);
    setup.seeds = fill_lattice(setup.bed.grid, 2, 0, [](Point p) { return Seed{usual_cap(p)}; });
    setup.material = dry_friction(15);
    setup.material.density = 2000;
    setup.material.of<TurbulentFriction>().turbulence = 500;
    setup.numerics = numerics_of(Scheme::standard, SlopeCorrection::normal, Boundary::open);
    return setup;
}

Setup usual_slide() {
    return usual_slide_on(2, usual_slope);
}

namespace {

constexpr double k_volume_limit = 1e-12;  // rounding of sums over some 1e5 particles

StabilityRow run_case(const HardCase& one, Scheme scheme, int threads) {
    StabilityRow row{one.name, one.what, scheme, false, {}, {}};
    if (one.compare) {
        row.statistic = one.compare(scheme, threads, row.sound);
    } else {
        Setup setup = one.make();
        setup.numerics.scheme = scheme;
        TimedFlow run(setup, threads);
        row.sound = watch(run, setup, one.end);
        row.statistic = one.statistic
                            ? one.statistic(setup, run)
                            : StabilityStatistic{"speed over the highest possible speed", row.sound.speed_ratio, 1};
    }
    row.passed = row.sound.non_finite == 0 && row.sound.volume_error <= k_volume_limit && row.sound.speed_ratio <= 1 &&
                 row.statistic.value <= row.statistic.limit;
    return row;
}

std::string line_of(const StabilityRow& row) {
    char line[320];
    std::snprintf(line, sizeof line,
                  "%-18s %-13s %-6s %-48s %10.3g of %-6g  speed %.3f, volume %.1e, non-finite %lld, clamped %lld, "
                  "%lld particles, %lld steps, %.2f s",
                  row.case_name.c_str(), name_of(row.scheme), row.passed ? "passed" : "FAILED",
                  row.statistic.name.c_str(), row.statistic.value, row.statistic.limit, row.sound.speed_ratio,
                  row.sound.volume_error, static_cast<long long>(row.sound.non_finite),
                  static_cast<long long>(row.sound.clamped), static_cast<long long>(row.sound.particles),
                  static_cast<long long>(row.sound.steps), row.sound.wall_seconds);
    return line;
}

}  // namespace

std::vector<HardCase> hard_cases() {
    std::vector<HardCase> all;
    for (auto* make : {hard_terrain_cases, hard_release_cases, hard_material_cases, hard_numerics_cases})
        for (HardCase& one : make()) all.push_back(std::move(one));
    return all;
}

std::vector<StabilityRow> run_stability(const StabilityOptions& options) {
    std::vector<StabilityRow> rows;
    for (const HardCase& one : choose(hard_cases(), options.only, "stability")) {
        for (const Scheme scheme : {Scheme::standard, Scheme::finite_volume}) {
            if (one.of_particles && scheme == Scheme::finite_volume) continue;
            rows.push_back(run_case(one, scheme, options.threads));
            if (options.report) options.report(line_of(rows.back()));
        }
    }
    return rows;
}

std::string stability_csv(const std::vector<StabilityRow>& rows) {
    std::string out = "case,scheme,passed,figure,limit\n";
    for (const StabilityRow& row : rows) {
        char line[160];
        std::snprintf(line, sizeof line, "%s,%s,%s,%.6g,%g\n", row.case_name.c_str(), name_of(row.scheme),
                      row.passed ? "true" : "false", row.statistic.value, row.statistic.limit);
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
    for (const StabilityRow& row : rows)
        if (!row.passed)
            out += "  failed: " + row.case_name + " with scheme " + name_of(row.scheme) + " (" + row.what + ")\n";
    return out;
}

}  // namespace frana::bench
