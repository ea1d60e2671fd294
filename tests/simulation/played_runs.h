// SPDX-License-Identifier: Apache-2.0
// Runs that tests save, interrupt and observe, of both models with all events; compared bit for bit.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <optional>
#include <vector>

#include "physics/laws.h"
#include "simulation/simulation.h"

namespace frana {

using Bytes = std::vector<std::byte>;

inline Polygon box(double west, double south, double east, double north) {
    return {{{west, south}, {east, south}, {east, north}, {west, north}}, {}};
}

// 240 m x 120 m, steep in the west, level in the east, a ridge along the middle.
inline Scene hillside() {
    Scene scene;
    scene.grid = {0, 120, 2, 120, 60, ""};
    scene.terrain = Raster(scene.grid);
    for (std::int64_t r = 0; r < scene.grid.rows; ++r) {
        for (std::int64_t c = 0; c < scene.grid.columns; ++c) {
            const Point p = scene.grid.cell_centre(r, c);
            scene.terrain.at(r, c) = 200 + 0.6 * std::max(0.0, 130 - p.x) + 2 * std::exp(-std::pow((p.y - 60) / 20, 2));
        }
    }
    scene.release = {{{box(10, 40, 40, 80)}, 3}};
    scene.material.of<CoulombFriction>().friction_coefficient = 0.35;
    scene.material.of<TurbulentFriction>().turbulence = 400;
    scene.time.end = 12;
    scene.time.frame_interval = 2;
    return scene;
}

// With all arrivals, recordings and changes during the run.
inline Scene eventful() {
    Scene scene = hillside();
    scene.terrain_contains_release = true;
    scene.release.push_back({{box(60, 20, 80, 40)}, 2});
    scene.release[1].start = 5.3;
    scene.inflows = {{{{20, 90}, {20, 110}}, {{0, 5, 2}, {9, 10, 3}}, std::nullopt}};
    scene.walls = Raster(scene.grid, 0);
    for (std::int64_t r = 20; r < 30; ++r) scene.walls->at(r, 70) = 1;
    scene.material.of<BinghamStress>().viscosity = 300;
    scene.material.of<BinghamStress>().yield_stress = 50;
    scene.material.bed_friction = {"coulomb", "turbulence", "cohesion"};
    scene.material.of<CohesiveFriction>().cohesion = 200;
    scene.material.of<CoulombFriction>().pore_pressure_ratio = 0.3;
    scene.material.of<CoulombFriction>().pore_fluid_density = 500;
    scene.material.of<CoulombFriction>().hydraulic_diffusivity = 0.1;
    scene.material.of<CoulombFriction>().solid_fraction = 0.59;
    scene.material.of<CoulombFriction>().critical_solid_fraction = 0.6;
    scene.material.of<CoulombFriction>().compressibility = 1e-5;
    scene.entrainment.erosion = "shear-stress";
    scene.entrainment.erodible_depth = 0.5;
    scene.entrainment.deposition = true;
    scene.entrainment.of<ShearStressDeposition>().deposition_rate = 0.01;
    scene.entrainment.of<ShearStressDeposition>().deposition_shear = 1000;
    scene.entrainment.detrainment = true;
    scene.entrainment.of<ForestDetrainment>().detrainment_coefficient = 20;
    scene.recording.gauges = {{"a", {90, 60}}, {"b", {150, 60}}};
    scene.recording.sections = {{"s", {{100, 10}, {100, 110}}}};
    scene.recording.interval = 0.7;
    scene.recording.intensity = scene.recording.plane_stress = true;
    scene.time.stop_momentum = 0.01;
    return scene;
}

// Long enough for most of it to come to rest, and for tiles at rest to be reactivated by a second mass.
inline Scene resting() {
    Scene scene = hillside();
    scene.material.of<CoulombFriction>().friction_coefficient = 0.5;
    scene.release.push_back({{box(60, 50, 80, 70)}, 2});
    scene.release[1].start = 25;
    scene.time.end = 35;
    scene.time.frame_interval = 10;
    return scene;
}

// Ends when its results have stopped changing.
inline Scene settling() {
    Scene scene = hillside();
    scene.time.end = 300;
    scene.time.frame_interval = 15;
    scene.time.stop_when_still = false;
    scene.time.stop_change = 0.01;
    return scene;
}

inline Scene by_finite_volumes(Scene scene) {
    scene.numerics.scheme = Scheme::finite_volume;
    return scene;
}
inline Scene finite_volumes() {
    Scene scene = hillside();
    scene.material.of<BinghamStress>().viscosity = 300;
    scene.material.of<BinghamStress>().yield_stress = 50;
    return by_finite_volumes(scene);
}
inline Scene eventful_volumes() {
    return by_finite_volumes(eventful());
}
inline Scene resting_volumes() {
    Scene scene = by_finite_volumes(resting());
    scene.time.stop_when_still = false;
    return scene;
}

// Over a cliff, and against a wall of the ground: saved while a part is in the air.
inline Scene flying() {
    Scene scene = hillside();
    for (std::int64_t row = 0; row < scene.grid.rows; ++row)
        for (std::int64_t column = 0; column < scene.grid.columns; ++column)
            if (const double x = scene.grid.cell_centre(row, column).x; x < 90 || std::abs(x - 125) < 3)
                scene.terrain.at(row, column) += x < 90 ? 20 : 5;
    return scene;
}

inline Scene paper() {
    Scene scene = hillside();
    scene.numerics.scheme = Scheme::paper;
    scene.numerics.well_balanced = false;
    scene.numerics.slope_correction = SlopeCorrection::none;
    scene.material.of<BinghamStress>().viscosity = 500;
    scene.material.of<BinghamStress>().yield_stress = 100;
    scene.numerics.transfer = Transfer::flip;
    scene.numerics.boundary = Boundary::wall;
    return scene;
}

inline Scene earth_pressure() {
    Scene scene = hillside();
    scene.material.in_plane_stress = EarthPressureStress::word;
    scene.material.of<EarthPressureStress>().internal_friction_angle = 31;
    scene.numerics.curvature = true;
    scene.zones.friction_coefficient = Raster(scene.grid, 0.3);
    return scene;
}

inline Scene fluid() {
    Scene scene = hillside();
    scene.structured.emplace();
    scene.structured->fluid_viscosity = 0.5;
    scene.inflows = {{{{20, 90}, {20, 110}}, {{0, 5, 2}, {9, 10, 3}}, std::nullopt}};
    scene.terrain_contains_release = true;
    scene.release.push_back({{box(60, 20, 80, 40)}, 2});
    scene.release[1].start = 5.3;
    scene.recording.gauges = {{"a", {90, 60}}};
    scene.recording.sections = {{"s", {{100, 10}, {100, 110}}}};
    scene.recording.intensity = true;
    return scene;
}

// Rain that ends, on a soil by place.
inline Scene raining() {
    Scene scene = fluid();
    StructuredMaterial& material = *scene.structured;
    material.fluid_viscosity = 0;
    material.rain.points = {{0, 1e-4}, {2, 3e-4}};
    material.soil = GreenAmpt{1e-4, 0.1, 0.3};
    Raster conductivity(scene.grid, 2e-4);
    for (std::int64_t row = 0; row < scene.grid.rows; ++row) conductivity.at(row, 3) = k_no_data;
    material.soil_zones.push_back({&GreenAmpt::conductivity, conductivity});
    return scene;
}

// Blocks that break and release their fluid, until some leave through the edge.
inline Scene breaking() {
    Scene scene = hillside();
    StructuredMaterial& material = scene.structured.emplace();
    material.solids = true;
    material.confined_fraction = 0.7;
    material.cohesion = 2000;
    material.friction = 0.6;
    material.bed_friction = 0.2;
    material.young_modulus = 2e5;
    material.bulk_modulus = 4e5;
    scene.recording.gauges = {{"a", {90, 60}}};
    scene.time.end = 5;
    scene.time.frame_interval = 1;
    return scene;
}

// Blocks whose pore pressure decreases, and changes with shear.
inline Scene breaking_under_pressure() {
    Scene scene = breaking();
    PorePressure& pores = scene.structured->pores;
    pores.initial.ratio = 0.5;
    pores.diffusivity = 0.1;
    pores.critical_fraction = 0.52;
    pores.compressibility = 1e-5;
    scene.release.push_back({{box(60, 50, 80, 70)}, 2});
    scene.release[1].start = 1;
    return scene;
}

// Solids come only later, so that the run begins without any.
inline Scene breaking_later() {
    Scene scene = breaking();
    scene.release[0].start = 0.5;
    scene.inflows = {{{{20, 90}, {20, 110}}, {{0, 5, 2}, {3, 5, 2}}, std::nullopt}};
    scene.structured->more_fluid = true;
    scene.time.end = 2;
    return scene;
}

inline Scene loose_and_dry() {
    Scene scene = breaking();
    scene.structured->cohesion = 0;
    scene.structured->confined_fraction = 0;
    scene.structured->solid_fraction = 1;
    return scene;
}

struct Played {
    RunResult result;
    std::vector<Frame> frames;
    std::vector<Bytes> states;  // as saved
    std::vector<std::int64_t> steps;
};

// Saves after every `every`th step; starts from a state, or from the beginning. Stops on request after the step `stop`.
inline Played play(const Scene& scene, int threads, std::int64_t every, const Bytes* from = nullptr,
                   std::int64_t stop = 0) {
    Played played;
    RunOptions options;
    options.threads = threads;
    options.on_frame = [&](Frame frame) { played.frames.push_back(std::move(frame)); };
    std::int64_t step = 0;
    options.on_progress = [&](const Progress& now) { step = now.step; };
    options.stop_requested = [&] { return stop > 0 && step >= stop; };
    options.after_step = [&](const Progress& now, const SaveState& save) {
        if (now.step % every != 0 && !now.last) return;
        Bytes bytes;
        StateWriter writer([&](const void* data, std::size_t count) {
            const auto* const begin = static_cast<const std::byte*>(data);
            bytes.insert(bytes.end(), begin, begin + count);
        });
        save(writer);
        played.states.push_back(std::move(bytes));
        played.steps.push_back(now.step);
    };
    std::optional<StateReader> reader;
    std::size_t place = 0;
    if (from != nullptr) {
        reader.emplace(
            [&](void* to, std::size_t count) {
                std::memcpy(to, from->data() + place, count);
                place += count;
            },
            from->size());
        options.saved = &*reader;
    }
    played.result = run(scene, options);
    EXPECT_EQ(place, from != nullptr ? from->size() : 0);
    return played;
}

inline bool same(const Raster& a, const Raster& b) {
    return a.values.size() == b.values.size() &&
           (a.values.empty() || std::memcmp(a.values.data(), b.values.data(), a.values.size() * sizeof(double)) == 0);
}

template <class Row>
bool same(const std::vector<Row>& a, const std::vector<Row>& b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(Row)) == 0);
}

inline void expect_same(const RunResult& a, const RunResult& b) {
    ASSERT_EQ(a.rasters.size(), b.rasters.size());
    for (std::size_t i = 0; i < a.rasters.size(); ++i)
        EXPECT_TRUE(same(a.rasters[i].values, b.rasters[i].values)) << a.rasters[i].name;
    EXPECT_TRUE(same(a.series, b.series));
    EXPECT_TRUE(same(a.gauges, b.gauges));
    EXPECT_TRUE(same(a.sections, b.sections));
    for (std::int64_t RunResult::*number :
         {&RunResult::steps, &RunResult::particles_initial, &RunResult::particles_final, &RunResult::particles_peak,
          &RunResult::particle_steps, &RunResult::unsupported})
        EXPECT_EQ(a.*number, b.*number);
    for (double RunResult::*number :
         {&RunResult::simulated_seconds, &RunResult::volume_initial, &RunResult::volume_final, &RunResult::volume_left,
          &RunResult::volume_entered, &RunResult::volume_inflow, &RunResult::volume_eroded,
          &RunResult::volume_deposited, &RunResult::volume_detrained, &RunResult::momentum_deposited,
          &RunResult::thin_fraction, &RunResult::moving_fraction_limit, &RunResult::volume_shown})
        EXPECT_EQ(std::bit_cast<std::uint64_t>(a.*number), std::bit_cast<std::uint64_t>(b.*number));
    EXPECT_EQ(a.stop_reason, b.stop_reason);
    ASSERT_EQ(a.settling.has_value(), b.settling.has_value());
    if (a.settling) {
        for (double Settling::*number :
             {&Settling::window, &Settling::runout, &Settling::area, &Settling::deposit, &Settling::deposit_error})
            EXPECT_EQ(std::bit_cast<std::uint64_t>(*a.settling.*number),
                      std::bit_cast<std::uint64_t>(*b.settling.*number));
        EXPECT_EQ(a.settling->front_is_final, b.settling->front_is_final);
    }
    EXPECT_EQ(a.hard_events.non_finite, b.hard_events.non_finite);
    EXPECT_EQ(a.hard_events.depth_clamped, b.hard_events.depth_clamped);
    EXPECT_EQ(a.hard_events.entered_no_data, b.hard_events.entered_no_data);
    EXPECT_EQ(a.terms, b.terms);
    EXPECT_EQ(a.notes, b.notes);
    for (std::size_t i = 0; i < a.released.size(); ++i) EXPECT_EQ(a.released[i].failed, b.released[i].failed);
}

// Compares all but the wall time, which comes first.
inline bool same_state(const Bytes& a, const Bytes& b) {
    return a.size() == b.size() && std::equal(a.begin() + sizeof(double), a.end(), b.begin() + sizeof(double));
}

}  // namespace frana
