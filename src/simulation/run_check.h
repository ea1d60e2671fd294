// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "simulation/arrivals.h"
#include "simulation/release.h"
#include "simulation/result.h"
#include "simulation/scene.h"
#include "simulation/step_statistics.h"

namespace frana {

/// Greatest speed that a fall allows, even without friction [m/s]: free fall from the highest surface to the
/// lowest ground and the front of a dam break as deep as the deepest column, sqrt(2 g drop) + 2 sqrt(g
/// depth), besides the speed that something had from the start, or to which strong solids spring back.
/// `frana bench stability` judges by it too.
double speed_bound(double gravity, double drop, double depth, double speed_at_start);

/// Looks after every step for what must not happen. Costs a few comparisons a step; places are sought only
/// when something has happened.
class RunCheck {
  public:
    /// Error of the volume that rounding does not explain, as a fraction of all that came in: a thousand times
    /// what sums over 1e5 particles lose, and far less than any map shows.
    static constexpr double k_volume_drift = 1e-9;

    /// @param pressure_factor by which waves of pressure are faster than in water, squared
    RunCheck(const Scene& scene, const Release& release, const Arrivals& arrivals, double pressure_factor);

    /// What the last step brought; empty in a good run.
    /// @param taken all that came in, from the bed too [m3]
    template <class AnyFlow>
    [[nodiscard]] std::vector<RunProblem> check(const AnyFlow& flow, const StepStatistics& statistics,
                                                double taken) const;

    [[nodiscard]] double greatest_speed() const noexcept { return bound_; }

  private:
    GridSpec grid_;
    bool gaps_matter_;
    double bound_;
};

void add(const RunProblem& run_problem, HardEvents& events);
StopReason reason_of(const RunProblem& run_problem);
/// "step 120, 4.37 s, at (527012.5, 5094061.0): 3 particles or cells ..."
std::string describe(const RunProblem& run_problem);

}  // namespace frana
