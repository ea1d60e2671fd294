// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace frana::structured {

/// What the sweeps of a substep pass on, one array each, in the particles' order.
struct SolidWork {
    enum Array {
        bonds,       // 1: cohesive, and when intact bears its weight; set by a sort, cleared when it breaks
        opening,     // trace of the velocity gradient [1/s]
        sound,       // speed of waves [m/s]
        resistance,  // of the bed, as a deceleration [m/s2]
        strain,      // increment of damage by the particle's own yielding [-]
        count
    };
    void resize(std::size_t size) {
        for (auto& array : arrays) array.resize(size);
    }
    double* operator[](Array a) noexcept { return arrays[a].data(); }
    const double* operator[](Array a) const noexcept { return arrays[a].data(); }

    std::array<std::vector<double>, count> arrays;
};

template <class Archive>
void serialise(Archive& archive, SolidWork& work) {
    [[maybe_unused]] auto& [arrays] = work;
    archive(arrays);
}

}  // namespace frana::structured
