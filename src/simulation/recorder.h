// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "simulation/flow.h"
#include "simulation/result.h"
#include "simulation/scene.h"
#include "simulation/structured_flow.h"

namespace frana {

/// Records what a scene asks for beyond the maxima, from the nodes as each step leaves them. A Flow's show
/// the depth and the velocity that the particles brought (as the maxima see it), at the moment the step
/// began, and what the very last step leads to is not seen. A StructuredFlow's cells show the end of the
/// step.
class Recorder {
  public:
    Recorder(const Recording& recording, const GridSpec& grid, const Numerics& numerics);

    /// Whether there is nothing to do.
    [[nodiscard]] bool idle() const noexcept { return !intensity_ && places_.empty() && lines_.empty(); }
    /// After a step that took `dt`; `time` is when the flow's nodes were as they show now [s].
    template <class AnyFlow>
    void record(const AnyFlow& flow, double time, double dt);
    /// Moves the rows and rasters into the result.
    template <class AnyFlow>
    void move_to(const AnyFlow& flow, RunResult& result);

    /// What it has seen.
    template <class Archive>
    void serialise(Archive& archive) {
        [[maybe_unused]] auto& [intensity, metric, interval, minimum_depth, gravity, cell_size, next_row, places, lines,
                                gauge_rows, section_rows, flux, head] = *this;
        archive(next_row, gauge_rows, section_rows, flux, head);
        for (Line& line : lines) archive(line.volume);
        if constexpr (Archive::k_reads) {
            for (const GaugeRow& row : gauge_rows) archive.require(row.gauge < places.size());
            for (const SectionRow& row : section_rows) archive.require(row.section < lines.size());
        }
    }

  private:
    /// One node with its fraction of a sample.
    struct Fraction {
        std::size_t node;
        double weight;
    };
    /// A short piece of a line.
    struct Piece {
        Fraction fractions[4];      ///< the nodes round its middle
        double normal_x, normal_y;  ///< to the right, times the piece's length [m]
        double length;
    };
    struct Line {
        std::vector<Piece> pieces;
        double volume = 0;
    };
    struct NodeState {
        double depth = 0;         ///< that is shown [m]
        double volume_depth = 0;  ///< volume over cell area, which is what passes [m]
        double u = 0, v = 0, speed = 0;
        double moved_x = 0, moved_y = 0;  ///< discharge per width by the velocities that moved it [m2/s]
    };

    [[nodiscard]] NodeState state_of(const Flow& flow, std::size_t node) const;
    [[nodiscard]] NodeState state_of(const StructuredFlow& flow, std::size_t node) const;
    /// Volume that the step just done moves through a section [m3/s], by the velocities that moved it.
    template <class AnyFlow>
    [[nodiscard]] double passing(const AnyFlow& flow, std::size_t section) const;
    template <class AnyFlow>
    [[nodiscard]] SectionRow row_of(const AnyFlow& flow, std::size_t section, double time) const;
    template <class AnyFlow>
    void add_rows(const AnyFlow& flow, double time);
    template <class AnyFlow>
    void fold_intensity(const AnyFlow& flow);

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
