// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "analysis/energy_line.h"
#include "core/error.h"
#include "simulation/arrivals.h"
#include "simulation/model.h"
#include "simulation/release.h"
#include "simulation/result.h"
#include "simulation/scene.h"

namespace frana {

/// Returns the problems of a structured material: values that its laws do not describe.
/// @param where returns where a key was given, for messages
std::vector<Problem> structured_problems(const StructuredMaterial& material, double cell_size,
                                         const std::function<std::string(const std::string&)>& where);

/// Returns the greatest speed possible by a fall without friction [m/s]: free fall from the highest surface to the
/// lowest ground and the front of a dam break of the greatest depth, sqrt(2 g drop) + 2 sqrt(g depth), besides the
/// initial speed or that of the elastic rebound of strong solids. `frana bench stability` uses it too.
double speed_bound(double gravity, double drop, double depth, double speed_at_start);

/// Checks after every step for events that must not occur. Costs a few comparisons per step; places are searched only
/// after an event.
class RunCheck {
  public:
    /// Error of the volume not explained by rounding, as a fraction of the volume that entered: a thousand times the
    /// rounding error of sums over 1e5 particles, and far less than visible on any map.
    static constexpr double k_volume_drift = 1e-9;

    /// @param pressure_factor square of the ratio of pressure waves' speed to that in water
    RunCheck(const Scene& scene, const Release& release, const Arrivals& arrivals, double pressure_factor);

    /// Returns the problems of the last step; none in a good run.
    /// @param entered volume that entered, including from the bed [m3]
    [[nodiscard]] std::vector<RunProblem> check(const Model& model, const StepStatistics& statistics,
                                                double entered) const;

    /// The bound for the terrain known at the start, where terrain is read on demand.
    [[nodiscard]] double greatest_speed() const noexcept { return greatest_speed(lowest_); }

  private:
    [[nodiscard]] double greatest_speed(double lowest) const noexcept;

    GridSpec grid_;
    bool gaps_matter_;
    double gravity_, top_, depth_, at_start_;  // of material that enters: surface [m], depth for waves [m], speed [m/s]
    double lowest_, erodible_;                 // bed known at the start, and how far it may be eroded [m]
};

/// Compares the maxima of a finished run with its energy line.
/// @param pressure_factor as RunCheck's
EnergyLineExcess energy_line_excess(const RunResult& result, const Scene& scene, double pressure_factor);

void add(const RunProblem& run_problem, HardEvents& events);
StopReason reason_of(const RunProblem& run_problem);
/// "step 120, 4.37 s, at (527012.5, 5094061.0): 3 particles or cells ..."
std::string describe(const RunProblem& run_problem);

}  // namespace frana
