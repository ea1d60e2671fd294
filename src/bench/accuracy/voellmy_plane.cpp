// SPDX-License-Identifier: Apache-2.0
#include "bench/accuracy/voellmy_plane.h"

#include "bench/accuracy/sliding_block.h"

namespace frana::bench {
namespace {

constexpr double k_plane_slope_deg = 30, k_plane_friction_deg = 15, k_turbulence = 300, k_plane_time = 20;

CaseStatistics run_voellmy(double cell_size, Scheme scheme) {
    const double cosine = std::cos(k_plane_slope_deg * k_degree), sine = std::sin(k_plane_slope_deg * k_degree);
    const double a = k_gravity * (sine - cosine * std::tan(k_plane_friction_deg * k_degree));
    const double terminal = std::sqrt(a * k_turbulence * cosine / k_gravity);  // ratio of thickness to depth
    const auto travel = [=](double t) {
        return cosine * terminal * terminal / a * std::log(std::cosh(a * t / terminal));
    };
    Slab slab;
    slab.slope_deg = k_plane_slope_deg;
    slab.material = dry_friction(k_plane_friction_deg);
    slab.material.turbulence = k_turbulence;
    slab.time = k_plane_time;
    slab.travel = travel(k_plane_time);
    slab.speed = cosine * terminal * std::tanh(a * k_plane_time / terminal);
    SlabOutcome outcome = run_slab(cell_size, scheme, slab, travel);
    outcome.statistics.own = {{"terminal speed error", outcome.mean_speed / slab.speed - 1, 1e-3}};
    return outcome.statistics;
}

}  // namespace

AccuracyCase voellmy_plane() {
    return {"voellmy-plane", "terminal speed on 30 degrees, Voellmy friction", {4, 2, 1, 0.5}, true, run_voellmy};
}

}  // namespace frana::bench
