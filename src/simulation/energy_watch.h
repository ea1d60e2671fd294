// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "simulation/step_statistics.h"

namespace frana {

/// Checks that a flow gains no energy by numerical errors. Motion under gravity and friction alone conserves
///
///     E = kinetic energy along the bed + potential energy + energy dissipated by friction so far;
///
/// numerical errors may dissipate, never add. error() is the greatest rise of E over an earlier value, relative to the
/// greatest kinetic energy plus the dissipation by then, which is the work of gravity. Velocities lag half a step
/// behind positions: a step's kinetic energy is the mean of before and after, and half of its dissipation is counted
/// before. Steps between which volume entered or left (release, inflow, open edges, erosion) are excluded.
class EnergyWatch {
  public:
    void add(const StepStatistics& statistics) {
        if (std::isnan(statistics.energy)) return;
        const double now = statistics.energy, volume = statistics.energy_volume;
        const double half = 0.5 * statistics.energy_dissipated;
        if (known_ && std::abs(volume - volume_) <= k_same_volume * volume_)
            balance_ += now - energy_ + half_dissipated_ + half;
        dissipated_ += statistics.energy_dissipated;
        lowest_ = std::min(lowest_, balance_);
        rise_ = std::max(rise_, balance_ - lowest_);
        turned_over_ = std::max(turned_over_, statistics.energy_moving + dissipated_);
        energy_ = now;
        half_dissipated_ = half;
        volume_ = volume;
        known_ = true;
    }
    /// None if nothing moved, or if the model does not report energy.
    [[nodiscard]] std::optional<double> error() const {
        if (!(turned_over_ > 0)) return std::nullopt;
        return rise_ / turned_over_;
    }

    template <class Archive>
    void serialise(Archive& archive) {
        auto& [known, energy, half, volume, balance, lowest, rise, dissipated, turned] = *this;
        archive(known, energy, half, volume, balance, lowest, rise, dissipated, turned);
    }

  private:
    static constexpr double k_same_volume = 1e-9;  ///< thousand times the rounding of the sums, less than any particle

    bool known_ = false;
    double energy_ = 0, half_dissipated_ = 0, volume_ = 0;  ///< of the previous step
    double balance_ = 0, lowest_ = 0, rise_ = 0;            ///< of E, relative to the start [m5/s2]
    double dissipated_ = 0, turned_over_ = 0;
};

}  // namespace frana
