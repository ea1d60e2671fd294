// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/input/prepare.h"
#include "app/text/run_log.h"

namespace frana::app {

/// Warns of a DTM that does not look like ground where the release can come to: copied cells, terraces, seams, pits,
/// trees. Where its cells are square, those of the file are looked at, as resampling hides what is wrong.
/// All become warnings of the scene; copied cells and pits limit the use of its maps.
void doubt_ground(const SceneReading& reading, Prepared& prepared, RunLog& log);

}  // namespace frana::app
