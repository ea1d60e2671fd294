// SPDX-License-Identifier: Apache-2.0
#include "app/input/prepare_terrain.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>

#include "analysis/gaussian_field.h"
#include "analysis/ground_statistics.h"
#include "analysis/trace.h"
#include "app/input/memory_bound.h"
#include "app/input/used_file.h"
#include "app/process/machine_memory.h"
#include "app/text/number_text.h"
#include "app/text/run_log.h"
#include "core/error.h"
#include "core/raster.h"
#include "core/text.h"
#include "core/words/words.h"
#include "gis/crs/crs.h"
#include "gis/crs/crs_transform.h"
#include "gis/raster/raster_in.h"
#include "gis/raster/working_grid.h"
#include "params/scene/read_scene.h"

namespace frana::app {
namespace {

// Lengths wrong by 1 % make areas and volumes wrong by 2 %, as much as a survey's error. UTM stays within 0.1 %.
constexpr double k_largest_scale_error = 0.01;

Point centre_of(const Bounds& bounds) {
    return {(bounds.west + bounds.east) / 2, (bounds.south + bounds.north) / 2};
}

Sentence scale_of(const gis::MapScale& scale) {
    const Sentence least = numeral(number_text(scale.least, 5));
    if (scale.greatest - scale.least < 1e-4) return least;
    return worded("{1} to {2} by direction", {least, numeral(number_text(scale.greatest, 5))});
}

/// Returns the working CRS named by terrain.crs, which must measure the ground in metres at the DTM.
std::string requested_crs(const SceneReading& reading, const gis::RasterInfo& dtm) {
    const Place where = reading.where("terrain.crs"), requested = reading.scene.terrain.crs;
    const std::string crs = reading.session.read(gis::crs_from_user, requested, where);
    if (!reading.session.read(gis::is_projected_in_metres, crs)) {
        throw Error(ErrorKind::input,
                    Problem{"is not a projected system in metres with axes east and north", where, requested,
                            "a projected CRS in metres, such as a UTM zone", "Choose another, or remove the key"});
    }
    std::string horizontal = reading.session.read(gis::horizontal_crs, crs);
    if (dtm.crs_wkt.empty()) return horizontal;
    const Point centre = centre_of(dtm.bounds);
    const gis::CrsTransform to_working(dtm.crs_wkt, horizontal, Bounds{centre.x, centre.y, centre.x, centre.y});
    const gis::MapScale scale = reading.session.read(gis::map_scale, horizontal, to_working(centre));
    if (scale.error() > k_largest_scale_error) {
        throw Error(ErrorKind::input, Problem{"lengths in this system are not lengths on the ground", where,
                                              requested + " with a scale of " + scale_of(scale).text() + " at the DTM",
                                              "a scale within 1 % of 1", "Choose a UTM zone, or remove the key"});
    }
    return horizontal;
}

/// Without a CRS coordinates must be in metres.
void check_local(const SceneReading& reading, const gis::RasterInfo& dtm) {
    if (dtm.crs_wkt.empty() || reading.session.read(gis::is_projected_in_metres, dtm.crs_wkt)) return;
    throw Error(ErrorKind::input,
                Problem{"the DTM's coordinates are not in metres, so they cannot be used as they are",
                        reading.where("terrain.crs"), "local", "", "Remove the key: frana then chooses a UTM zone"});
}

std::string automatic_crs(const SceneReading& reading, const gis::RasterInfo& dtm, Findings found) {
    const Point centre = centre_of(dtm.bounds);
    if (reading.session.read(gis::is_projected_in_metres, dtm.crs_wkt)) {
        std::string own = reading.session.read(gis::horizontal_crs, dtm.crs_wkt);
        const gis::MapScale scale = reading.session.read(gis::map_scale, own, centre);
        if (scale.error() <= k_largest_scale_error) return own;
        found.warn(worded("DTM: scale {2} in {1}: computed in the UTM zone", {dtm.crs_label, scale_of(scale)}));
    }
    const Point degrees = reading.session.read(gis::to_longitude_latitude, dtm.crs_wkt, centre);
    return reading.session.read(gis::utm_crs_for, degrees.x, degrees.y);
}

/// Returns the working CRS (WKT): that of terrain.crs, else the DTM's own if projected, in metres and true to scale,
/// else the UTM zone of the DTM's centre. Empty: local. Throws Error(input) with the remedy if there is none, or if
/// lengths in the requested one are not lengths on the ground.
std::string choose_working_crs(const SceneReading& reading, const gis::RasterInfo& dtm, Findings found) {
    const std::string& requested = reading.scene.terrain.crs;
    if (requested == "local") {
        check_local(reading, dtm);
        return {};
    }
    Problems problems;
    std::string crs;
    attempt(problems, [&] {
        if (requested != "auto") crs = requested_crs(reading, dtm);
    });
    if (dtm.crs_wkt.empty()) {
        problems.add({"has no coordinate reference system", reading.where("terrain.dtm"), dtm.path, "",
                      "State it with terrain.dtm-crs = EPSG:..., or set terrain.crs = local to take its coordinates, "
                      "and the perimeter's, as plain metres"});
    }
    problems.throw_if_any();
    return crs.empty() ? automatic_crs(reading, dtm, found) : crs;
}

constexpr double k_steepest_median = 60;  // degrees; of the steepest mountains some 45
// A single cell of fine models: higher than trees and houses. Of coarse ones a summit may be as steep as 56 degrees.
constexpr double k_needle = 20, k_needle_cells = 1.5;

Sentence place_of(const GridSpec& looked_at, const GridSpec& grid, const Spot& spot) {
    const Point centre = looked_at.cell_centre(spot.row, spot.column);
    const auto cell = [&](double distance) { return std::to_string(std::llround(distance / grid.cell_size - 0.5)); };
    return worded("{1} (row {2}, column {3})", {number_text(centre.x, 9) + ", " + number_text(centre.y, 9),
                                                cell(grid.north - centre.y), cell(centre.x - grid.west)});
}

constexpr const char* k_remedy =
    "If it is nodata, set terrain.nodata-value; if the unit differs, set terrain.vertical-unit or convert the file";

/// Checks the terrain of a run, or a part or samples of it; places are given in cells of `grid`. Throws Error(input)
/// for elevations impossible in any unit; warns of elevations above or below any ground, of slopes that indicate a
/// wrong unit, and of single cells far from all their neighbours, with their places.
void check_terrain(const SceneReading& reading, const Raster& terrain, const GridSpec& grid, Findings found) {
    const auto place = [&](const GridSpec& of, const Spot& spot) { return place_of(terrain.grid, of, spot); };
    const double needle = std::max(k_needle, k_needle_cells * terrain.grid.cell_size);
    const TerrainSanity sanity = terrain_sanity(terrain, needle);
    if (sanity.highest.value < sanity.lowest.value) return;  // no sample of a large DTM lies where it has data
    const Spot& extreme = sanity.highest.value > k_impossible_elevation ? sanity.highest : sanity.lowest;
    if (extreme.value > k_impossible_elevation || extreme.value < k_lowest_ground) {
        throw Error(
            ErrorKind::input,
            Problem{"contains an impossible elevation", reading.where("terrain.dtm") + ": " + reading.scene.terrain.dtm,
                    number_text(extreme.value, 6) + " m at " + place(grid, extreme).text(),
                    grouped(k_lowest_ground) + " to " + grouped(k_impossible_elevation) + " m", k_remedy});
    }
    if (sanity.highest.value > k_highest_ground)
        found.warn(worded("DTM: {1} m at {2}, above any mountain: check its unit",
                          {numeral(number_text(sanity.highest.value, 6)), place(grid, sanity.highest)}));
    if (sanity.median_slope_deg > k_steepest_median)
        found.warn(worded("DTM: median slope {1}°: check terrain.vertical-unit and its CRS",
                          {numeral(number_text(sanity.median_slope_deg, 3))}));
    if (sanity.needles == 0) return;
    std::vector<Sentence> list;
    for (const Spot& spot : sanity.first_needles)
        list.push_back(worded("{1} m at {2}", {numeral(number_text(spot.value, 4)), place(grid, spot)}));
    if (sanity.needles > static_cast<std::int64_t>(list.size())) list.emplace_back(std::string("..."));
    found.warn(worded("DTM: {1} single cells {2} m off all neighbours, repair them: {3}",
                      {numeral(grouped(sanity.needles)), numeral(number_text(needle)), listed(list)}));
}

// Up to here a run reads and checks the whole DTM; beyond, that would cost more than the flow.
constexpr auto k_large = static_cast<double>(CellValues::k_most_dense);
// With terrain read on demand a cell costs addresses (of nodes and their maxima) and tables of tiles.
// A map of 20 000 x 20 000 cells is the largest that tests run.
// Reading so many cells of a file takes some five seconds; larger working cells would need all of them.
constexpr double k_most_cells_read = 1e8;
constexpr double k_most_cells_on_demand = 4e8, k_table_bytes_per_cell = 0.3;
double addresses_per_cell(const SceneSpec& scene) {
    return scene.material.model == "structured" ? 400 : 320;
}
// A large DTM is looked at in so many places along each side before a run.
constexpr int k_coarse_samples = 16;
// A grid of this many cells already takes 3 GB for each of its rasters.
constexpr double k_most_cells = 4e8;
// terrain.nodata-policy = fill bridges holes, it does not invent ground: farther than this, cells stay empty.
constexpr double k_fill_distance_cells = 50;

/// The DTM's CRS, the user's word before the file's. Empty: none.
std::string dtm_crs(const SceneReading& reading, const gis::RasterInfo& file) {
    const auto& given = reading.scene.terrain.dtm_crs;
    return given ? reading.session.read(gis::crs_from_user, *given, reading.where("terrain.dtm-crs")) : file.crs_wkt;
}

/// Where eastings are in feet, a guess at elevations would be wrong by a factor of three.
void check_vertical_unit(const SceneReading& reading, const gis::RasterInfo& file) {
    const double metres = reading.session.read(gis::metres_per_unit, file.crs_wkt);
    if (reading.scene.terrain.vertical_unit != "auto" || file.vertical_unit_stated || std::abs(metres - 1) < 1e-9) {
        return;
    }
    throw Error(ErrorKind::input,
                Problem{"does not state the unit of its elevations, while its eastings are in units of " +
                            number_text(metres, 9) + " m",
                        reading.where("terrain.dtm"), file.path, "",
                        "Set terrain.vertical-unit = metre, foot or us-survey-foot"});
}

/// Whether the DTM can be read where the flow comes. Fluid that lies or rains everywhere needs all of the ground, and a
/// soil by place is laid everywhere.
bool can_read_on_demand(const SceneSpec& scene) {
    const StructuredSpec& s = scene.structured;
    const auto& lying = s.initial_fluid_depth;
    if (s.rain) return false;
    for (const auto* soil : {&s.soil_conductivity, &s.soil_suction, &s.soil_moisture_deficit})
        if (*soil && (*soil)->kind != SourceSpec::Kind::number) return false;
    return !(lying && lying->kind == SourceSpec::Kind::number && lying->number > 0);
}

/// Cells of the file under a grid.
double cells_to_read(const gis::RasterInfo& file, const GridSpec& grid) {
    const double own = gis::working_grid(file, grid.crs_wkt, grid.bounds(), std::nullopt).cell_size;
    return static_cast<double>(grid.cell_count()) * std::pow(grid.cell_size / own, 2);
}

void check_size(const SceneReading& reading, const GridSpec& grid, bool on_demand) {
    const double cells = static_cast<double>(grid.columns) * static_cast<double>(grid.rows);
    const double per_cell = addresses_per_cell(reading.scene);
    const double needed = cells * (on_demand ? k_table_bytes_per_cell : k_least_cell_bytes);
    if (const double room = address_room(); on_demand && cells * per_cell > room) {
        throw Error(ErrorKind::input,
                    Problem{"a run on the working grid of " + grouped(cells) + " cells maps up to " +
                                bytes_text(cells * per_cell) +
                                " of addresses, though it takes memory only where the flow comes",
                            reading.where("terrain.cell-size"), shortest_text(grid.cell_size) + " m",
                            bytes_text(room) + ", which ulimit -v, ulimit -d or vm.overcommit_memory = 2 allow",
                            "Lift that limit (ulimit -v unlimited), or choose larger cells or a part of the DTM with "
                            "terrain.bounds"});
    }
    if (const MemoryBound bound = usable_memory(reading.session); needed > bound.bytes) {
        throw Error(ErrorKind::input, Problem{"a run on the working grid of " + grouped(cells) +
                                                  " cells needs at least " + bytes_text(needed) + " of memory",
                                              reading.where("terrain.cell-size"), shortest_text(grid.cell_size) + " m",
                                              bytes_text(bound.bytes) + ", which " + bound.what,
                                              "Choose larger cells or a part of the DTM with terrain.bounds"});
    }
    const double most = on_demand ? k_most_cells_on_demand : k_most_cells;
    if (cells <= most) return;
    throw Error(ErrorKind::input,
                Problem{"the working grid would have " + grouped(cells) + " cells", reading.where("terrain.cell-size"),
                        shortest_text(grid.cell_size) + " m", "at most " + grouped(most) + " cells",
                        "Choose larger cells or a part of the DTM with terrain.bounds"});
}

/// Samples of a large DTM on a grid of their own, which covers all of it. Throws Error(input) where there is none.
Raster samples_of(const TerrainSpec& spec, const gis::RasterInfo& file, const GridSpec& grid) {
    GridSpec coarse = grid;
    coarse.cell_size = grid.cell_size * static_cast<double>((std::max(grid.columns, grid.rows) + k_coarse_samples - 1) /
                                                            k_coarse_samples);
    coarse.columns = coarse.rows = k_coarse_samples;
    Raster raster(coarse, k_no_data);
    for (const gis::ElevationSample& s : gis::sample_elevations(file, grid.crs_wkt, grid.bounds(), k_coarse_samples,
                                                                spec.vertical_unit, spec.nodata_value)) {
        const auto column = static_cast<std::int64_t>((s.place.x - coarse.west) / coarse.cell_size),
                   row = static_cast<std::int64_t>((coarse.north - s.place.y) / coarse.cell_size);
        if (column >= 0 && row >= 0 && column < coarse.columns && row < coarse.rows)
            raster.at(row, column) = s.elevation;
    }
    return raster;
}

std::optional<GaussianField> error_of(const TerrainSpec& spec) {
    if (!spec.error) return std::nullopt;
    return GaussianField{spec.error->standard_deviation, spec.error->range, spec.error->seed};
}

/// A DTM of which windows are read. The draws of a slope come to the same ground, and share what was read of it.
struct DtmWindows {
    std::shared_ptr<const gis::RasterOnDemand> file;
    bool keeps = false;
    std::map<std::array<std::int64_t, 4>, std::vector<double>> kept{};

    void read(const CellWindow& window, double* values) {
        if (!keeps) return file->read(window, values);
        const std::array place{window.row, window.column, window.rows, window.columns};
        auto known = kept.find(place);
        if (known == kept.end()) {
            std::vector<double> read(static_cast<std::size_t>(window.rows * window.columns));
            file->read(window, read.data());
            known = kept.emplace(place, std::move(read)).first;
        }
        std::copy(known->second.begin(), known->second.end(), values);
    }
};

std::shared_ptr<DtmWindows> open_dtm(const std::string& path, const GridSpec& grid, const std::string& crs,
                                     const std::string& vertical_unit, const std::optional<double>& nodata_value,
                                     const Place& where, bool keeps) {
    return std::make_shared<DtmWindows>(
        DtmWindows{std::make_shared<const gis::RasterOnDemand>(path, grid, crs, gis::Resampling::automatic,
                                                               vertical_unit, nodata_value, where),
                   keeps});
}

std::vector<Sentence> suspicions_of(const gis::RasterOnDemand* file) {
    return file->suspicions();
}

/// A window of the DTM whose holes are filled as those of the whole are: what lies farther than the distance of filling
/// has no effect.
void read_filled(DtmWindows& file, const GridSpec& grid, const CellWindow& window, double* values) {
    file.read(window, values);
    const std::int64_t count = window.rows * window.columns;
    if (std::none_of(values, values + count, [](double z) { return std::isnan(z); })) return;
    constexpr auto k_margin = static_cast<std::int64_t>(k_fill_distance_cells) + 2;
    CellWindow around;
    around.row = std::max<std::int64_t>(window.row - k_margin, 0);
    around.column = std::max<std::int64_t>(window.column - k_margin, 0);
    around.rows = std::min(window.row + window.rows + k_margin, grid.rows) - around.row;
    around.columns = std::min(window.column + window.columns + k_margin, grid.columns) - around.column;
    Raster part;
    part.grid = part_of(grid, around);
    part.values = CellValues(std::vector<double>(static_cast<std::size_t>(around.rows * around.columns)));
    file.read(around, part.values.data());
    gis::fill_nodata(part, k_fill_distance_cells);
    for (std::int64_t row = 0; row < window.rows; ++row)
        for (std::int64_t column = 0; column < window.columns; ++column)
            *values++ = part.at(window.row - around.row + row, window.column - around.column + column);
}

/// The ground of a large DTM, of which nothing is read yet but samples.
void read_on_demand(const SceneReading& reading, const GridSpec& grid, TerrainInput& input, Findings found) {
    const TerrainSpec& spec = reading.scene.terrain;
    const Place where = reading.where("terrain.dtm");
    const std::string crs = spec.dtm_crs ? input.file.crs_wkt : "";
    const bool keeps = reading.reads_on_demand;  // what its session has read is of one slope, on one thread
    const std::shared_ptr<DtmWindows> file =
        keeps ? reading.session.read(open_dtm, spec.dtm, grid, crs, spec.vertical_unit, spec.nodata_value, where, true)
              : open_dtm(spec.dtm, grid, crs, spec.vertical_unit, spec.nodata_value, where, false);
    gis::RasterRead known = file->file->known();
    found.warn_of(worded("DTM"), known.warnings);
    input.on_demand = file->file;
    input.terrain.grid = grid;
    input.terrain.values = CellValues::tiled(grid.rows, grid.columns, k_no_data,
                                             [file, grid, fills = reading.scene.numerics.nodata == NodataPolicy::fill,
                                              error = error_of(spec)](const CellWindow& window, double* values) {
                                                 if (fills)
                                                     read_filled(*file, grid, window, values);
                                                 else
                                                     file->read(window, values);
                                                 if (error) add_field(*error, grid, window, values);
                                             });
    if (!reading.reads_on_demand) {  // otherwise the whole was looked at before
        known.raster = samples_of(spec, input.file, grid);
        check_terrain(reading, known.raster, grid, found);
    }
    input.used = used_raster(worded("DTM"), input.file, known);
    do_not_count_nodata(input.used);
    found.log.note(
        "elevations are read where the release lies and where the flow comes, and checked there; of the whole only "
        "samples were checked");
}

/// The DTM's file, of which no elevation was read, and the CRS of the working grid; empty: local.
struct DtmFile {
    gis::RasterInfo file;
    std::string working_crs;
};

DtmFile inspect_dtm(const SceneReading& reading, Findings found) {
    DtmFile dtm;
    dtm.file = reading.session.read(gis::inspect_raster, reading.scene.terrain.dtm, reading.where("terrain.dtm"));
    dtm.file = reading.session.read(gis::with_crs, dtm.file, dtm_crs(reading, dtm.file));
    dtm.working_crs = choose_working_crs(reading, dtm.file, found);
    check_vertical_unit(reading, dtm.file);
    if (dtm.working_crs.empty()) dtm.file.crs_wkt.clear();
    return dtm;
}

TerrainInput read_terrain(const SceneReading& reading, Findings found) {
    const TerrainSpec& spec = reading.scene.terrain;
    TerrainInput input;
    const DtmFile dtm = inspect_dtm(reading, found);
    input.file = dtm.file;
    const std::string& crs = dtm.working_crs;
    input.crs_label = crs.empty() ? "local" : reading.session.read(gis::crs_name, crs);

    const GridSpec grid = reading.session.read(gis::working_grid, input.file, crs, spec.bounds, spec.cell_size);
    const bool is_large =
        static_cast<double>(grid.cell_count()) > k_large || cells_to_read(input.file, grid) > k_most_cells_read;
    const bool on_demand = can_read_on_demand(reading.scene) && (is_large || reading.reads_on_demand);
    check_size(reading, grid, on_demand);
    if (on_demand) {
        read_on_demand(reading, grid, input, found);
        return input;
    }
    gis::RasterRead read = reading.session.read(gis::read_raster_on, spec.dtm, grid,
                                                spec.dtm_crs ? input.file.crs_wkt : "", gis::Resampling::automatic,
                                                spec.vertical_unit, spec.nodata_value, reading.where("terrain.dtm"));
    found.warn_of(worded("DTM"), read.warnings);
    if (read.zero_rim_cells > 0) {
        found.warn(worded("DTM: {1} cells of 0 stand out: set terrain.nodata-value = 0",
                          {numeral(grouped(read.zero_rim_cells))}));
    }
    input.used = used_raster(worded("DTM"), input.file, read);
    input.terrain = std::move(read.raster);
    input.nodata_cells = read.nodata_cells;
    if (input.nodata_cells >= grid.cell_count()) {
        throw Error(ErrorKind::input,
                    Problem{"has no elevation anywhere on the working grid", reading.where("terrain.dtm"), spec.dtm, "",
                            "Check terrain.bounds and the file's nodata value"});
    }
    if (reading.scene.numerics.nodata == NodataPolicy::fill && input.nodata_cells > 0)
        input.filled_cells = gis::fill_nodata(input.terrain, k_fill_distance_cells);
    check_terrain(reading, input.terrain, grid, found);
    if (const auto error = error_of(spec))
        add_field(*error, grid, {0, 0, grid.rows, grid.columns}, input.terrain.values.data());
    return input;
}

void report(const TerrainInput& input, const SceneReading& reading, Findings found) {
    const GridSpec& grid = input.terrain.grid;
    found.log.note(
        "DTM " + reading.scene.terrain.dtm + " in " +
        (input.file.crs_wkt.empty() ? "plain metres" : reading.session.read(gis::crs_name, input.file.crs_wkt)));
    found.log.note("working grid of " + std::to_string(grid.columns) + " x " + std::to_string(grid.rows) +
                   " cells of " + shortest_text(grid.cell_size) + " m in " + input.crs_label + ", resampling " +
                   input.used.resampling);
    if (reading.scene.terrain.vertical_unit != "auto")
        found.log.note("elevations read in the given unit: " + reading.scene.terrain.vertical_unit);
    else if (input.file.vertical_scale_to_metres != 1)
        found.log.note("elevations converted from " + input.file.vertical_unit + " to metres");
    report_transform(worded("DTM"), input.used.transform, grid.cell_size, found);
    if (const auto& error = reading.scene.terrain.error)
        found.log.note("terrain.error: a field of " + shortest_text(error->standard_deviation) + " m, range " +
                       shortest_text(error->range) + " m and seed " + std::to_string(error->seed) +
                       " was added to the elevations");
    if (const auto filled = filled_warning(input)) found.warn(*filled);
    if (input.nodata_cells > 0 && input.filled_cells == 0)
        found.log.note(grouped(input.nodata_cells) + " cells of the working grid have no elevation; nodata-policy = " +
                       word_of(reading.scene.numerics.nodata, k_nodata_policies));
}

}  // namespace

std::optional<Sentence> filled_warning(const TerrainInput& input) {
    if (input.filled_cells == 0) return std::nullopt;
    return worded("{1} cells without elevation, {2} interpolated (terrain.nodata-policy = fill)",
                  {numeral(grouped(input.nodata_cells)), numeral(grouped(input.filled_cells))});
}

void check_ground_read(const SceneReading& reading, const TerrainInput& ground, const Raster& terrain, Findings found) {
    if (!ground.on_demand) return;
    for (const CellWindow& window : terrain.values.stored_windows(terrain.grid.columns))
        check_terrain(reading, part_of(terrain, window), terrain.grid, found);
    // Of what was read so far: not of what earlier draws came to.
    const gis::RasterOnDemand* const file = ground.on_demand.get();
    found.warn_of(worded("DTM"),
                  reading.reads_on_demand ? reading.session.read(suspicions_of, file) : suspicions_of(file));
}

std::optional<TerrainInput> prepare_terrain(const SceneReading& reading, Findings found, Problems& problems) {
    if (reading.scene.terrain.dtm.empty()) return std::nullopt;  // reported as missing when the scene was read
    try {
        TerrainInput input = read_terrain(reading, found);
        report(input, reading, found);
        return input;
    } catch (const Error& error) {
        for (Problem problem : error.problems()) {
            // Coordinates that cannot be transformed know nothing of the file they come from.
            if (problem.where.empty()) problem.where = reading.where("terrain.dtm") + ": " + reading.scene.terrain.dtm;
            problems.add(problem);
        }
        return std::nullopt;
    }
}

}  // namespace frana::app
