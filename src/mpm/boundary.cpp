// SPDX-License-Identifier: Apache-2.0
#include "mpm/boundary.h"

#include <utility>

namespace frana {
namespace {

// Calls visit(ghost, inner, normal_is_x) for the pairs of the first ghost column and row on each side. Rows
// come after columns and span the ghost columns too, so corners are folded twice, once in each direction.
// A particle inside never touches ghosts of the second ring. Pairs on ground that was not read have nothing to mirror.
template <class Visit>
void for_each_mirror_pair(const NodeGrid& nodes, const Visit& visit) {
    const std::int64_t nx = nodes.columns(), ny = nodes.rows();
    nodes.for_each_covered_part(-1, ny + 1, 0, NodeGrid::Along::column,
                                [&](std::int64_t j) { visit(nodes.index(-1, j), nodes.index(0, j), true); });
    nodes.for_each_covered_part(-1, ny + 1, nx - 1, NodeGrid::Along::column,
                                [&](std::int64_t j) { visit(nodes.index(nx, j), nodes.index(nx - 1, j), true); });
    nodes.for_each_covered_part(-1, nx + 1, 0, NodeGrid::Along::row,
                                [&](std::int64_t i) { visit(nodes.index(i, -1), nodes.index(i, 0), false); });
    nodes.for_each_covered_part(-1, nx + 1, ny - 1, NodeGrid::Along::row,
                                [&](std::int64_t i) { visit(nodes.index(i, ny), nodes.index(i, ny - 1), false); });
}

}  // namespace

void mirror_sums(NodeGrid& nodes) {
    NodeSums* sums = nodes.sums();
    for_each_mirror_pair(nodes, [&](std::size_t ghost, std::size_t inner, bool normal_is_x) {
        const NodeSums g = sums[ghost];
        if (g.mass == 0) return;
        sums[inner].mass += g.mass;
        sums[inner].px += normal_is_x ? -g.px : g.px;
        sums[inner].py += normal_is_x ? g.py : -g.py;
        sums[inner].area += g.area;
        sums[inner].area_bed += g.area_bed;
        sums[inner].bed_squares += g.bed_squares;
        sums[inner].surface_squares += g.surface_squares;
        sums[ghost] = NodeSums{};
    });
    for_each_mirror_pair(nodes, [&](std::size_t ghost, std::size_t inner, bool normal_is_x) {
        if (sums[inner].mass == 0) return;
        sums[ghost] = sums[inner];
        (normal_is_x ? sums[ghost].px : sums[ghost].py) *= -1;
    });
}

void mirror_scalar(const NodeGrid& nodes, double* sums) {
    for_each_mirror_pair(nodes, [&](std::size_t ghost, std::size_t inner, bool) {
        sums[inner] += sums[ghost];
        sums[ghost] = 0;
    });
    for_each_mirror_pair(nodes, [&](std::size_t ghost, std::size_t inner, bool) { sums[ghost] = sums[inner]; });
}

void mirror_levels(NodeGrid& nodes) {
    for_each_mirror_pair(nodes, [&](std::size_t ghost, std::size_t inner, bool) {
        if (nodes.mass(inner) != 0) nodes.levels[ghost] = nodes.levels[inner];
    });
}

void fold_forces(NodeGrid& nodes) {
    NodeForces* forces = nodes.forces();
    for_each_mirror_pair(nodes, [&](std::size_t ghost, std::size_t inner, bool normal_is_x) {
        forces[inner].fx += normal_is_x ? -forces[ghost].fx : forces[ghost].fx;
        forces[inner].fy += normal_is_x ? forces[ghost].fy : -forces[ghost].fy;
        forces[ghost].fx = forces[ghost].fy = 0;
    });
}

void mirror_velocities(NodeGrid& nodes) {
    NodeMotion* motion = nodes.motion();
    for_each_mirror_pair(nodes, [&](std::size_t ghost, std::size_t inner, bool normal_is_x) {
        if (motion[inner].mass == 0) return;
        motion[ghost] = motion[inner];
        if (normal_is_x) {
            motion[ghost].u *= -1;
            motion[ghost].back_u *= -1;
        } else {
            motion[ghost].v *= -1;
            motion[ghost].back_v *= -1;
        }
    });
}

void mirror_exchange(const NodeGrid& nodes, ErodibleBed* beds) {
    for_each_mirror_pair(nodes, [&](std::size_t ghost, std::size_t inner, bool) {
        beds[ghost].gain = beds[inner].gain;
        beds[ghost].loss = beds[inner].loss;
    });
}

void mirror_bed(NodeGrid& nodes) {
    nodes.mirror_edges_when_read();
    for_each_mirror_pair(nodes,
                         [&](std::size_t ghost, std::size_t inner, bool) { nodes.bed[ghost] = nodes.bed[inner]; });
}

}  // namespace frana
