// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>

#include "core/zero_array.h"

namespace frana {

/// Maxima of each node over time, updated at every step. Padded as the nodes are.
struct Maxima {
    ZeroArray<double> depth;           ///< [m]; 0: never reached
    ZeroArray<double> speed;           ///< along the bed [m/s]
    ZeroArray<double> arrival_plus_1;  ///< first time reached, plus one so that zero means never [s]

    static constexpr std::size_t k_bytes = 3 * sizeof(double);  ///< per node

    Maxima() = default;
    explicit Maxima(std::size_t size) : depth(size), speed(size), arrival_plus_1(size) {}

    template <class Archive>
    void serialise(Archive& archive) {
        auto& [h, v, arrival] = *this;
        archive(h, v, arrival);
    }

    void update(std::size_t node, double node_depth, double node_speed, double time) noexcept {
        depth[node] = std::max(depth[node], node_depth);
        speed[node] = std::max(speed[node], node_speed);
        if (arrival_plus_1[node] == 0) arrival_plus_1[node] = time + 1;
    }
};

}  // namespace frana
