// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <memory>

#include "simulation/result.h"
#include "simulation/scene.h"

namespace frana {

/// Results of a step of either model, used for the run's series, checks and counts.
struct StepStatistics {
    double dt = 0;              ///< [s]
    double volume = 0;          ///< inside the domain [m3]
    double max_depth = 0;       ///< [m]
    double max_speed = 0;       ///< along the bed [m/s]
    double fastest = 0;         ///< of a particle in map view, however thin [m/s]
    double front_distance = 0;  ///< from the run's origin, in map view [m]
    double kinetic = 0;         ///< energy over density [m5/s2]
    double energy = std::numeric_limits<double>::quiet_NaN();
    ///< kinetic and potential, over density, at the beginning of the step [m5/s2]; NaN: not known
    double energy_moving = 0;      ///< of which kinetic [m5/s2]
    double energy_volume = 0;      ///< of the volume to which it belongs [m3]
    double energy_dissipated = 0;  ///< by friction and walls in the step, over density [m5/s2]
    double moving = 0;             ///< volume faster than the run's moving speed, however thin [m3]
    double thin = 0;               ///< volume thinner than the minimum depth [m3]
    std::int64_t covered = 0;      ///< cells deeper than the minimum depth
    std::int64_t unsupported = 0;  ///< see RunResult::unsupported
    std::int64_t non_finite = 0;   ///< particles or cells with a non-finite state
    std::int64_t clamped = 0;      ///< particles whose area had to be bounded
    std::int64_t no_data = 0;      ///< particles or flows that reached cells without terrain
};

/// The run of simulation.h, step by step. Refers to scene and options.
class SteppedRun {
  public:
    /// Throws as run() does.
    SteppedRun(const Scene& scene, const RunOptions& options);
    ~SteppedRun();

    /// Whether a step remains to be done.
    [[nodiscard]] bool continues() const;
    void step();
    [[nodiscard]] Progress progress() const;
    /// Returns the result; call once.
    RunResult finish();

    /// Of one model; called once a step.
    class OfModel;

  private:
    std::unique_ptr<OfModel> run_;
};

}  // namespace frana
