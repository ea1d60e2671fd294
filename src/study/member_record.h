// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/grid_spec.h"
#include "core/raster.h"
#include "simulation/result.h"
#include "simulation/run_values.h"
#include "simulation/scene.h"

namespace frana::study {

/// A value of a member that studies compare; the same ones in the same order for every member of a study.
struct Figure {
    std::string key;    ///< "runout_m", "gauge bridge: max_depth_m"
    std::string title;  ///< "run-out"
    std::string unit;
    double value = 0;
};

template <class Archive>
void serialise(Archive& archive, Figure& figure) {
    auto& [key, title, unit, value] = figure;
    archive(key, title, unit, value);
}

/// Consecutive cells of a row or of several.
struct CellRun {
    std::uint64_t first = 0, count = 0;
};

template <class Archive>
void serialise(Archive& archive, CellRun& run) {
    archive(run.first, run.count);
}

/// Maxima that a member's flow left behind, where it came; as in the Float32 rasters of a run.
enum class Quantity { depth, velocity, arrival };

/// All that is kept of a member.
struct MemberRecord {
    std::uint64_t member = 0;
    std::string failure;                        ///< why its figures and maps are not used; empty: it is finished
    std::vector<Figure> figures;                ///< empty where it failed before its first step
    double engine_seconds = 0;                  ///< wall time: the only value that differs between two runs of a member
    double west = 0, north = 0, cell_size = 1;  ///< of its working grid
    std::int64_t columns = 0, rows = 0;
    std::vector<CellRun> runs;    ///< cells of that grid that the flow reached, in order
    std::vector<float> depth;     ///< of these cells: maximum, vertical [m]
    std::vector<float> velocity;  ///< maximum, along the bed [m/s]
    std::vector<float> arrival;   ///< [s]

    [[nodiscard]] bool finished() const noexcept { return failure.empty(); }
    [[nodiscard]] const std::vector<float>& of(Quantity quantity) const noexcept {
        return quantity == Quantity::depth ? depth : quantity == Quantity::velocity ? velocity : arrival;
    }
    /// Returns a quantity as a raster on a grid with the same lattice of cells; NaN where the flow did not come.
    [[nodiscard]] Raster raster(Quantity quantity, const GridSpec& grid) const;
    /// Returns row and column of its grid's north-western cell in another grid. Throws Error(input) if the cells of the
    /// two do not coincide.
    [[nodiscard]] CellWindow place_in(const GridSpec& grid) const;
    /// Calls visit(row, column, index) for the cells that the flow reached, by rows and columns of such a grid, which
    /// may be outside it; `index` is the cell's place in depth, velocity and arrival.
    template <class Visit>
    void for_each_cell(const GridSpec& grid, const Visit& visit) const {
        const CellWindow place = place_in(grid);
        std::size_t index = 0;
        for (const CellRun& run : runs) {
            for (std::uint64_t cell = run.first; cell < run.first + run.count; ++cell, ++index)
                visit(static_cast<std::int64_t>(cell) / columns + place.row,
                      static_cast<std::int64_t>(cell) % columns + place.column, index);
        }
    }
};

template <class Archive>
void serialise(Archive& archive, MemberRecord& record) {
    archive(record.member, record.failure, record.figures, record.engine_seconds, record.west, record.north,
            record.cell_size, record.columns, record.rows, record.runs, record.depth, record.velocity, record.arrival);
}

/// Returns a record without figures and cells, of a member on a grid.
MemberRecord empty_record(std::uint64_t member, const GridSpec& grid);
/// Returns the record of a run.
/// @param threshold depth from which a cell belongs to the covered area [m]
MemberRecord record_of(std::uint64_t member, const RunResult& result, const Scene& scene, double threshold);

/// Writes a record aside, syncs it to the disk and renames it. Throws Error(environment).
///
///     8 bytes "frana mb", format, bytes of the rest | record | CRC-32 of all before
void write_record(const std::string& path, MemberRecord record);

/// Returns a record whose every byte has been checked; none if the file does not exist, is damaged, or has another
/// format.
std::optional<MemberRecord> read_record(const std::string& path);

}  // namespace frana::study
