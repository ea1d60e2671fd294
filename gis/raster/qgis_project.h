// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/geometry.h"
#include "gis/raster/qgis_layout.h"
#include "gis/vector/vector_style.h"

namespace frana::gis {

/// A layer of a project. Files are named relative to the project's folder, so that the folder can be moved.
struct ProjectLayer {
    std::string title;
    std::string file;           ///< "max_depth.tif", "extent.gpkg"
    std::string layer{};        ///< of a GeoPackage; empty: a raster
    Shape shape = Shape::area;  ///< of its features
    std::string style{};        ///< QML document; empty: QGIS's own choice
    bool visible = false;
    std::optional<std::pair<double, double>>
        seconds{};              ///< shown from the first to the second, both included (gis/access/table_in.h)
    std::string attribution{};  ///< source of its data
};

struct ProjectGroup {
    std::string name;
    std::vector<ProjectLayer> layers;  ///< the uppermost first
    bool visible = true;
    bool expanded = true;
};

struct QgisProject {
    std::string title;
    std::string crs_wkt;  ///< of all layers; empty: none
    Bounds extent;        ///< shown at first
    std::vector<ProjectGroup> groups;
    double step = 0;  ///< of its temporal controller [s], if layers have times
    std::vector<ProjectLayout> layouts{};
};

/// Writes a .qgz. Its temporal controller begins at time 0. The same project gives
/// the same bytes. Throws Error(environment).
void write_qgis_project(const std::string& path, const QgisProject& project);

}  // namespace frana::gis
