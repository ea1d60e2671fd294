// SPDX-License-Identifier: Apache-2.0
#include "core/module.h"

#include "render/libav/encoder.h"
#include "render/libav/functions.h"

FRANA_MODULE(frana::render::LibavFunctions, {.encoder = frana::render::encoder})
