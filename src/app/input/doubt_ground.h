// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/input/prepare.h"

namespace frana::app {

/// Doubts a DTM that does not look like ground where the release can come to: copied cells, terraces, seams, pits,
/// trees. Where its cells are square, those of the file are looked at, as resampling hides what is wrong.
/// Copied cells and pits limit the use of its maps.
Warnings doubt_ground(const SceneReading& reading, const Prepared& prepared);

}  // namespace frana::app
