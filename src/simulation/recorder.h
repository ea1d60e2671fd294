// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "simulation/flow.h"
#include "simulation/result.h"
#include "simulation/scene.h"

namespace frana {

/// Records what a scene asks for beyond the maxima, from the nodes as each step leaves them: their depth,
/// and the velocity that the particles brought (as the maxima see it), at the moment the step began. What the
/// very last step leads to is not seen.
class Recorder {
  public:
    Recorder(const Recording& recording, const GridSpec& grid, const Numerics& numerics);

    /// Whether there is nothing to do.
    [[nodiscard]] bool idle() const noexcept { return !intensity_ && places_.empty() && lines_.empty(); }
    /// After a step that began at `time` and took `dt` [s].
    void see(const Flow& flow, double time, double dt);
    /// Moves the rows and rasters into the result.
    void give(const Flow& flow, RunResult& result);

  private:
    /// One node with its share of a sample.
    struct Share {
        std::size_t node;
        double weight;
    };
    /// A short piece of a line.
    struct Piece {
        Share shares[4];            ///< the nodes round its middle
        double normal_x, normal_y;  ///< to the right, times the piece's length [m]
        double length;
    };
    struct Line {
        std::vector<Piece> pieces;
        double volume = 0;
    };
    struct NodeState {
        double depth = 0, u = 0, v = 0, speed = 0;
    };

    [[nodiscard]] NodeState state_of(const NodeGrid& nodes, std::size_t node) const;
    /// Volume that the step just done moves through a section [m3/s], by the velocities that moved it.
    [[nodiscard]] double passing(const Flow& flow, std::size_t section) const;
    [[nodiscard]] SectionRow row_of(const Flow& flow, std::size_t section, double time) const;
    void add_rows(const Flow& flow, double time);
    void fold_intensity(const Flow& flow);

    bool intensity_, metric_;
    double interval_, minimum_depth_, gravity_, cell_size_;
    double next_row_ = 0;
    std::vector<std::size_t> places_;  ///< nodes of the gauges
    std::vector<Line> lines_;
    std::vector<GaugeRow> gauge_rows_;
    std::vector<SectionRow> section_rows_;
    ZeroArray<double> flux_, head_;
};

}  // namespace frana
