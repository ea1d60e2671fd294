// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gis/access/memory_dataset.h"

namespace frana::gis {

/// Returns red, green, blue and, if the file has it, opacity as a view of a file with a colour table or a single band,
/// which must stay open; nothing if GDAL fails.
GdalDataset in_colours(GDALDatasetH source);

}  // namespace frana::gis
