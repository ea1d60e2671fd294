// SPDX-License-Identifier: Apache-2.0
#include "simulation/recorder.h"

#include <algorithm>
#include <cmath>

#include "mpm/node_grid.h"
#include "mpm/shown_depth.h"

namespace frana {

Recorder::Recorder(const Recording& recording, const GridSpec& grid, const Numerics& numerics)
    : intensity_(recording.intensity),
      metric_(numerics.slope_correction != SlopeCorrection::none),
      interval_(recording.interval),
      minimum_depth_(numerics.minimum_depth),
      gravity_(numerics.gravity),
      cell_size_(grid.cell_size) {
    const std::int64_t stride = grid.columns + 2 * k_ghost;
    if (intensity_) {
        const auto nodes = static_cast<std::size_t>(stride * (grid.rows + 2 * k_ghost));
        flux_ = ZeroArray<double>(nodes);
        head_ = ZeroArray<double>(nodes);
    }
    // By indices relative to the origin.
    const auto node_at = [&](std::int64_t i, std::int64_t j) {
        i = std::clamp<std::int64_t>(i + grid.origin_column, 0, grid.columns - 1);
        j = std::clamp<std::int64_t>(j + grid.origin_row, 0, grid.rows - 1);
        return static_cast<std::size_t>((j + k_ghost) * stride + i + k_ghost);
    };
    for (const Gauge& gauge : recording.gauges) {
        const Point local = grid.local_from_map(gauge.place);
        places_.push_back(node_at(static_cast<std::int64_t>(std::floor(local.x / cell_size_)),
                                  static_cast<std::int64_t>(std::floor(local.y / cell_size_))));
    }
    // Two pieces per cell: a bilinear field is integrated along the line with an error of second order.
    const double longest = cell_size_ / 2;
    for (const CrossSection& section : recording.sections) {
        Line line;
        for (std::size_t k = 1; k < section.line.size(); ++k) {
            const Point a = grid.local_from_map(section.line[k - 1]), b = grid.local_from_map(section.line[k]);
            const double length = std::hypot(b.x - a.x, b.y - a.y);
            const int count = static_cast<int>(std::ceil(length / longest));
            for (int p = 0; p < count; ++p) {
                const double t = (p + 0.5) / count;
                const double x = (a.x + t * (b.x - a.x)) / cell_size_ - 0.5;
                const double y = (a.y + t * (b.y - a.y)) / cell_size_ - 0.5;
                const auto i = static_cast<std::int64_t>(std::floor(x)), j = static_cast<std::int64_t>(std::floor(y));
                const double fx = x - static_cast<double>(i), fy = y - static_cast<double>(j);
                line.pieces.push_back({{{node_at(i, j), (1 - fx) * (1 - fy)},
                                        {node_at(i + 1, j), fx * (1 - fy)},
                                        {node_at(i, j + 1), (1 - fx) * fy},
                                        {node_at(i + 1, j + 1), fx * fy}},
                                       (b.y - a.y) / count,
                                       -(b.x - a.x) / count,
                                       length / count});
            }
        }
        lines_.push_back(std::move(line));
    }
}

Recorder::NodeState Recorder::state_of(const Flow& flow, std::size_t node) const {
    const NodeGrid& nodes = flow.nodes();
    const NodeMotion& motion = nodes.motion()[node];
    if (!(motion.mass > 0)) return {};
    NodeState state;
    state.depth = shown_depth(nodes, node);
    state.volume_depth = motion.mass / (cell_size_ * cell_size_);
    const Point gathered = flow.gathered_velocity(node);
    state.u = gathered.x;
    state.v = gathered.y;
    state.moved_x = state.volume_depth * motion.u;
    state.moved_y = state.volume_depth * motion.v;
    state.speed = flow.speed_along_bed(node, gathered);
    return state;
}

Recorder::NodeState Recorder::state_of(const StructuredFlow& flow, std::size_t node) const {
    const StructuredFlow::Column column = flow.column(node);
    if (!(column.depth > 0)) return {};
    NodeState state;
    state.depth = state.volume_depth = column.depth;
    state.moved_x = column.qx;
    state.moved_y = column.qy;
    state.u = state.moved_x / state.depth;
    state.v = state.moved_y / state.depth;
    state.speed = flow.speed(node);
    return state;
}

template <class AnyFlow>
SectionRow Recorder::row_of(const AnyFlow& flow, std::size_t section, double time) const {
    SectionRow row;
    row.time = time;
    row.section = section;
    for (const Piece& piece : lines_[section].pieces) {
        double flux_x = 0, flux_y = 0, depth = 0, speed = 0;
        for (const Fraction& fraction : piece.fractions) {
            const NodeState state = state_of(flow, fraction.node);
            // The flux uses the volume in the cell, not the depth on maps.
            flux_x += fraction.weight * state.volume_depth * state.u;
            flux_y += fraction.weight * state.volume_depth * state.v;
            depth += fraction.weight * state.depth;
            speed += fraction.weight * state.speed;
        }
        row.discharge += flux_x * piece.normal_x + flux_y * piece.normal_y;
        if (depth < minimum_depth_) continue;
        row.wetted_width += piece.length;
        row.max_depth = std::max(row.max_depth, depth);
        row.max_speed = std::max(row.max_speed, speed);
    }
    return row;
}

template <class AnyFlow>
double Recorder::passing(const AnyFlow& flow, std::size_t section) const {
    double sum = 0;
    for (const Piece& piece : lines_[section].pieces) {
        for (const Fraction& fraction : piece.fractions) {
            const NodeState state = state_of(flow, fraction.node);
            sum += fraction.weight * (state.moved_x * piece.normal_x + state.moved_y * piece.normal_y);
        }
    }
    return sum;
}

template <class AnyFlow>
void Recorder::add_rows(const AnyFlow& flow, double time) {
    for (std::size_t g = 0; g < places_.size(); ++g) {
        const NodeState state = state_of(flow, places_[g]);
        const bool reached = state.depth >= minimum_depth_;
        gauge_rows_.push_back({time, g, reached ? state.depth : 0, reached ? state.speed : 0});
    }
    for (std::size_t s = 0; s < lines_.size(); ++s) {
        section_rows_.push_back(row_of(flow, s, time));
        section_rows_.back().volume = lines_[s].volume;
    }
}

template <class AnyFlow>
void Recorder::fold_intensity(const AnyFlow& flow) {
    flow.for_each_active_node([&](std::size_t node) {
        const NodeState state = state_of(flow, node);
        if (state.depth < minimum_depth_) return;
        flux_[node] = std::max(flux_[node], state.depth * state.speed);
        head_[node] = std::max(head_[node], state.depth + state.speed * state.speed / (2 * gravity_));
    });
}

template <class AnyFlow>
void Recorder::record(const AnyFlow& flow, double time, double dt) {
    if (intensity_) fold_intensity(flow);
    const bool due = interval_ <= 0 || time >= next_row_ * (1 - 1e-12);
    if (due) {
        add_rows(flow, time);
        if (interval_ > 0) next_row_ = interval_ * (std::floor(time / interval_ * (1 + 1e-12)) + 1);
    }
    for (std::size_t s = 0; s < lines_.size(); ++s) lines_[s].volume += dt * passing(flow, s);
}

template <class AnyFlow>
void Recorder::move_to(const AnyFlow& flow, RunResult& result) {
    result.gauges = std::move(gauge_rows_);
    result.sections = std::move(section_rows_);
    if (!intensity_) return;
    Raster fluxes = flow.to_raster(flux_), heads = flow.to_raster(head_);
    // A cell reached without motion has a flux of zero, not "no data"; a head is at least the depth.
    result.raster("max_depth").values.for_each_stored([&](std::size_t cell, double depth) {
        if (std::isnan(depth)) return;
        double &flux = fluxes.values[cell], &head = heads.values[cell];
        if (std::isnan(flux)) flux = 0;
        if (!(head >= depth)) head = depth;
    });
    result.add("max_flux", std::move(fluxes));
    result.add("max_head", std::move(heads));
}

template void Recorder::record(const Flow&, double, double);
template void Recorder::record(const StructuredFlow&, double, double);
template void Recorder::move_to(const Flow&, RunResult&);
template void Recorder::move_to(const StructuredFlow&, RunResult&);

}  // namespace frana
