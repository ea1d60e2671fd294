// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/libav/functions.h"

namespace frana::render {

/// See LibavFunctions.
std::unique_ptr<MovieEncoder> encoder(const MovieFile& movie);

}  // namespace frana::render
