// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "models/structured/solid/near_quads.h"

namespace frana::structured {

/// Inputs and results of the sums over neighbours, one array each, in the particles' order. The arrays extend three
/// values beyond the last particle: four are read at a time.
struct PairWork {
    enum Array {
        x,
        y,
        u,
        v,
        area,
        bonds,  // 1: cohesive, and when intact bears its weight; read by velocity_gradients
        l_xx,
        l_xy,
        l_yx,
        l_yy,  // written by it
        mass,
        density,  // of the particle [kg] and of its column [kg/m2]
        t_xx,
        t_yy,
        t_xy,  // depth-integrated stress over density squared [m5/(kg s2)]
        r_xx,
        r_yy,
        r_xy,   // artificial stress, the same units
        sound,  // of the artificial viscosity [m/s]
        a_x,
        a_y,         // written by accelerations
        resistance,  // of the bed, as a deceleration [m/s2]
        strain,      // increment of damage by the particle's own yielding [-]
        count
    };
    static constexpr std::size_t k_padding = 3;

    void resize(std::size_t size) {
        for (auto& array : arrays) {
            array.resize(size + k_padding);
            for (std::size_t i = size; i < array.size(); ++i) array[i] = 1;  // finite padding, read unused
        }
    }
    double* operator[](Array a) noexcept { return arrays[a].data(); }
    const double* operator[](Array a) const noexcept { return arrays[a].data(); }

    std::array<std::vector<double>, count> arrays;
    /// By cell of the order, row by row: 1 if the cell is at rest in this substep (rest.h); empty: no cell is.
    std::vector<std::uint8_t> resting;
    NearQuads near;
};

template <class Archive>
void serialise(Archive& archive, PairWork& work) {
    [[maybe_unused]] auto& [arrays, resting, near] = work;
    archive(arrays);
    if constexpr (Archive::k_reads) near = {};  // lists of other particles
}

}  // namespace frana::structured
