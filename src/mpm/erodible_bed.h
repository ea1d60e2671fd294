// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace frana {

/// The erodible and the deposited bed under a node, averaged over the cell, vertical.
struct ErodibleBed {
    double erodible;   ///< at the start [m]
    double eroded;     ///< so far [m]
    double deposited;  ///< so far [m]
    double gain;       ///< in this step, as a fraction of the node's volume [-]
    double loss;       ///< the same for deposition [-]
    double change;     ///< of the bed in this step by erosion or deposition [m]
    double forest;     ///< detrainment coefficient of the stand; 0: none [Pa]
    double held;       ///< by forest in this step [m]
    double kept;       ///< the sum of it, a part of `deposited` that is not eroded again [m]
};

/// Amounts exchanged between bed and flow.
struct ExchangeReport {
    double eroded = 0, deposited = 0;       ///< [m3]
    double momentum_x = 0, momentum_y = 0;  ///< of the deposited material, over density [m4/s]

    void merge(const ExchangeReport& r) noexcept {
        eroded += r.eroded;
        deposited += r.deposited;
        momentum_x += r.momentum_x;
        momentum_y += r.momentum_y;
    }
};

template <class Archive>
void serialise(Archive& archive, ExchangeReport& report) {
    auto& [eroded, deposited, momentum_x, momentum_y] = report;
    archive(eroded, deposited, momentum_x, momentum_y);
}

}  // namespace frana
