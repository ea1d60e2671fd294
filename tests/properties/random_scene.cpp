// SPDX-License-Identifier: Apache-2.0
#include "random_scene.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "physics/laws.h"
#include "simulation/scene.h"

namespace frana::test {
namespace {

constexpr double k_degree = M_PI / 180;

double on_lattice(double value) {
    return std::round(value * 1024) / 1024;
}

GridSpec random_grid(RandomNumbers& random) {
    GridSpec grid;
    const double sizes[] = {2, 2.5, 4};
    grid.cell_size = sizes[random.below(3)];
    grid.columns = 36 + static_cast<std::int64_t>(random.below(20));
    grid.rows = 28 + static_cast<std::int64_t>(random.below(20));
    grid.west = 500000 + grid.cell_size * static_cast<double>(random.below(1000));
    grid.north = 5000000 + grid.cell_size * static_cast<double>(random.below(1000));
    return grid;
}

// A slope in any direction with humps, gullies and the roughness of a survey.
Raster random_terrain(RandomNumbers& random, const GridSpec& grid) {
    const double dx = grid.cell_size, size = dx * static_cast<double>(std::min(grid.columns, grid.rows));
    const double steepness = std::tan(random.between(0, 38) * k_degree), towards = random.between(0, 2 * M_PI);
    struct Hump {
        Point at;
        double height, radius;
    };
    std::vector<Hump> humps(random.below(6));
    for (Hump& hump : humps) {
        const double radius = random.between(3 * dx, 0.4 * size);
        hump = {{random.between(0, grid.east() - grid.west), random.between(0, grid.north - grid.south())},
                random.between(-0.5, 0.5) * radius,
                radius};
    }
    const double wave = random.once_in(2) ? random.between(0, 0.3) : 0, length = random.between(6 * dx, size);
    const double roughness = random.once_in(2) ? random.between(0, 0.05) * dx : 0;
    Raster terrain(grid);
    for (std::int64_t row = 0; row < grid.rows; ++row) {
        for (std::int64_t column = 0; column < grid.columns; ++column) {
            const Point p = grid.local_from_map(grid.cell_centre(row, column));
            double z = 1500 + steepness * (p.x * std::cos(towards) + p.y * std::sin(towards));
            z += wave * length / (2 * M_PI) * std::sin(2 * M_PI * (p.x + 0.3 * p.y) / length);
            for (const Hump& hump : humps) {
                const double r = std::hypot(p.x - hump.at.x, p.y - hump.at.y) / hump.radius;
                z += hump.height * std::exp(-r * r);
            }
            terrain.at(row, column) = z + roughness * random.between(-1, 1);
        }
    }
    return terrain;
}

// A star with three to nine corners; the middle is within the inner half of the grid.
Polygon random_star(RandomNumbers& random, const GridSpec& grid) {
    const double width = grid.east() - grid.west, height = grid.north - grid.south();
    const Point middle{grid.west + random.between(0.3, 0.7) * width, grid.south() + random.between(0.3, 0.7) * height};
    const double radius = random.between(0.08, 0.25) * std::min(width, height);
    const std::size_t corners = 3 + random.below(7);
    Polygon star;
    for (std::size_t k = 0; k < corners; ++k) {
        const double angle =
            2 * M_PI * (static_cast<double>(k) + random.between(0, 0.8)) / static_cast<double>(corners);
        const double r = radius * random.between(0.5, 1);
        star.outer.push_back({on_lattice(middle.x + r * std::cos(angle)), on_lattice(middle.y + r * std::sin(angle))});
    }
    return star;
}

Material random_material(RandomNumbers& random) {
    Material material;
    material.density = random.between(1200, 2500);
    material.of<CoulombFriction>().friction_coefficient = std::tan(random.between(3, 30) * k_degree);
    material.of<TurbulentFriction>().turbulence =
        random.once_in(3) ? material.of<TurbulentFriction>().turbulence : random.log_between(100, 3000);
    if (random.once_in(3)) {
        material.of<BinghamStress>().viscosity = random.log_between(10, 2000);
        material.of<BinghamStress>().yield_stress = random.log_between(10, 2000);
    }
    return material;
}

StructuredMaterial random_structured(RandomNumbers& random, bool solids) {
    StructuredMaterial m;
    m.solids = solids;
    m.manning = random.between(0.02, 0.12);
    m.fluid_viscosity = random.once_in(3) ? random.log_between(0.01, 50) : 0;
    if (!solids) return m;
    m.cohesion = random.once_in(2) ? 0 : random.log_between(500, 20000);
    m.friction = std::tan(random.between(15, 40) * k_degree);
    m.bed_friction = std::tan(random.between(5, 30) * k_degree);
    m.solid_fraction = random.between(0.4, 0.7);
    m.young_modulus = m.bulk_modulus = 2e5;  // softer than rock: fewer substeps
    return m;
}

int number_of(const char* name, int otherwise) {
    const char* const text = std::getenv(name);
    return text == nullptr ? otherwise : std::atoi(text);
}

}  // namespace

Scene random_scene(RandomNumbers& random, Made made) {
    Scene scene;
    scene.grid = random_grid(random);
    scene.terrain = random_terrain(random, scene.grid);
    ReleaseArea area;
    area.outline = {random_star(random, scene.grid)};
    area.thickness = random.between(0.5, 4);
    area.normal_to_bed = random.once_in(3);
    area.speed = random.once_in(4) ? random.between(0, 10) : 0;
    scene.release = {area};
    scene.numerics.cfl = random.between(0.3, 0.6);
    if (made == Made::of_mass) {
        scene.material = random_material(random);
        scene.numerics.particles_per_cell = random.once_in(3) ? 9 : 4;
        scene.numerics.curvature = random.once_in(4);
        if (random.once_in(4)) {
            scene.numerics.scheme = Scheme::paper;
            scene.numerics.slope_correction = SlopeCorrection::none;
            scene.numerics.curvature = false;
            // With 9 one is on every node, where the hat functions have a kink and their slope two values.
            scene.numerics.particles_per_cell = 4;
        }
        if (random.once_in(4)) {
            scene.entrainment.erosion = "growth";
            scene.entrainment.of<GrowthErosion>().growth_rate = random.log_between(1e-4, 1e-2);
            scene.entrainment.erodible_depth = random.between(0.1, 1);
        }
    } else {
        scene.structured = random_structured(random, made == Made::of_solids);
        scene.numerics.particles_per_cell = made == Made::of_solids ? 4 : 9;
    }
    scene.numerics.boundary = random.once_in(4) ? Boundary::wall : Boundary::open;
    scene.time.end = made == Made::of_solids ? 0.6 : random.between(1, 4);
    scene.time.moving_speed = 0.1;
    place_origin(scene);
    return scene;
}

Scene random_plane(RandomNumbers& random) {
    Scene scene;
    scene.grid = {0, 48, 2, 150, 24, {}};
    const double slope = std::tan(random.between(12, 30) * k_degree);
    scene.terrain = Raster(scene.grid);
    for (std::int64_t row = 0; row < scene.grid.rows; ++row) {
        for (std::int64_t column = 0; column < scene.grid.columns; ++column)
            scene.terrain.at(row, column) = 400 - slope * scene.grid.cell_centre(row, column).x;
    }
    ReleaseArea area;
    const double west = on_lattice(random.between(10, 20)), east = west + on_lattice(random.between(8, 20));
    const double south = on_lattice(random.between(10, 20)), north = south + on_lattice(random.between(8, 18));
    area.outline = {{{{west, south}, {east, south}, {east, north}, {west, north}}, {}}};
    area.thickness = random.between(0.5, 3);
    scene.release = {area};
    scene.material = random_material(random);
    scene.material.of<CoulombFriction>().friction_coefficient = 0;
    scene.time.end = 6;
    return scene;
}

int scene_count(int of_a_hundred) {
    return std::max(1, number_of("FRANA_SCENES", 100) * of_a_hundred / 100);
}

std::uint64_t scene_seed() {
    return static_cast<std::uint64_t>(number_of("FRANA_SEED", 1));
}

std::string scene_label(int scene) {
    return "FRANA_SEED=" + std::to_string(scene_seed()) + ", scene " + std::to_string(scene);
}

}  // namespace frana::test
