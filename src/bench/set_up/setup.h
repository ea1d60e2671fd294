// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <functional>
#include <optional>

#include "bench/exact/exact_state.h"
#include "bench/set_up/lattice.h"
#include "simulation/flow.h"

namespace frana::bench {

/// Initial state and parameters of a flow.
struct Setup {
    Raster bed;
    ParticleSet seeds;
    Material material;
    Numerics numerics;
    std::optional<TiltedGravity> tilt;
};

/// No friction, no stress, 1000 kg/m3.
Material water();
/// Coulomb friction only.
Material dry_friction(double angle_deg);

/// Returns the scheme in its standard form: `paper` never corrects for steep ground.
Numerics numerics_of(Scheme scheme, SlopeCorrection slope, Boundary boundary);

/// "default" or "paper".
const char* name_of(Scheme scheme);

/// Bed elevation between the nodes by the scheme's own shape functions.
class SchemeBed {
  public:
    SchemeBed(const Raster& bed, Scheme scheme, Boundary boundary);
    /// Elevation at a local point inside the grid [m].
    [[nodiscard]] double operator()(Point local) const;

  private:
    NodeGrid nodes_;
    bool hats_;
};

/// A flow with a timer that runs only during the engine's work, and with the errors that occurred.
class TimedFlow {
  public:
    explicit TimedFlow(const Setup& setup, int threads = 1);

    /// Steps to `end`, or until a value is not finite; `after_step` is not timed.
    void advance_to(double end, const std::function<void(const voellmy_bingham::StepReport&)>& after_step = {});

    [[nodiscard]] Flow& flow() noexcept { return *flow_; }
    [[nodiscard]] double seconds() const noexcept { return seconds_; }
    /// Greatest number of particles at any time.
    [[nodiscard]] std::int64_t peak_particles() const noexcept { return peak_; }
    [[nodiscard]] std::int64_t non_finite() const noexcept { return non_finite_; }

  private:
    std::optional<Flow> flow_;
    double seconds_ = 0;
    std::int64_t peak_ = 0, non_finite_ = 0;
};

}  // namespace frana::bench
