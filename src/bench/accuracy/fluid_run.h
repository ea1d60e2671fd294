// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "bench/accuracy/accuracy_case.h"
#include "models/structured/fluid/fluid_step.h"

namespace frana::bench {

/// A free fluid on its grid with a timer, one thread: no friction, gentle slopes, walls on all sides.
class FluidRun {
  public:
    /// @param at depth and momentum at the start, local metres
    FluidRun(const Raster& bed, double dry_depth, const std::function<ExactState(Point)>& at);

    void advance(double time);
    [[nodiscard]] Flow::NodalFields fields() const;
    /// Returns the errors against an exact solution, with the cost of the run; `particles` counts the grid's cells.
    [[nodiscard]] CaseStatistics compare(const std::function<ExactState(Point)>& exact,
                                         const std::function<bool(Point)>& inside = {}) const;

  private:
    GridSpec grid_;
    NodeGrid nodes_;
    structured::FluidLaws laws_;
    structured::FluidState state_;
    ThreadPool pool_{1};
    std::int64_t steps_ = 0, non_finite_ = 0;
    double seconds_ = 0;
};

}  // namespace frana::bench
