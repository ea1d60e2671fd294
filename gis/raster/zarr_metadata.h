// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace frana::gis {

/// Converts the metadata that GDAL wrote into a Zarr (version 2) folder to the form that zarr and xarray read: every
/// array lists its dimensions, also one without any (_ARRAY_DIMENSIONS), and the files contain only ASCII, as zarr
/// decodes them.
void finish_zarr_metadata(const std::string& folder);

}  // namespace frana::gis
