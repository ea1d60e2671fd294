// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gdalwarper.h>

#include <optional>
#include <string>
#include <vector>

#include "core/raster.h"
#include "gis/raster/raster_in.h"
#include "gis/raster/raster_source.h"

namespace frana::gis {

/// Resamples a raster onto a grid in strips of rows, so that memory is bounded however fine the source is.
class RasterWarp {
  public:
    /// `to_grid` transforms from the source's CRS to the grid's. `unit`: metres per unit of the source's values.
    RasterWarp(const RasterSource& source, const CrsTransform& to_grid, GDALResampleAlg algorithm, double unit);

    /// Source cells per cell of the grid along columns and rows at the grid's centre.
    [[nodiscard]] Point source_cells_per_cell(const GridSpec& grid) const;

    /// Returns the cells of the source below a part of the grid, with the margin of the resampling kernel.
    [[nodiscard]] Window source_window(const GridSpec& strip, Point source_cells_per_cell) const;

    /// Fills `target`; NaN where the source has no data or does not reach. Throws Error(input).
    ///
    /// GRA_Average is the mean of the surface interpolated linearly between cell centres. GDAL's own mean treats each
    /// source cell as a step: where the grid's edges divide cells, a plane becomes uneven, by up to an eighth of a
    /// source cell times its slope.
    void fill(Raster& target) const;

    /// The same for a part of a grid, row by row, with every cell's place computed: the values do not depend on the
    /// division of the grid into parts.
    /// @param scale source_cells_per_cell of the whole grid
    void fill_part(const GridSpec& part, Point scale, double* values) const;

    /// GDAL's transformer: cells of a strip to cells of a source window and back.
    static int transform(void* self, int to_source, int count, double* x, double* y, double* z, int* good);

  private:
    struct Strip;
    /// Returns the source's cell at a place in its CRS; longitudes in the source's range.
    [[nodiscard]] Point source_cell(Point map) const noexcept;
    void fill_strip(const GridSpec& strip, Point scale, double* values, bool exactly = false) const;
    void average_strip(const GridSpec& strip, Point scale, int points, double* values, bool exactly = false) const;

    const RasterSource& source_;
    const CrsTransform& to_grid_;
    GDALResampleAlg algorithm_;
    double unit_;
};

}  // namespace frana::gis
