// SPDX-License-Identifier: Apache-2.0
#include "simulation/scene_values.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "params/keys/laws.h"
#include "params/keys/material_parameters.h"

namespace frana {
namespace {

void set(double& target, const std::optional<double>& value) {
    if (value) target = *value;
}

void set_tangent(double& target, const std::optional<double>& angle_deg) {
    if (angle_deg) target = tangent_of(*angle_deg);
}

/// Returns the number of a uniform property.
std::optional<double> constant(const std::optional<SourceSpec>& source) {
    if (!source || source->kind != SourceSpec::Kind::number) return std::nullopt;
    return source->number;
}

}  // namespace

std::optional<StructuredMaterial> structured_of(const SceneSpec& spec) {
    if (spec.material.model != "structured") return std::nullopt;
    const StructuredSpec& s = spec.structured;
    StructuredMaterial m;
    m.solids = s.phases == "solids-and-fluid";
    static_cast<StructuredValues&>(m) = s;
    for (const SolidKey& key : solid_keys()) {
        const std::optional<double> value = constant(s.*key.in_use(s).source);
        if (key.degrees())
            set_tangent(m.*key.value, value);
        else
            set(m.*key.value, value);
    }
    m.sin_dilatancy = std::sin(s.dilatancy_angle * std::numbers::pi / 180);
    set(m.block_size, s.block_size);
    set(m.sound_speed, s.sound_speed);
    return m;
}

Numerics numerics_of(const SceneSpec& spec) {
    Numerics numerics;
    const NumericsSpec& words = spec.numerics;
    numerics.particles_per_cell = static_cast<int>(words.particles_per_cell);
    static_cast<NumericsValues&>(numerics) = words;
    numerics.cfl = courant_number(spec);
    numerics.well_balanced = well_balanced(words);
    const std::string correction = slope_correction(words);
    numerics.slope_correction = correction == "none"      ? SlopeCorrection::none
                                : correction == "surface" ? SlopeCorrection::surface
                                                          : SlopeCorrection::normal;
    numerics.curvature = curvature(words);
    numerics.flight = flight(words);
    numerics.flight_slope = tangent_of(words.flight_slope);
    const std::string& policy = spec.terrain.nodata_policy;
    numerics.nodata = policy == "wall"   ? NodataPolicy::wall
                      : policy == "fill" ? NodataPolicy::fill
                                         : NodataPolicy::stop;
    return numerics;
}

TimeControl time_of(const SceneSpec& spec) {
    TimeControl time;
    static_cast<TimeValues&>(time) = spec.time;
    time.end = spec.time.end;
    time.stop_change = spec.time.stop_change;
    time.trace_threshold = std::max(spec.output.trace_threshold, spec.numerics.minimum_depth);
    time.frame_interval = frame_interval(spec);
    return time;
}

void set_uniform_details(const ReleaseSpec& spec, ReleaseArea& area) {
    area.normal_to_bed = spec.thickness_direction == "normal";
    area.start = constant(spec.start).value_or(0);
    area.speed = constant(spec.velocity).value_or(0);
    if (const auto degrees = constant(spec.direction)) area.azimuth = *degrees * std::numbers::pi / 180;
}

std::optional<double> release_volume_of(const ReleaseSpec& spec) {
    return constant(spec.volume);
}

}  // namespace frana
