// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "gis/raster/raster_in.h"
#include "gis/vector/lines_in.h"
#include "gis/vector/marks_in.h"
#include "gis/vector/vector_in.h"

namespace frana::app {

/// A file that went into a scene, for the tables of the check and of the report. Texts may hold line breaks.
struct UsedFile {
    std::string role;  ///< "Release perimeter"
    std::string path;
    std::string layer;      ///< of a vector file
    std::string crs_label;  ///< "none": it names none; empty: it needs none
    Bounds bounds;          ///< in its own CRS
    bool degrees = false;   ///< its own CRS counts in degrees
    std::string content;    ///< "3 polygons\n1 200 m2"
    std::string nodata;     ///< of a raster
    std::string resampling;
    gis::TransformInfo transform;  ///< to the working CRS
};

/// `nodata_cells` of the working grid.
UsedFile used_raster(const std::string& role, const gis::RasterInfo& file, const gis::TransformInfo& transform,
                     const std::string& resampling, std::int64_t nodata_cells);
UsedFile used_polygons(const std::string& role, const std::string& path, const gis::PolygonLayer& layer);
UsedFile used_lines(const std::string& role, const std::string& path, const gis::LineInputLayer& layer);
UsedFile used_marks(const std::string& role, const std::string& path, const gis::Marks& marks);

}  // namespace frana::app
