// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bench/exact/solutions.h"
#include "core/error.h"
#include "core/raster.h"
#include "params/keys/shared_values.h"
#include "particles/particle_set.h"
#include "simulation/flow.h"
#include "simulation/scene.h"

namespace frana::bench {

/// Returns the cases with these names, in the given order; all if none is named. Throws Error(input) with every unknown
/// name.
template <class Case>
std::vector<Case> choose(std::vector<Case> all, const std::vector<std::string>& only, const std::string& bench) {
    if (only.empty()) return all;
    std::string names;
    for (const Case& one : all) names += (names.empty() ? "" : ", ") + one.name;
    std::vector<Case> some;
    Problems problems;
    for (const std::string& name : only) {
        const auto found = std::find_if(all.begin(), all.end(), [&](const Case& one) { return one.name == name; });
        if (found == all.end()) {
            problems.add({"the bench " + bench + " has no such case", "--case", name, names, "Give one of these"});
        } else {
            some.push_back(*found);
        }
    }
    problems.throw_if_any();
    return some;
}

/// A flat grid from the origin, for cases without a map.
GridSpec plain_grid(std::int64_t columns, std::int64_t rows, double cell_size);

/// A raster of z(x, y) at the cell centres, local metres.
Raster sample_raster(const GridSpec& grid, const std::function<double(Point)>& z);

/// Depth and velocity at a local point; depth <= 0: no particle.
struct Seed {
    double depth = 0, u = 0, v = 0;
};

/// Fills the grid with `per_side` x `per_side` particles per cell, each with the depth and velocity at its place.
/// @param jitter 0: a lattice; otherwise each particle is displaced by up to jitter / 2 of the lattice spacing in both
///   directions, from a fixed generator (SplitMix64), the same on every machine
ParticleSet fill_lattice(const GridSpec& grid, int per_side, double jitter, const std::function<Seed(Point)>& state);

/// Initial state and parameters of a flow.
struct Setup {
    Raster bed;
    ParticleSet seeds;
    Material material;
    Numerics numerics;
    std::optional<TiltedGravity> tilt;
    MaterialZones zones{};
    Entrainment entrainment{};
    std::optional<StructuredMaterial> structured{};  ///< instead of `material`: the structured model
};

/// No friction, no stress, 1000 kg/m3.
Material water();
/// Coulomb friction only.
Material dry_friction(double angle_deg);
/// The same with xi [m/s2].
Material voellmy(double angle_deg, double turbulence);
/// Gives it a viscosity [Pa s] and a yield stress [Pa] in the plane.
void set_bingham(Material& material, double viscosity, double yield_stress = 0);

/// Returns the scheme in its standard form: `paper` never corrects for steep ground.
Numerics numerics_of(Scheme scheme, SlopeCorrection slope, Boundary boundary);

/// Its word in scene files.
const char* name_of(Scheme scheme);

/// Bed elevation between the nodes by the scheme's own shape functions; by finite volumes that of the cell.
class SchemeBed {
  public:
    SchemeBed(const Raster& bed, Scheme scheme, Boundary boundary);
    /// Elevation at a local point inside the grid [m].
    [[nodiscard]] double operator()(Point local) const;

  private:
    NodeGrid nodes_;
    Scheme scheme_;
};

/// A flow with a timer that runs only during the engine's work, and with the errors that occurred.
class TimedFlow {
  public:
    explicit TimedFlow(const Setup& setup, int threads = 1);

    /// Steps to `end`, or until a value is not finite; `after_step` is not timed.
    void advance_to(double end, const std::function<void(const StepStatistics&)>& after_step = {});

    /// With particles only.
    [[nodiscard]] Flow& flow() noexcept { return *flow_; }
    [[nodiscard]] Model& model() noexcept { return *model_; }
    [[nodiscard]] Flow::NodalFields fields();
    /// By finite volumes and in the structured model each cell with material counts as one.
    [[nodiscard]] const ParticleSet& particles();
    /// In map view [m/s].
    [[nodiscard]] Point velocity(std::size_t particle) const;
    [[nodiscard]] double seconds() const noexcept { return seconds_; }
    [[nodiscard]] double cpu_seconds() const noexcept { return cpu_seconds_; }
    /// Greatest number of particles at any time.
    [[nodiscard]] std::int64_t peak_particles() const noexcept { return peak_; }
    [[nodiscard]] std::int64_t non_finite() const noexcept { return non_finite_; }

  private:
    template <class Work>
    void time(const Work& work);

    std::unique_ptr<Model> model_;
    Flow* flow_ = nullptr;  ///< the same, if it is one
    ParticleSet cells_;
    double seconds_ = 0, cpu_seconds_ = 0;
    std::int64_t peak_ = 0, non_finite_ = 0;
};

}  // namespace frana::bench
