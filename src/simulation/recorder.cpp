// SPDX-License-Identifier: Apache-2.0
#include "simulation/recorder.h"

#include <algorithm>
#include <cmath>

#include "mpm/node_grid.h"
#include "params/keys/result_rasters.h"

namespace frana {

std::span<const Peak> peaks() {
    static constexpr Peak k_peaks[] = {
        {RasterName::max_flux, [](double depth, double speed, double) { return depth * speed; }},
        {RasterName::max_head,
         [](double depth, double speed, double gravity) { return depth + speed * speed / (2 * gravity); }},
        {RasterName::max_momentum_flux, [](double depth, double speed, double) { return depth * speed * speed; }}};
    return k_peaks;
}

Recorder::Recorder(const Recording& recording, const GridSpec& grid, const Numerics& numerics)
    : intensity_(recording.intensity),
      interval_(recording.interval),
      minimum_depth_(numerics.minimum_depth),
      gravity_(numerics.gravity),
      peaks_(peaks().size()) {
    const double cell_size = grid.cell_size;
    const std::int64_t stride = grid.columns + 2 * k_ghost;
    if (intensity_) {
        const auto nodes = static_cast<std::size_t>(stride * (grid.rows + 2 * k_ghost));
        for (ZeroArray<double>& peak : peaks_) peak = ZeroArray<double>(nodes);
    }
    // By indices relative to the origin.
    const auto node_at = [&](std::int64_t i, std::int64_t j) {
        i = std::clamp<std::int64_t>(i + grid.origin_column, 0, grid.columns - 1);
        j = std::clamp<std::int64_t>(j + grid.origin_row, 0, grid.rows - 1);
        return static_cast<std::size_t>((j + k_ghost) * stride + i + k_ghost);
    };
    for (const Gauge& gauge : recording.gauges) {
        const Point local = grid.local_from_map(gauge.place);
        places_.push_back(node_at(static_cast<std::int64_t>(std::floor(local.x / cell_size)),
                                  static_cast<std::int64_t>(std::floor(local.y / cell_size))));
    }
    // Two pieces per cell: a bilinear field is integrated along the line with an error of second order.
    const double longest = cell_size / 2;
    for (const CrossSection& section : recording.sections) {
        Line line;
        for (std::size_t k = 1; k < section.line.size(); ++k) {
            const Point a = grid.local_from_map(section.line[k - 1]), b = grid.local_from_map(section.line[k]);
            const double length = std::hypot(b.x - a.x, b.y - a.y);
            const int count = static_cast<int>(std::ceil(length / longest));
            for (int p = 0; p < count; ++p) {
                const double t = (p + 0.5) / count;
                const double x = (a.x + t * (b.x - a.x)) / cell_size - 0.5;
                const double y = (a.y + t * (b.y - a.y)) / cell_size - 0.5;
                const auto i = static_cast<std::int64_t>(std::floor(x)), j = static_cast<std::int64_t>(std::floor(y));
                const double fx = x - static_cast<double>(i), fy = y - static_cast<double>(j);
                for (const std::int64_t up : {0, 1})
                    for (const std::int64_t right : {0, 1}) line.nodes.push_back(node_at(i + right, j + up));
                line.pieces.push_back({{(1 - fx) * (1 - fy), fx * (1 - fy), (1 - fx) * fy, fx * fy},
                                       (b.y - a.y) / count,
                                       -(b.x - a.x) / count,
                                       length / count});
            }
        }
        lines_.push_back(std::move(line));
    }
}

SectionRow Recorder::row_of(const Line& line, const std::vector<NodeState>& states) const {
    SectionRow row;
    const NodeState* state = states.data();
    for (const Piece& piece : line.pieces) {
        double flux_x = 0, flux_y = 0, depth = 0, speed = 0;
        for (const double weight : piece.weights) {
            // The flux uses the volume in the cell, not the depth on maps.
            flux_x += weight * state->volume_depth * state->u;
            flux_y += weight * state->volume_depth * state->v;
            depth += weight * state->depth;
            speed += weight * state->speed;
            ++state;
        }
        row.discharge += flux_x * piece.normal_x + flux_y * piece.normal_y;
        if (depth < minimum_depth_) continue;
        row.wetted_width += piece.length;
        row.max_depth = std::max(row.max_depth, depth);
        row.max_speed = std::max(row.max_speed, speed);
    }
    return row;
}

void Recorder::add_gauges(const Model& model, double time) {
    std::vector<NodeState> states(places_.size());
    model.states(places_, states.data());
    for (std::size_t g = 0; g < places_.size(); ++g) {
        const bool reached = states[g].depth >= minimum_depth_;
        gauge_rows_.push_back({time, g, reached ? states[g].depth : 0, reached ? states[g].speed : 0});
    }
}

void Recorder::fold_intensity(const Model& model) {
    const std::span<const Peak> all = peaks();
    model.for_each_active_state([&](std::size_t node, const NodeState& state) {
        if (state.depth < minimum_depth_) return;
        for (std::size_t k = 0; k < all.size(); ++k)
            peaks_[k][node] = std::max(peaks_[k][node], all[k].of(state.depth, state.speed, gravity_));
    });
}

void Recorder::record(const Model& model, double time, double dt) {
    if (intensity_) fold_intensity(model);
    const bool due = interval_ <= 0 || time >= next_row_ * (1 - 1e-12);
    if (due) add_gauges(model, time);
    std::vector<NodeState> states;
    for (std::size_t s = 0; s < lines_.size(); ++s) {
        Line& line = lines_[s];
        states.resize(line.nodes.size());
        model.states(line.nodes, states.data());
        if (due) {
            SectionRow& row = section_rows_.emplace_back(row_of(line, states));
            row.time = time;
            row.section = s;
            row.volume = line.volume;
        }
        double passing = 0;  // by the velocities of the motion [m3/s]
        const NodeState* state = states.data();
        for (const Piece& piece : line.pieces)
            for (const double weight : piece.weights) {
                passing += weight * (state->moved_x * piece.normal_x + state->moved_y * piece.normal_y);
                ++state;
            }
        line.volume += dt * passing;
    }
    if (due && interval_ > 0) next_row_ = interval_ * (std::floor(time / interval_ * (1 + 1e-12)) + 1);
}

void Recorder::move_to(const Model& model, RunResult& result) {
    result.gauges = std::move(gauge_rows_);
    result.sections = std::move(section_rows_);
    if (!intensity_) return;
    for (std::size_t k = 0; k < peaks_.size(); ++k) {
        Raster peak = model.to_raster(peaks_[k]);
        result.raster(RasterName::max_depth).values.for_each_stored([&](std::size_t cell, double depth) {
            if (std::isnan(depth)) return;
            const double least = peaks()[k].of(depth, 0, gravity_);  // in a cell that was reached, also without motion
            if (!(peak.values[cell] >= least)) peak.values[cell] = least;
        });
        result.add(peaks()[k].name, std::move(peak));
    }
}

}  // namespace frana
