// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bench/set_up/setup.h"

namespace frana::bench {

/// A value with its limit; good when it is at most the limit.
struct Figure {
    std::string name;
    double value = 0, limit = 0;

    [[nodiscard]] bool within() const noexcept { return value <= limit; }  // NaN is not
    /// Fraction of the limit used [-].
    [[nodiscard]] double used() const noexcept;
};

/// What is observed in every hard case.
struct Soundness {
    std::int64_t non_finite = 0;  ///< particles or fields with non-finite values;
    double volume_error = 0;      ///< |inside + left + in the bed - start| / start; what is walled in cannot leave
    double speed_ratio = 0;       ///< greatest speed over sqrt(2 g drop) + 2 sqrt(g depth)
    double energy_rise = 0;       ///< by EnergyWatch, of the work of gravity
    double above_line = 0;        ///< greatest height above the energy line, of the fall
    double courant = 0;           ///< greatest way of a wave or particle in a step, in cells
    double last_speed = 0;        ///< root of the mean squared speed at the end [m/s]
    std::int64_t particles = 0;   ///< greatest number
    std::int64_t steps = 0;
    double wall_seconds = 0;
};

/// How a case is computed.
struct Variant {
    Scheme scheme = Scheme::standard;
    bool structured = false;  ///< the structured model
    double cells = 1;         ///< cell size relative to the case's own

    /// "default", "finite-volume" or "structured".
    [[nodiscard]] const char* word() const { return structured ? "structured" : name_of(scheme); }
};

enum : unsigned {
    // Variants.
    k_particles = 1,
    k_volumes = 2,
    k_structured = 4,
    k_one_phase = k_particles | k_volumes,
    k_all = k_one_phase | k_structured,
    // Figures besides a case's own.
    k_mirror = 1,  ///< flows in the mirrored terrain are mirrored
    k_cells = 2,   ///< places on half the cells
    k_rest = 4,    ///< at rest at the end
    k_energy = 8,  ///< no rise of energy
    k_ties = 16,   ///< rows of particles are alike
    k_usual = k_energy | k_mirror | k_cells,
};

/// One hard case: its initial state, its duration, and the value measured at its end.
struct HardCase {
    std::string name;
    std::string what;
    double end = 0;  ///< [s]
    std::function<Setup(const Variant&)> make;
    unsigned variants = k_one_phase;
    unsigned figures = k_usual;
    std::function<Figure(const Setup&, TimedFlow&)> own = {};
    /// Where material remains, whose volume must not depend on the cells.
    std::function<bool(Point)> trap = {};
};

/// Runs one flow to its end and checks it.
Soundness watch(TimedFlow& run, const Setup& setup, double end);
/// Return what is seen in a mirror that swaps west and east, or south and north.
Raster mirrored(Raster raster, bool swaps_west);
Setup mirrored(Setup setup, bool swaps_west);
/// Returns the fraction of the volume that lies elsewhere.
double elsewhere(const Raster& depth, const Raster& other);

std::vector<HardCase> hard_terrain_cases();
std::vector<HardCase> hard_release_cases();
std::vector<HardCase> hard_material_cases();
std::vector<HardCase> hard_numerics_cases();

/// One row of stability.csv. A case passes if each figure is within its limit.
struct StabilityRow {
    std::string case_name, what, scheme;
    bool passed = false;
    std::vector<Figure> figures;  ///< at least two, the case's own or its speed first
    Soundness sound;

    /// Whether everything is within its limit.
    [[nodiscard]] bool good() const;
    /// The figure nearest to its limit.
    [[nodiscard]] const Figure& nearest() const;
    /// The nearest of those after the first.
    [[nodiscard]] const Figure& second() const;
};

struct StabilityOptions {
    int threads = 1;
    std::vector<std::string> only;                   ///< names of cases; empty: all
    std::function<void(const std::string&)> report;  ///< called with one line for each finished case
};

std::vector<HardCase> hard_cases();

/// Runs one case and judges it.
StabilityRow run_case(const HardCase& one, const Variant& variant, int threads);
/// Runs the hard cases in each of their variants. Throws Error(input) for an unknown name.
std::vector<StabilityRow> run_stability(const StabilityOptions& options);

std::string stability_csv(const std::vector<StabilityRow>& rows);
std::string stability_table(const std::vector<StabilityRow>& rows);

}  // namespace frana::bench
