// SPDX-License-Identifier: Apache-2.0

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "models/structured/solid/solid_laws.h"
#include "mpm/curvature.h"
#include "simulation/flow.h"
#include "simulation/plane_stress.h"
#include "simulation/structured_flow.h"

namespace frana {
namespace {

// Elevation of the bed between the nodes' centres, and its slope in the cell as in the rasters of speed.
struct LocalGround {
    double height = 0;
    Point slope;
};

LocalGround ground_under(const NodeGrid& nodes, double x, double y) {
    const double dx = nodes.cell_size();
    x -= nodes.bounds().west;
    y -= nodes.bounds().south;
    const auto cell = [&](double place, std::int64_t count) {
        return std::clamp<std::int64_t>(static_cast<std::int64_t>(std::floor(place / dx)), 0, count - 1);
    };
    const auto bed = [&](std::int64_t i, std::int64_t j) { return nodes.bed[nodes.index(i, j)]; };
    const std::int64_t column = cell(x, nodes.columns()), row = cell(y, nodes.rows());
    LocalGround ground;
    ground.slope = {(bed(column + 1, row) - bed(column - 1, row)) / (2 * dx),
                    (bed(column, row + 1) - bed(column, row - 1)) / (2 * dx)};
    const double s = x / dx - 0.5, t = y / dx - 0.5;
    const auto i = std::clamp<std::int64_t>(static_cast<std::int64_t>(std::floor(s)), -1, nodes.columns() - 1);
    const auto j = std::clamp<std::int64_t>(static_cast<std::int64_t>(std::floor(t)), -1, nodes.rows() - 1);
    const double a = s - static_cast<double>(i), b = t - static_cast<double>(j);
    ground.height = nodes.datum() + (1 - a) * (1 - b) * bed(i, j) + a * (1 - b) * bed(i + 1, j) +
                    (1 - a) * b * bed(i, j + 1) + a * b * bed(i + 1, j + 1);
    return ground;
}

double speed_on(Point slope, Point v, bool metric) {
    return metric ? AlongBed{slope.x, slope.y}.speed(v) : std::hypot(v.x, v.y);
}

// Columns common to particles of both models.
// @param velocity of a particle in map view
// @param speed along the bed, from its number, that velocity and the ground's slope
template <class Velocity, class Speed>
PointTable common_table(const ParticleSet& particles, const GridSpec& grid, const NodeGrid& nodes,
                        const Velocity& velocity, const Speed& speed) {
    PointTable table;
    const std::size_t count = particles.size();
    table.places.reserve(count);
    const double* const x = particles[Field::x];
    const double* const y = particles[Field::y];
    for (std::size_t p = 0; p < count; ++p) table.places.push_back(grid.map_from_local({x[p], y[p]}));
    for (const char* name : {"depth_m", "bed_m", "speed_ms", "velocity_x_ms", "velocity_y_ms", "volume_m3"})
        table.add(name);
    const double* const confined = particles[Field::confined];
    for (std::size_t p = 0; p < count; ++p) {
        const LocalGround ground = ground_under(nodes, x[p], y[p]);
        const auto [u, v] = velocity(p);
        const double volume = particles[Field::volume][p] + (confined != nullptr ? confined[p] : 0);
        const double values[] = {
            volume / particles[Field::area][p], ground.height, speed(p, Point{u, v}, ground.slope), u, v, volume};
        for (std::size_t c = 0; c < std::size(values); ++c) table.columns[c].values[p] = values[c];
    }
    return table;
}

}  // namespace

double greatest_strain(const ParticleSet& particles, std::size_t p) {
    const Eigen::Matrix2d strain =
        structured::symmetric(particles[Field::e_xx][p], particles[Field::e_yy][p], particles[Field::e_xy][p]);
    const auto principal =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>().computeDirect(strain, Eigen::EigenvaluesOnly);
    return principal.eigenvalues().cwiseAbs().maxCoeff();
}

PointTable Flow::particle_table() const {
    PointTable table = common_table(
        particles(), grid_, nodes(), [&](std::size_t p) { return map_velocity(p); },
        [&](std::size_t p, Point v, Point slope) {
            // The stored speed along the bed: at an edge the velocity in map view and the slope there do not match.
            return follows_bed() ? std::hypot(particles()[Field::u][p], particles()[Field::v][p])
                                 : speed_on(slope, v, metric());
        });
    if (const double* const pore = particles()[Field::pore_pressure])
        std::copy_n(pore, particles().size(), table.add("pore_pressure_ratio").begin());
    return table;
}

std::vector<NamedRaster> Flow::plane_stress(const Raster& depth, PointTable& table) {
    const ParticleSet& p = particles();
    const auto add = [&](const char* name, const double* sigma) {
        std::vector<double>& values = table.add(name);
        for (std::size_t i = 0; i < values.size(); ++i)
            values[i] = plane_stress_kpa(density(), laws_.gravity, p[Field::volume][i] / p[Field::area][i],
                                         sigma != nullptr ? sigma[i] : 0);
    };
    if (!table.places.empty()) {
        add("plane_stress_xx_kpa", p[Field::s_xx]);
        add("plane_stress_yy_kpa", p[Field::s_yy]);
    }
    const NodalFields fields = nodal_fields();
    Raster u = fields.momentum_x, v = fields.momentum_y;
    fields.depth.values.for_each_stored([&](std::size_t cell, double h) {
        for (Raster* one : {&u, &v}) one->values[cell] = h > 0 ? one->values[cell] / h : 0;
    });
    return plane_stress_rasters(laws_.stress, density(), laws_.gravity, depth, u, v);
}

PointTable StructuredFlow::particle_table() const {
    if (!state_.solid) return {};
    const ParticleSet& particles = state_.solid->particles;
    PointTable table = common_table(
        particles, grid_, nodes(),
        [&](std::size_t p) {
            return Point{particles[Field::u][p], particles[Field::v][p]};
        },
        [&](std::size_t, Point v, Point slope) { return speed_on(slope, v, laws_.fluid.steep); });
    const std::size_t count = particles.size();
    const auto fill = [&](const char* name, const auto& value) {
        std::vector<double>& values = table.add(name);
        for (std::size_t p = 0; p < count; ++p) values[p] = value(p);
    };
    const auto copy = [&](const char* name, Field field, double unit) {
        if (particles[field] != nullptr) fill(name, [&](std::size_t p) { return unit * particles[field][p]; });
    };
    constexpr double k_kpa = 1e-3;
    copy("confined_fluid_m3", Field::confined, 1);
    copy("pore_pressure_ratio", Field::pore_pressure, 1);
    copy("stress_xx_kpa", Field::t_xx, k_kpa);
    copy("stress_yy_kpa", Field::t_yy, k_kpa);
    copy("stress_zz_kpa", Field::t_zz, k_kpa);
    copy("stress_xy_kpa", Field::t_xy, k_kpa);
    const auto stress = [&](std::size_t p) {
        return structured::Stress{
            structured::symmetric(particles[Field::t_xx][p], particles[Field::t_yy][p], particles[Field::t_xy][p]),
            particles[Field::t_zz][p]};
    };
    fill("mean_stress_kpa", [&](std::size_t p) { return k_kpa * stress(p).i1() / 3; });
    fill("shear_stress_kpa", [&](std::size_t p) { return k_kpa * std::sqrt(stress(p).j2()); });
    fill("strain", [&](std::size_t p) { return greatest_strain(particles, p); });
    copy("strain_xx", Field::e_xx, 1);
    copy("strain_yy", Field::e_yy, 1);
    copy("strain_xy", Field::e_xy, 1);
    const double* const ratio = particles[Field::cohesion_ratio];
    if (ratio == nullptr) return table;
    copy("cohesion_ratio", Field::cohesion_ratio, 1);
    fill("fractured_fraction", [&](std::size_t p) { return 1 - ratio[p]; });
    return table;
}

}  // namespace frana
