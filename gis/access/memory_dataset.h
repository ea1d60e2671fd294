// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gdal.h>

#include <memory>

namespace frana::gis {

struct GdalDatasetClose {
    void operator()(void* dataset) const noexcept { GDALClose(dataset); }
};
using GdalDataset = std::unique_ptr<void, GdalDatasetClose>;

/// Wraps an array as a one-band dataset of GDAL, with NaN as nodata. The array must outlive it.
GdalDataset wrap_values(double* values, int columns, int rows);

}  // namespace frana::gis
