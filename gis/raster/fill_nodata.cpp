// SPDX-License-Identifier: Apache-2.0
#include <cpl_string.h>
#include <gdal_alg.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "gis/access/gdal_session.h"
#include "gis/access/memory_dataset.h"
#include "gis/raster/raster_in.h"

namespace frana::gis {

std::int64_t fill_nodata(Raster& raster, double max_distance_cells) {
    if (std::none_of(raster.values.begin(), raster.values.end(), [](double v) { return std::isnan(v); })) return 0;
    const GdalSession session;
    std::vector<double> filled = raster.values;
    const GdalDataset dataset =
        wrap_values(filled.data(), static_cast<int>(raster.grid.columns), static_cast<int>(raster.grid.rows));
    CPLStringList options;
    options.SetNameValue("TEMP_FILE_DRIVER", "MEM");
    if (GDALFillNodata(GDALGetRasterBand(dataset.get(), 1), nullptr, max_distance_cells, 0, 0, options.List(), nullptr,
                       nullptr) != CE_None) {
        throw Error(ErrorKind::input, Problem{"cells without data cannot be filled: " + session.last_message(), "", "",
                                              "", "Use nodata-policy = stop or wall"});
    }
    // GDAL computes in single precision; cells that had data keep it to the last bit.
    std::int64_t count = 0;
    for (std::size_t i = 0; i < filled.size(); ++i) {
        if (!std::isnan(raster.values[i]) || std::isnan(filled[i])) continue;
        raster.values[i] = filled[i];
        ++count;
    }
    return count;
}

}  // namespace frana::gis
