// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/module.h"
#include "render/libav/functions.h"
#include "render/vtk/functions.h"

namespace frana::render {

/// Loads VTK and OSMesa when it is first called, which takes longer than the start of the program and what `check`
/// does. Throws Error(environment) if that is not possible.
const VtkFunctions& vtk();

/// The same for the encoders of animations.
const LibavFunctions& libav();

}  // namespace frana::render
