// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gdal.h>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/words/sentence.h"
#include "gis/access/gdal_session.h"
#include "gis/raster/raster_in.h"

namespace frana::gis {

struct GdalDatasetClose {
    void operator()(void* dataset) const noexcept { GDALClose(dataset); }
};
using GdalDataset = std::unique_ptr<void, GdalDatasetClose>;

/// Wraps an array as a one-band dataset of GDAL, with NaN as nodata. The array must outlive it.
GdalDataset wrap_values(double* values, int columns, int rows);

/// Detects, while a raster is read, values used as "no data" that the file does not declare.
class NodataSuspicion {
  public:
    /// `values` as stored, row by row, NaN where the file declares "no data".
    void examine(const std::vector<double>& values, int columns);

    /// Returns the number of cells read with value 0 most of whose neighbours differ by more than `steep` (in the units
    /// stored): a frame of zeros around a terrain model. None if the values approach zero gradually, as at the sea.
    [[nodiscard]] std::int64_t zero_rim(double steep) const;

    /// Returns a warning about a common value (-9999 and similar; 9999 and similar if they form walls), or
    /// none.
    [[nodiscard]] std::optional<Sentence> warning(const std::string& path) const;

  private:
    static constexpr std::array<double, 8> k_customary{
        -9999.0, -99999.0, -32767.0, -32768.0, -3.4028234663852886e38, -1e32, 1e20, 3.4028234663852886e38};
    std::array<std::int64_t, k_customary.size()> found_{};

    /// Common too, but a model in centimetres may contain them: suspect if they form walls.
    struct Plateau {
        double value = 0;
        std::int64_t cells = 0, borders = 0, walls = 0;
    };
    std::array<Plateau, 4> plateaus_{Plateau{9999}, Plateau{99999}, Plateau{32767}, Plateau{65535}};
    std::int64_t zeros_ = 0;
    std::vector<float> jumps_;  ///< between a zero and each of its neighbours other than zero
};

/// Position of cell corners: x = g[0] + column g[1] + row g[2], y = g[3] + column g[4] + row g[5].
using GeoTransform = std::array<double, 6>;

/// A rectangle of cells.
struct Window {
    int column = 0, row = 0, columns = 0, rows = 0;

    [[nodiscard]] bool empty() const noexcept { return columns <= 0 || rows <= 0; }
};

/// A band of a raster file, open for reading.
class RasterSource {
  public:
    /// Throws Error(input) as inspect_raster. A class raster has a colour table, as pictures do: a colour table is
    /// accepted only if classes are expected.
    RasterSource(const std::string& path, const Place& where, bool accept_colour_table = false, int band = 1);

    [[nodiscard]] const RasterInfo& info() const noexcept { return info_; }
    [[nodiscard]] const GeoTransform& geo_transform() const noexcept { return geo_; }
    /// Converts a position in cells (column, row) from the upper left corner to map coordinates and back.
    [[nodiscard]] Point map_from_cell(Point cell) const noexcept;
    [[nodiscard]] Point cell_from_map(Point map) const noexcept;

    /// Returns values with scale and offset applied, times `unit` (metres per vertical unit); NaN where there is no
    /// data. Throws Error(input) if the part cannot be read.
    [[nodiscard]] std::vector<double> read(const Window& window, double unit) const;

    /// The same of a file whose values are not suspected.
    [[nodiscard]] std::vector<double> read_plain(const Window& window, double unit) const {
        return read_coarse(window, window.columns, window.rows, unit);
    }
    /// The same at a reduced number of columns and rows; each value is that of one cell in its part of the window.
    [[nodiscard]] std::vector<double> read_coarse(const Window& window, int columns, int rows, double unit) const;

    /// Returns whether the file contains data in a window, as far as it declares: files may omit empty blocks.
    [[nodiscard]] bool holds_any(const Window& window) const noexcept;

    /// Adds a stored value that means "no data", besides the file's.
    void declare_nodata(double stored) noexcept { declared_ = stored; }
    /// Returns a warning if the values read include a common "no data" value that the file does not declare, else an
    /// empty text.
    [[nodiscard]] std::optional<Sentence> suspicion() const { return suspicion_.warning(info_.path); }
    /// Returns the number of cells read that look like a frame of zeros: see NodataSuspicion. `steep` in metres.
    [[nodiscard]] std::int64_t zero_rim(double steep, double unit) const;

  private:
    /// As stored; NaN where there is no data.
    [[nodiscard]] std::vector<double> read_stored(const Window& window, int columns, int rows) const;

    RasterInfo info_;
    Place where_;  // for messages
    GdalDataset dataset_;
    GDALRasterBandH band_ = nullptr;
    GeoTransform geo_{}, inverse_{};
    double scale_ = 1, offset_ = 0;
    std::optional<double> declared_;
    mutable NodataSuspicion suspicion_;  // statistics of the values read
};

}  // namespace frana::gis
