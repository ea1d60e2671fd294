// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/grid_spec.h"
#include "simulation/arrivals.h"
#include "simulation/release.h"

namespace frana {

class Flow;
class StructuredFlow;
struct StepStatistics;

/// The places from which the distance of a front is measured, each front from the nearest: the centroid of every
/// release and the middle of every inflow. A release is a group of cells that touch; groups with less than a hundredth
/// of the greatest one's volume do not count.
class FrontOrigins {
  public:
    FrontOrigins(const Release& release, const Arrivals& arrivals);
    explicit FrontOrigins(Point only) : places_{only} {}

    [[nodiscard]] bool single() const noexcept { return places_.size() == 1; }
    /// The only place, or the westernmost. Local metres.
    [[nodiscard]] Point first() const { return places_.front(); }
    /// Returns the squared distance [m2] of a place from the nearest of them.
    [[nodiscard]] double squared_distance(Point place) const noexcept;

  private:
    std::vector<Point> places_;  // local metres, from west to east
};

/// Before the first step: a flow's particles know one origin, a structured flow all.
void set_origins(Flow& flow, const FrontOrigins& origins);
void set_origins(StructuredFlow& flow, const FrontOrigins& origins);
/// After a step: of several origins, a flow's particles find the nearest here.
void measure_front(const Flow& flow, const FrontOrigins& origins, StepStatistics& statistics);
void measure_front(const StructuredFlow& flow, const FrontOrigins& origins, StepStatistics& statistics);

}  // namespace frana
