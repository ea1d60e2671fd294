// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bench/set_up/setup.h"

namespace frana::bench {

/// Conditions of every hard case.
struct Soundness {
    std::int64_t non_finite = 0;  ///< particles or fields with non-finite values; must be 0
    double volume_error = 0;      ///< |inside + left - start| / start; at most 1e-12
    double speed_ratio = 0;       ///< greatest speed over sqrt(2 g drop) + 2 sqrt(g depth); at most 1
    std::int64_t clamped = 0;     ///< particles whose depth had to be bounded
    std::int64_t particles = 0;   ///< greatest number
    std::int64_t steps = 0;
    double wall_seconds = 0;
};

/// The case's own value with its limit; passed when it is at most the limit.
struct StabilityStatistic {
    std::string name;
    double value = 0;
    double limit = 0;
};

/// One hard case: its initial state, its duration, and the value measured at its end. Cases without a value of their
/// own are judged by their speed ratio.
struct HardCase {
    std::string name;
    std::string what;
    double end = 0;  ///< [s]
    std::function<Setup()> make;
    std::function<StabilityStatistic(const Setup&, TimedFlow&)> statistic = {};
    /// For cases that compare several runs: runs and compares them.
    std::function<StabilityStatistic(Scheme, int threads, Soundness&)> compare = {};
    bool of_particles = false;  ///< has no meaning by finite volumes
};

/// Runs one flow to its end and checks it.
Soundness watch(TimedFlow& run, const Setup& setup, double end);
/// Compares the depths of runs that must agree.
class DepthAgreement {
  public:
    void compare(TimedFlow& run);
    [[nodiscard]] StabilityStatistic statistic() const { return {"greatest difference of depth [m]", greatest_, 0}; }

  private:
    std::optional<Raster> first_;
    double greatest_ = 0;
};

/// Keeps the worse of two.
void merge(Soundness& into, const Soundness& other);

std::vector<HardCase> hard_terrain_cases();
std::vector<HardCase> hard_release_cases();
std::vector<HardCase> hard_material_cases();
std::vector<HardCase> hard_numerics_cases();

/// Returns the scene of which most cases change one property: a slope of 1 : 2 that ends in level ground at x = 80 m, a
/// grid of 160 m x 80 m in cells of 2 m, a cap 3 m deep and 15 m in radius at (30, 40) m, phi = 15 degrees, xi = 500
/// m/s2, open sides, slope correction `normal`.
Setup usual_slide();
/// Returns the same on other ground.
Setup usual_slide_on(double cell_size, const std::function<double(Point)>& bed);
/// Depth of the usual cap [m].
double usual_cap(Point place);
/// Elevation of the usual slope [m].
double usual_slope(Point place);

/// One row of stability.csv. A case passes if nothing is non-finite, the volume is conserved to 1e-12, no speed exceeds
/// sqrt(2 g drop) + 2 sqrt(g depth), and its own value is within its limit.
struct StabilityRow {
    std::string case_name, what;
    Scheme scheme = Scheme::standard;
    bool passed = false;
    StabilityStatistic statistic;
    Soundness sound;
};

struct StabilityOptions {
    int threads = 1;
    std::vector<std::string> only;                   ///< names of cases; empty: all
    std::function<void(const std::string&)> report;  ///< called with one line for each finished case
};

std::vector<HardCase> hard_cases();

/// Runs the hard cases with material points and with finite volumes. Throws Error(input) for an unknown name.
std::vector<StabilityRow> run_stability(const StabilityOptions& options);

std::string stability_csv(const std::vector<StabilityRow>& rows);
std::string stability_table(const std::vector<StabilityRow>& rows);

}  // namespace frana::bench
