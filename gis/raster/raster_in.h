// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "core/error.h"
#include "core/raster.h"
#include "core/words/sentence.h"
#include "gis/crs/crs_transform.h"

namespace frana::gis {

/// The properties of a raster file.
struct RasterInfo {
    std::string path;
    std::string crs_wkt;    ///< empty: the file names none
    std::string crs_label;  ///< for messages
    std::string driver;     ///< "GTiff"
    std::string data_type;  ///< "Float32"
    Bounds bounds;          ///< in its own CRS
    std::int64_t columns = 0, rows = 0;
    double cell_x = 0, cell_y = 0;  ///< sides of a cell, positive, in units of its CRS
    bool has_nodata = false;
    double nodata = 0;
    std::string band_unit;                ///< of the values, as in the file; empty: none
    std::string vertical_unit;            ///< "m" if the file has none
    bool vertical_unit_stated = false;    ///< by the band or by the CRS
    double vertical_scale_to_metres = 1;  ///< of that unit
    bool rotated = false;                 ///< rows do not run to the east

    [[nodiscard]] auto members() const {
        return std::tie(path, crs_wkt, crs_label, driver, data_type, bounds, columns, rows, cell_x, cell_y, has_nodata,
                        nodata, band_unit, vertical_unit, vertical_unit_stated, vertical_scale_to_metres, rotated);
    }
};

/// Returns the properties with another CRS, which may specify its vertical unit.
RasterInfo with_crs(RasterInfo info, const std::string& crs_wkt);

/// Reads them. Throws Error(input): missing, not a raster, no position on the ground, no band. `where` names the key.
RasterInfo inspect_raster(const std::string& path, const Place& where);

enum class Resampling {
    automatic,  ///< exact copy if the cells coincide, else average to coarser cells, bilinear to finer ones
    nearest,
    bilinear,
    cubic,
    average,
};

struct RasterRead {
    Raster raster;  ///< on the target grid, NaN where the file has no data or does not reach
    std::int64_t nodata_cells = 0;
    std::string resampling_used;  ///< "exact copy", "average", ...
    TransformInfo transform;
    std::vector<Sentence> warnings;
    std::int64_t zero_rim_cells = 0;  ///< source cells of value 0 that form walls; see NodataSuspicion
};

/// Reads band 1 of a raster onto a grid: only the needed part is read; scale and offset applied; feet become metres.
/// Cells without data (nodata value, mask, NaN, infinity) do not contribute to their neighbours. `source_crs_override`
/// replaces the file's own CRS; a grid without CRS (local) means no reprojection. `vertical_unit`: "auto" (from the
/// file), "metre", "foot", "us-survey-foot". `nodata_value`: one more stored value that means "no data". `where` names
/// the key for messages.
/// Throws Error(input).
RasterRead read_raster_on(const std::string& path, const GridSpec& target, const std::string& source_crs_override,
                          Resampling resampling, const std::string& vertical_unit = "auto",
                          std::optional<double> nodata_value = std::nullopt, const Place& where = {});

/// A raster of which parts are resampled onto a grid on demand, with the values of read_raster_on. Between different
/// CRS the places of cells are computed one by one, there interpolated within a hundredth of a cell.
class RasterOnDemand {
  public:
    /// Parameters and errors are those of read_raster_on.
    RasterOnDemand(const std::string& path, const GridSpec& target, const std::string& source_crs_override,
                   Resampling resampling, const std::string& vertical_unit, std::optional<double> nodata_value,
                   const Place& where);
    ~RasterOnDemand();

    /// Fills a window of the grid, row by row; NaN where the file has no data or does not reach. Throws Error(input).
    void read(const CellWindow& window, double* values) const;
    /// Properties known before anything is read: no raster, no counts.
    [[nodiscard]] const RasterRead& known() const noexcept;
    /// Warnings of common "no data" values that were read so far and that the file does not declare.
    [[nodiscard]] std::vector<Sentence> suspicions() const;

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

/// Reads a band of a whole raster on its own grid, as frana writes them: north up, square cells. Throws Error(input)
/// otherwise.
Raster read_result_raster(const std::string& path, int band = 1);

/// Fills cells without data by interpolation from cells at most this many cells away. Returns the number of cells
/// filled.
std::int64_t fill_nodata(Raster& raster, double max_distance_cells);

/// One elevation [m] at a place in the target CRS.
struct ElevationSample {
    Point place;
    double elevation = 0;
};

/// Returns a regular sample of at most most_per_side squared cells of a raster (interpreted in dtm.crs_wkt) inside
/// `window` (target CRS): fast for any size of file, and only an overview of the ground. Cells without data are
/// omitted. `vertical_unit`, `nodata_value` as in read_raster_on. Throws Error(input).
std::vector<ElevationSample> sample_elevations(const RasterInfo& dtm, const std::string& target_crs_wkt,
                                               const Bounds& window, int most_per_side,
                                               const std::string& vertical_unit, std::optional<double> nodata_value);

}  // namespace frana::gis
