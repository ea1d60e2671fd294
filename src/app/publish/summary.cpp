// SPDX-License-Identifier: Apache-2.0
#include "app/publish/summary.h"

#include <sys/resource.h>

#include <cmath>

#include "app/store/scene_identity.h"
#include "app/text/version.h"
#include "core/json.h"
#include "simulation/run_figures.h"
#include "simulation/simulation.h"
#include "simulation/trouble_watch.h"

namespace frana::app {
namespace {

/// Where nothing ever flowed the greatest value is 0; where nothing is deeper than the threshold the others are null.
void write_high_figures(JsonWriter& json, const HighFigures& high) {
    for (std::size_t i = 0; i < high.size(); ++i) {
        const std::string name = k_high_figures[i].name, unit = std::string("_") + k_high_figures[i].key_unit;
        json.number(name + unit, std::isnan(high[i].greatest) ? 0 : high[i].greatest);
        json.number(name + "_p999" + unit, high[i].p999).number(name + "_p99" + unit, high[i].p99);
    }
}

void write_grid_and_particles(JsonWriter& json, const RunResult& result) {
    const GridSpec& grid = result.max_depth.grid;
    json.begin_object("grid").integer("columns", grid.columns).integer("rows", grid.rows);
    json.number("cell_size", grid.cell_size).number("west", grid.west).number("north", grid.north).end_object();
    json.begin_object("particles").integer("initial", result.particles_initial);
    json.integer("final", result.particles_final).integer("peak", result.particles_peak).end_object();
}

void write_cost(JsonWriter& json, const RunResult& result, const SummaryFacts& facts) {
    json.begin_object("wall_seconds").number("total", facts.wall.total).number("input", facts.wall.input);
    json.number("engine", facts.wall.engine).number("output", facts.wall.output).number("render", facts.wall.render);
    json.end_object();
    json.integer("particle_steps", result.particle_steps);
    json.number("particle_steps_per_second",
                facts.wall.engine > 0 ? static_cast<double>(result.particle_steps) / facts.wall.engine : 0);
    json.integer("bytes_per_particle", result.bytes_per_particle);
    json.integer("bytes_per_node", result.bytes_per_node);
    json.integer("peak_memory_bytes", facts.peak_memory_bytes);
}

void write_phases(JsonWriter& json, const PhaseBudget& budget) {
    const auto volumes = [&](const char* name, const PhaseVolumes& v) {
        json.begin_object(name).number("solids_m3", v.solids).number("confined_water_m3", v.confined);
        json.number("free_water_m3", v.free).end_object();
    };
    json.begin_object("phases");
    volumes("entered", budget.entered);
    volumes("inside", budget.inside);
    volumes("left_domain", budget.left);
    json.number("released_water_m3", budget.released);
    json.number("cohesion_left", budget.cohesion_left);
    json.number("rms_velocity_difference_ms", budget.rms_apart).end_object();
}

void write_figures(JsonWriter& json, const RunResult& result, const SummaryFacts& facts) {
    json.begin_object("volume")
        .number("initial_m3", result.volume_initial)
        .number("entered_m3", result.volume_entered)
        .number("inflow_m3", result.volume_inflow)
        .number("final_m3", result.volume_final)
        .number("final_depth_raster_m3", shown_volume(result))
        .number("greatest_thin_fraction", result.thin_share);
    json.number("left_domain_m3", result.volume_left);
    if (result.exchanges)
        json.number("eroded_m3", result.volume_eroded).number("deposited_m3", result.volume_deposited);
    json.number("relative_error", relative_volume_error(result));
    json.end_object();
    if (result.phases) write_phases(json, *result.phases);
    if (result.exchanges) json.number("deposited_momentum_kg_m_s", result.momentum_deposited);
    if (curvature(facts.spec.numerics)) json.integer("unsupported_node_steps", result.unsupported);
    if (result.jumps) {
        const RunResult::Jumps& jumps = *result.jumps;
        json.begin_object("jumps").number("volume_m3", jumps.volume).number("highest_m", jumps.highest);
        json.number("mean_length_m", jumps.mean)
            .number("longest_m", jumps.longest)
            .number("longest_from_x", jumps.from.x)
            .number("longest_from_y", jumps.from.y);
        json.number("longest_to_x", jumps.to.x).number("longest_to_y", jumps.to.y).end_object();
    }
    json.begin_array("release_areas");
    for (const ReleasedArea& area : result.released) {
        json.begin_object().number("start_s", area.start).number("area_m2", area.area);
        json.number("volume_m3", area.volume).number("thickness_scaled_by", area.scaled);
        json.boolean("failed", area.failed).end_object();
    }
    json.end_array();
    if (result.energy_error) json.number("energy_error", *result.energy_error);
    write_high_figures(json, facts.high);
    const Runout& run_out = facts.figures.run_out;
    json.number("covered_area_m2", facts.figures.covered_area_m2);
    json.number("trace_threshold_m", facts.figures.threshold);
    json.begin_object("runout").number("horizontal_m", run_out.horizontal_m);
    json.number("drop_m", run_out.drop_m).number("reach_angle_deg", run_out.reach_angle_deg);
    json.end_object();
    if (!facts.hazard.empty()) {
        json.begin_array("hazard");
        for (const HazardArea& area : facts.hazard) {
            json.begin_object().integer("class", area.kind.value).text("label", area.kind.label);
            json.number("area_m2", area.area_m2).end_object();
        }
        json.end_array();
    }
    const HardEvents& events = result.hard_events;
    json.begin_object("hard_events").integer("non_finite", events.non_finite);
    json.integer("depth_clamped", events.depth_clamped);
    json.integer("entered_no_data", events.entered_no_data);
    json.integer("impossible_speed", events.impossible_speed);
    json.integer("volume_drift", events.volume_drift).end_object();
    json.begin_array("troubles");
    for (const Trouble& trouble : result.troubles) {
        json.begin_object().integer("step", trouble.step).number("time_s", trouble.time);
        if (trouble.place) json.number("x", trouble.place->x).number("y", trouble.place->y);
        json.text("what", describe(trouble)).end_object();
    }
    json.end_array();
}

}  // namespace

std::string stop_word(StopReason reason) {
    switch (reason) {
        case StopReason::still:
            return "still";
        case StopReason::settled:
            return "settled";
        case StopReason::energy:
            return "energy";
        case StopReason::moving_volume:
            return "moving-volume";
        case StopReason::all_left:
            return "all-left";
        case StopReason::requested:
            return "requested";
        case StopReason::reached_no_data:
            return "reached-no-data";
        case StopReason::non_finite:
            return "non-finite";
        case StopReason::impossible_speed:
            return "impossible-speed";
        case StopReason::volume_drift:
            return "volume-drift";
        case StopReason::end_time:
            break;
    }
    return "end-time";
}

std::int64_t peak_memory_bytes() {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return static_cast<std::int64_t>(usage.ru_maxrss) * 1024;
}

std::string summary_json(const RunResult& result, const SummaryFacts& facts) {
    JsonWriter json;
    json.begin_object();
    json.text("program", k_program).text("version", k_version).integer("format", k_result_format);
    json.text("scene", facts.spec.file);
    json.text("model", facts.spec.material.model).text("scheme", facts.spec.numerics.scheme);
    json.text("slope_correction", slope_correction(facts.spec.numerics));
    json.text("crs", facts.crs_label).integer("threads", facts.threads).integer("steps", result.steps);
    json.number("simulated_seconds", result.simulated_seconds);
    json.text("stop_reason", stop_word(result.stop_reason));
    json.text("stop_reason_text", describe(result.stop_reason));
    json.number("moving_fraction", result.moving_share);
    if (result.settling) {
        const Settling& s = *result.settling;
        json.begin_object("settling").number("window_s", s.window).number("runout_growth_m", s.runout);
        json.number("area_growth", s.area).number("deposit_change", s.deposit);
        json.number("stop_change", facts.spec.time.stop_change).number("stop_window", facts.spec.time.stop_window);
        json.end_object();
    }
    write_grid_and_particles(json, result);
    json.begin_array("terms");
    for (const std::string& term : result.terms) json.text("", term);
    json.end_array();
    write_cost(json, result, facts);
    write_figures(json, result, facts);
    json.begin_array("warnings");
    for (const std::string& warning : facts.warnings) json.text("", warning);
    json.end_array();
    json.begin_array(k_data_key);
    for (const std::string& fact : facts.data_identity) json.text("", fact);
    json.end_array();
    json.end_object();
    return json.str();
}

}  // namespace frana::app
