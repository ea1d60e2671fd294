// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/input/checksum.h"
#include "gis/raster/raster_in.h"
#include "gis/vector/exposed_in.h"
#include "gis/vector/lines_in.h"
#include "gis/vector/marks_in.h"
#include "gis/vector/vector_in.h"

namespace frana::app {

/// An input file of a scene, for the tables of the check and of the report, and for the comparison by --resume. Made
/// from the data read. Texts may contain line breaks.
struct UsedFile {
    std::string role;  ///< "Release perimeter"
    std::string path;
    std::string layer;      ///< of a vector file
    std::string crs_label;  ///< "none": it names none; empty: it needs none
    Bounds bounds;          ///< in its own CRS
    bool degrees = false;   ///< its own CRS is in degrees
    std::string content;    ///< "3 polygons\n1 200 m2"
    std::string nodata;     ///< of a raster
    std::string resampling;
    gis::TransformInfo transform;  ///< to the working CRS
    Checksum checksum;             ///< of everything read of it
};

UsedFile used_raster(const std::string& role, const gis::RasterInfo& file, const gis::RasterRead& read);
/// For a raster of which only parts are read.
void do_not_count_nodata(UsedFile& raster);
UsedFile used_polygons(const std::string& role, const std::string& path, const gis::PolygonLayer& layer);
UsedFile used_lines(const std::string& role, const std::string& path, const gis::LineInputLayer& layer);
UsedFile used_marks(const std::string& role, const std::string& path, const gis::Marks& marks);
UsedFile used_hydrograph(const std::string& path, const std::vector<HydrographPoint>& points);
UsedFile used_exposed(const std::string& path, const gis::ExposedLayer& layer);
/// `content`: its checksum.
UsedFile used_picture(const std::string& role, const std::string& path, std::uint32_t content);

}  // namespace frana::app
