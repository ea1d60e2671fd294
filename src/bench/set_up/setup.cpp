// SPDX-License-Identifier: Apache-2.0
#include "bench/set_up/setup.h"

#include <algorithm>
#include <cmath>

#include "mpm/boundary.h"
#include "mpm/shape.h"

namespace frana::bench {
namespace {

template <class Shape>
double interpolated(const NodeGrid& nodes, Point local) {
    const Stencil<Shape> stencil(local.x, local.y, nodes.scale());
    return interpolate(stencil, nodes.bed.data(), nodes.stride()).value + nodes.datum();
}

}  // namespace

Material water() {
    Material material;
    material.density = 1000;
    material.friction_coefficient = 0;
    return material;
}

Material dry_friction(double angle_deg) {
    Material material = water();
    material.friction_coefficient = std::tan(angle_deg * k_degree);
    return material;
}

Numerics numerics_of(Scheme scheme, SlopeCorrection slope, Boundary boundary) {
    Numerics numerics;
    numerics.scheme = scheme;
    numerics.slope_correction = scheme == Scheme::paper ? SlopeCorrection::none : slope;
    numerics.boundary = boundary;
    numerics.gravity = k_gravity;
    return numerics;
}

const char* name_of(Scheme scheme) {
    return scheme == Scheme::paper ? "paper" : "default";
}

SchemeBed::SchemeBed(const Raster& bed, Scheme scheme, Boundary boundary)
    : nodes_(bed), hats_(scheme == Scheme::paper) {
    if (boundary == Boundary::wall) mirror_bed(nodes_);
}

double SchemeBed::operator()(Point local) const {
    return hats_ ? interpolated<HatShape>(nodes_, local) : interpolated<QuadraticSplineShape>(nodes_, local);
}

TimedFlow::TimedFlow(const Setup& setup, int threads) {
    const auto begin = std::chrono::steady_clock::now();
    flow_.emplace(setup.bed, setup.seeds, setup.material, setup.numerics, threads, setup.tilt);
    seconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    peak_ = static_cast<std::int64_t>(flow_->particles().size());
}

void TimedFlow::advance_to(double end, const std::function<void(const voellmy_bingham::StepReport&)>& after_step) {
    // A last step shorter than this would only be rounding.
    while (flow_->time() < end * (1 - 1e-12) && non_finite_ == 0 && !flow_->empty()) {
        const double before = flow_->time();
        const auto begin = std::chrono::steady_clock::now();
        const voellmy_bingham::StepReport report = flow_->advance(end - before);
        seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        peak_ = std::max(peak_, static_cast<std::int64_t>(flow_->particles().size()));
        non_finite_ += report.particles.non_finite;
        if (!(flow_->time() > before))
            ++non_finite_;  // a step that does not advance time results from a non-finite
                            // value
        if (after_step) after_step(report);
    }
    flow_->synchronise();
}

}  // namespace frana::bench
