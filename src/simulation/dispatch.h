// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "models/voellmy_bingham/stages.h"
#include "models/voellmy_bingham/state.h"
#include "simulation/scene.h"

namespace frana {

/// Which kernels sweep over the particles: the fastest that the processor runs, or the plain ones that say what the
/// fast ones compute.
enum class Kernels { fastest, plain };

/// The one place where names become types: the stages that a scene's material and numerics ask for.
voellmy_bingham::Stages choose_stages(const Material& material, const Numerics& numerics,
                                      Kernels kernels = Kernels::fastest);

/// The laws with their parameters, in the engine's units.
voellmy_bingham::Laws make_laws(const Material& material, const Numerics& numerics, double cell_size);

/// The physics and numerics really computed, in words, for summary.json and `frana check`.
std::vector<std::string> list_terms(const Material& material, const Numerics& numerics);

}  // namespace frana
