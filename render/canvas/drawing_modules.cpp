// SPDX-License-Identifier: Apache-2.0
#include "render/canvas/drawing_modules.h"

namespace frana::render {

const VtkFunctions& vtk() {
    static const auto& functions = module_table<VtkFunctions>("vtk");
    return functions;
}

const LibavFunctions& libav() {
    static const auto& functions = module_table<LibavFunctions>("libav");
    return functions;
}

}  // namespace frana::render
