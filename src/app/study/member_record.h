// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "analysis/hazard.h"
#include "core/grid_spec.h"
#include "core/raster.h"
#include "core/words/sentence.h"
#include "simulation/result.h"
#include "simulation/run_summary.h"
#include "simulation/scene.h"

namespace frana::app::study {

/// A value of a member that studies compare; the same ones in the same order for every member of a study.
struct Figure {
    std::string key;  ///< "runout_m", "gauge bridge: max_depth_m"
    Sentence title;   ///< "run-out"
    std::string unit;
    double value = 0;
};

template <class Archive>
void serialise(Archive& archive, Figure& figure) {
    auto& [key, title, unit, value] = figure;
    archive(key, title, unit, value);
}

/// Returns the value of a figure; NaN if there is none of this key.
double value_of(const std::vector<Figure>& figures, const std::string& key);

/// Consecutive cells of a row or of several.
struct CellRun {
    std::uint64_t first = 0, count = 0;
};

template <class Archive>
void serialise(Archive& archive, CellRun& run) {
    archive(run.first, run.count);
}

/// What a member's flow left behind, where it came; as in the Float32 rasters of a run. After the first three each is
/// kept only if something is made of it (RecordExtras).
enum class Quantity {
    depth,      ///< maximum, vertical [m]
    velocity,   ///< maximum, along the bed [m/s]
    arrival,    ///< [s]
    pressure,   ///< maximum [kPa]
    intensity,  ///< class
    deposit,    ///< what a surveyed one is compared with, vertical [m]
    momentum    ///< maximum of depth times speed squared [m3/s2]
};
inline constexpr std::size_t k_quantities = 7, k_least_quantities = 3;

/// The key with which `frana run` repeats a member that ran on.
inline constexpr const char* k_end_key = "time.end";

/// Columns of a table of members with what MemberEnd holds besides its end, its number of warnings the last.
inline constexpr const char* k_end_columns[] = {"stop_reason",     "moving_fraction", "left_domain_fraction",
                                                "held_by_no_data", "energy_error",    "warnings"};

/// How a member's run ended, and what it warned of: what one run tells must reach the study's maps.
struct MemberEnd {
    std::string stop_reason;     ///< as in summary.json; empty: it could not start
    double end = 0;              ///< time.end of its run [s]: more than the scene's if it ran on
    bool is_cut = false;         ///< the front still moved when the run was stopped (motion_at_end)
    double moving_fraction = 0;  ///< of the volume
    double left_fraction = 0;    ///< of the volume, through the edges of the computed ground
    bool is_held = false;        ///< by cells without elevation (gap_contact)
    double energy_error = 0;     ///< NaN: not known
    Warnings warnings;

    /// Whether the full run-out is not known.
    [[nodiscard]] bool left() const noexcept { return left_fraction > k_left_ground; }
    /// Whether what it reached is a lower bound of what it would have.
    [[nodiscard]] bool is_open() const noexcept { return is_cut || is_held || left(); }
};

template <class Archive>
void serialise(Archive& archive, MemberEnd& end) {
    archive(end.stop_reason, end.end, end.is_cut, end.moving_fraction, end.left_fraction, end.is_held, end.energy_error,
            end.warnings);
}

/// All that is kept of a member.
struct MemberRecord {
    std::size_t member = 0;
    std::string key_values;  ///< "key=value" line by line, files without their folders
    MemberEnd end;
    std::string failure;                        ///< why its figures and maps are not used; empty: it is finished
    std::vector<Figure> figures;                ///< empty where it failed before its first step
    double engine_seconds = 0;                  ///< wall time: the only value that differs between two runs of a member
    std::int64_t particle_steps = 0;            ///< work of the engine, the same in every run
    double west = 0, north = 0, cell_size = 1;  ///< of its working grid
    std::int64_t columns = 0, rows = 0;
    std::vector<CellRun> runs;  ///< cells of that grid that the flow reached, in order
    /// By Quantity, of these cells; empty where nothing is made of it.
    std::array<std::vector<float>, k_quantities> values;

    /// Its grid, without CRS.
    [[nodiscard]] GridSpec grid() const { return {west, north, cell_size, columns, rows, {}}; }
    [[nodiscard]] bool finished() const noexcept { return failure.empty(); }
    [[nodiscard]] const std::vector<float>& of(Quantity quantity) const noexcept {
        return values[static_cast<std::size_t>(quantity)];
    }
    [[nodiscard]] std::vector<float>& of(Quantity quantity) noexcept {
        return values[static_cast<std::size_t>(quantity)];
    }
    /// Returns a quantity as a raster on a grid in which it has a place; NaN where the flow did not come.
    [[nodiscard]] Raster raster(Quantity quantity, const GridSpec& grid) const;
    /// Returns its grid's place in another grid with the same cells. Throws Error(input) if it has others.
    [[nodiscard]] CellWindow place_in(const GridSpec& grid) const;
    /// Returns the window of the cells that the flow reached, in rows and columns of such a grid; empty if there are
    /// none.
    [[nodiscard]] CellWindow reached(const GridSpec& grid) const;
    /// Calls visit(row, column, index) for the cells that the flow reached, by rows and columns of such a grid, which
    /// may be outside it. `index` is the cell's place in each of `values`.
    template <class Visit>
    void for_each_cell(const GridSpec& grid, const Visit& visit) const {
        const CellWindow place = place_in(grid);
        std::size_t index = 0;
        for (const CellRun& run : runs) {
            for (std::uint64_t cell = run.first; cell < run.first + run.count; ++cell, ++index) {
                const auto at = static_cast<std::int64_t>(cell);
                visit(at / columns + place.row, at % columns + place.column, index);
            }
        }
    }
};

template <class Archive>
void serialise(Archive& archive, MemberRecord& record) {
    archive(record.member, record.key_values, record.end, record.failure, record.figures, record.engine_seconds,
            record.particle_steps, record.west, record.north, record.cell_size, record.columns, record.rows,
            record.runs, record.values);
}

/// Returns a record without figures and cells, of a member on a grid.
MemberRecord empty_record(std::uint64_t member, const GridSpec& grid);
/// Returns all of a record but its cells.
MemberRecord without_cells(MemberRecord record);

/// What a surveyed deposit is compared with: an outline with the depth at the end, a change of elevation with the
/// run's.
enum class Deposit { none, final_depth, elevation_change };

/// What a record contains only if something is made of it.
struct RecordExtras {
    bool pressure = false;
    std::optional<HazardScheme> scheme = {};  ///< of the classes of intensity
    Deposit deposit = Deposit::none;
    bool momentum = false;
};
/// Returns the record of a run.
/// @param threshold depth from which a cell belongs to the covered area [m]
MemberRecord record_of(std::uint64_t member, const RunResult& result, const Scene& scene, double threshold,
                       const RecordExtras& extras = {});

}  // namespace frana::app::study
