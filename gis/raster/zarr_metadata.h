// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace frana::gis {

/// Makes of the metadata that GDAL wrote into a Zarr (version 2) folder what zarr and xarray read: every
/// array says which dimensions it has, one without any too (_ARRAY_DIMENSIONS), and the files hold nothing
/// but ASCII, for zarr decodes them as such. Throws Error(environment).
void finish_zarr_metadata(const std::string& folder);

}  // namespace frana::gis
