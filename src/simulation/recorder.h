// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/zero_array.h"
#include "simulation/model.h"
#include "simulation/result.h"
#include "simulation/scene.h"

namespace frana {

/// A maximum over time of what follows from depth [m], speed [m/s] and gravity [m/s2], as a raster. Besides, its row in
/// params/keys/result_rasters.cpp.
struct Peak {
    const char* name;
    double (*of)(double depth, double speed, double gravity);
};
std::span<const Peak> peaks();

/// Records the outputs of a scene besides the maxima, from the nodes after each step. For a model that does not show
/// the end of a step, the state after the very last one is not recorded.
class Recorder {
  public:
    Recorder(const Recording& recording, const GridSpec& grid, const Numerics& numerics);

    /// Whether there is nothing to do.
    [[nodiscard]] bool idle() const noexcept { return !intensity_ && places_.empty() && lines_.empty(); }
    /// Records a step of length `dt`; `time` is that of the state on the model's nodes [s].
    void record(const Model& model, double time, double dt);
    /// Moves the rows and rasters into the result.
    void move_to(const Model& model, RunResult& result);

    /// The records so far.
    template <class Archive>
    void serialise(Archive& archive) {
        [[maybe_unused]] auto& [intensity, interval, minimum_depth, gravity, next_row, places, lines, gauge_rows,
                                section_rows, peaks] = *this;
        archive(next_row, gauge_rows, section_rows);
        for (ZeroArray<double>& peak : peaks) archive(peak);
        for (Line& line : lines) archive(line.volume);
        if constexpr (Archive::k_reads) {
            for (const GaugeRow& row : gauge_rows) archive.require(row.gauge < places.size());
            for (const SectionRow& row : section_rows) archive.require(row.section < lines.size());
        }
    }

  private:
    /// A short piece of a line.
    struct Piece {
        std::array<double, 4> weights;  ///< of the nodes around its middle
        double normal_x, normal_y;      ///< to the right, times the piece's length [m]
        double length;
    };
    struct Line {
        std::vector<Piece> pieces;
        std::vector<std::size_t> nodes;  ///< four of each piece
        double volume = 0;
    };

    [[nodiscard]] SectionRow row_of(const Line& line, const std::vector<NodeState>& states) const;
    void add_gauges(const Model& model, double time);
    void fold_intensity(const Model& model);

    bool intensity_;
    double interval_, minimum_depth_, gravity_;
    double next_row_ = 0;
    std::vector<std::size_t> places_;  ///< nodes of the gauges
    std::vector<Line> lines_;
    std::vector<GaugeRow> gauge_rows_;
    std::vector<SectionRow> section_rows_;
    std::vector<ZeroArray<double>> peaks_;  ///< one for each of peaks()
};

}  // namespace frana
