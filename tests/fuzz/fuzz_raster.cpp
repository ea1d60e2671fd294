// SPDX-License-Identifier: Apache-2.0
// Rasters. First byte: t GeoTIFF, a ASCII grid.
#include <cmath>

#include "gis/raster/raster_in.h"
#include "harness.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace frana;
    const fuzz::Input input = fuzz::split(data, size);
    const fuzz::MemoryFile file(std::string("/vsimem/fuzz/dtm.") + (input.kind == 'a' ? "asc" : "tif"), input.data,
                                input.size);
    fuzz::refused_or_done([&] {
        const gis::RasterInfo info = gis::inspect_raster(file.path(), "terrain.dtm");
        if (info.columns < 1 || info.rows < 1 || !(info.cell_x > 0) || !(info.cell_y > 0) ||
            !std::isfinite(info.bounds.west + info.bounds.east + info.bounds.south + info.bounds.north))
            __builtin_trap();
        GridSpec grid;
        grid.columns = 8;
        grid.rows = 5;
        grid.cell_size = info.bounds.width() / 8;
        grid.west = info.bounds.west;
        grid.north = info.bounds.north;
        grid.crs_wkt = info.crs_wkt;
        // Larger whole rasters are read in parts, which takes time, not memory.
        if (static_cast<double>(info.columns) * static_cast<double>(info.rows) > 1e6 || !(grid.cell_size > 0)) return;
        const gis::RasterRead read = gis::read_raster_on(file.path(), grid, "", gis::Resampling::automatic);
        for (const double z : read.raster.values)
            if (std::isinf(z)) __builtin_trap();
    });
    return 0;
}
