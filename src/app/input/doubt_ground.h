// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/input/prepare.h"
#include "app/text/run_log.h"

namespace frana::app {

/// Warns of a DTM that does not look like ground where the release can come to: copied cells, terraces, seams, pits,
/// trees. Where its cells are square, those of the file are looked at, as resampling hides what is wrong.
/// What changes the result, copied cells and pits, becomes one of the scene's doubts.
void doubt_ground(const SceneReading& reading, Prepared& prepared, RunLog& log);

}  // namespace frana::app
