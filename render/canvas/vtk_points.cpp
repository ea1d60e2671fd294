// SPDX-License-Identifier: Apache-2.0
#include "render/canvas/vtk_points.h"

#include "core/file_aside.h"
#include "render/canvas/drawing_modules.h"

namespace frana::render {

void write_vtk_points(const std::string& path, const PointTable& table, const std::vector<double>& heights,
                      double time) {
    FileAside file(path);
    call_module([&] { vtk().write_points(file.partial_path(), path, table, heights, time); });
    file.sync_to_disk();
    file.rename_into_place();
}

}  // namespace frana::render
