// SPDX-License-Identifier: Apache-2.0
#include "gis/access/memory_dataset.h"

#include <cpl_string.h>

#include "core/raster.h"

namespace frana::gis {

GdalDataset wrap_values(double* values, int columns, int rows) {
    GdalDataset dataset(GDALCreate(GDALGetDriverByName("MEM"), "", columns, rows, 0, GDT_Float64, nullptr));
    CPLStringList options;
    char pointer[64] = {};
    CPLPrintPointer(pointer, values, sizeof(pointer) - 1);
    options.SetNameValue("DATAPOINTER", pointer);
    GDALAddBand(dataset.get(), GDT_Float64, options.List());
    GDALSetRasterNoDataValue(GDALGetRasterBand(dataset.get(), 1), k_no_data);
    return dataset;
}

}  // namespace frana::gis
