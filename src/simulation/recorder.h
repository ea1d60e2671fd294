// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "simulation/flow.h"
#include "simulation/result.h"
#include "simulation/scene.h"
#include "simulation/structured_flow.h"

namespace frana {

/// Records the outputs of a scene besides the maxima, from the nodes after each step. For a Flow these are the depth
/// and the velocity gathered from the particles (as for the maxima), at the beginning of the step, so that the state
/// after the very last step is not recorded. A StructuredFlow's cells have the state at the end of the step.
class Recorder {
  public:
    Recorder(const Recording& recording, const GridSpec& grid, const Numerics& numerics);

    /// Whether there is nothing to do.
    [[nodiscard]] bool idle() const noexcept { return !intensity_ && places_.empty() && lines_.empty(); }
    /// Records a step of length `dt`; `time` is that of the state on the flow's nodes [s].
    template <class AnyFlow>
    void record(const AnyFlow& flow, double time, double dt);
    /// Moves the rows and rasters into the result.
    template <class AnyFlow>
    void move_to(const AnyFlow& flow, RunResult& result);

    /// The records so far.
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
    /// One node with its weight in a sample.
    struct Fraction {
        std::size_t node;
        double weight;
    };
    /// A short piece of a line.
    struct Piece {
        Fraction fractions[4];      ///< the nodes around its middle
        double normal_x, normal_y;  ///< to the right, times the piece's length [m]
        double length;
    };
    struct Line {
        std::vector<Piece> pieces;
        double volume = 0;
    };
    struct NodeState {
        double depth = 0;         ///< depth for maps [m]
        double volume_depth = 0;  ///< volume over cell area, which enters the flux [m]
        double u = 0, v = 0, speed = 0;
        double moved_x = 0, moved_y = 0;  ///< discharge per width by the velocities of the motion [m2/s]
    };

    [[nodiscard]] NodeState state_of(const Flow& flow, std::size_t node) const;
    [[nodiscard]] NodeState state_of(const StructuredFlow& flow, std::size_t node) const;
    /// Volume per time through a section in the last step [m3/s], by the velocities of the motion.
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
