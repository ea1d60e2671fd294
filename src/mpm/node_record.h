// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace frana {

// A node's record of one cache line, whose slots have a different meaning in each phase of a step. Each half is loaded
// at once by a fast kernel; `mass` is the same in all phases.

/// Sums over particles.
struct alignas(64) NodeSums {
    double px, py;           ///< momentum, along the bed if particles carry it so [m4/s]
    double bed_squares;      ///< area times squared elevation of the bed relative to the node's bed [m4]
    double surface_squares;  ///< the same of the particles' surface; both only with reference levels
    double mass;             ///< volume: density is constant and divided out [m3]
    double area;             ///< area that the particles claim [m2]
    double area_bed;         ///< area times elevation of the bed relative to the node's bed [m3]; with reference levels
                             ///< only
    double unused;
};

/// Forces on the node.
struct alignas(64) NodeForces {
    double px, py;    ///< momentum in map view [m4/s]
    double fx, fy;    ///< force over density [m4/s2]
    double mass;      ///< [m3]
    double area;      ///< [m2]
    double crowding;  ///< see crowding(), 0 without reference levels
    double held;      ///< 1: friction keeps the node at rest
};

/// Results that the particles gather; kept until the node is cleared.
struct alignas(64) NodeMotion {
    double u, v;            ///< velocity in map view [m/s]
    double back_u, back_v;  ///< velocity, along the bed if particles carry it so, or, with FLIP, its change [m/s]
    double mass;            ///< [m3]
    double fraction;        ///< of the cell that the particles claim, phi [-]
    double climb;           ///< v . grad Z [m/s], only with curvature
    double support;         ///< NodeLevel::support
};

/// The phase of the records of a grid.
enum class NodePhase { sums, forces, motion };

union NodeRecord {
    NodeSums sums;
    NodeForces forces;
    NodeMotion motion;
};

}  // namespace frana
