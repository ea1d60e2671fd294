// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "simulation/scene.h"

namespace frana::fuzz {

using Bytes = std::vector<std::uint8_t>;

/// A scene of some hundred particles and its state after a few steps.
struct SavedRun {
    Scene scene;
    Bytes state;
};

/// v: Voellmy-Bingham with every feature of the bed; p: the published scheme; s: structured, solids and fluid; w:
/// structured, fluid alone. Made once. Null for others.
const SavedRun* saved_run(char kind);

/// A complete checkpoint file, with the state of 'v'. Made once.
const Bytes& checkpoint_file();

}  // namespace frana::fuzz
