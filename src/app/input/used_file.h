// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <zlib.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/text/run_log.h"
#include "core/geometry.h"
#include "core/raster.h"
#include "gis/crs/crs_transform.h"
#include "gis/raster/raster_in.h"
#include "gis/vector/vector_in.h"
#include "simulation/scene.h"

namespace frana::app {

/// Returns "none", or PROJ's name: "Inverse of Italy zone 1 + ...".
std::string transform_text(const gis::TransformInfo& transform);
/// Returns the accuracy stated by the register: "exact" (formulas alone), "4 m", "unknown".
std::string accuracy_text(const gis::TransformInfo& transform);

/// Logs how an input ("DTM", "perimeter") was transformed to the working CRS, and warns if its accuracy is worse than
/// half a cell or a better operation needs a grid file that is not installed.
void report_transform(const Sentence& input, const gis::TransformInfo& transform, double cell_size, Findings found);

/// CRC-32 of values as read.
class Checksum {
  public:
    void add(double value) { add_bytes(&value, sizeof value); }
    void add(Point point) { add_all(point.x, point.y); }
    void add(const std::string& text) {
        add(static_cast<double>(text.size()));
        add_bytes(text.data(), text.size());
    }
    /// Adds the stored cells of a raster.
    void add(const Raster& raster) {
        raster.values.for_each_run([this, &raster](std::size_t first, const double* values, std::size_t count) {
            if (raster.values.is_tiled()) add(static_cast<double>(first));
            add_bytes(values, count * sizeof(double));
        });
    }
    void add(const Polygon& polygon) { add_all(polygon.outer, polygon.holes); }
    void add(const Feature& feature) {
        add_all(feature.name, feature.count.value_or(-1), feature.shape.areas, feature.shape.lines,
                feature.shape.points, feature.numbers, feature.texts);
    }
    void add(const gis::NamedLine& line) { add_all(line.name, line.line); }
    void add(const gis::NamedPoint& point) { add_all(point.name, point.place); }
    void add(const HydrographPoint& point) { add_all(point.time, point.discharge, point.speed); }
    void add(const Rain::Point& point) { add_all(point.time, point.intensity); }
    template <class Key, class Value>
    void add(const std::pair<Key, Value>& pair) {
        add_all(pair.first, pair.second);
    }
    template <class Key, class Value>
    void add(const std::map<Key, Value>& map) {
        add_each(map);
    }
    template <class T>
    void add(const std::vector<T>& list) {
        add_each(list);
    }
    template <class... T>
    void add_all(const T&... values) {
        (add(values), ...);
    }
    [[nodiscard]] std::uint32_t value() const noexcept { return sum_; }

  private:
    template <class List>
    void add_each(const List& list) {
        add(static_cast<double>(list.size()));
        for (const auto& value : list) add(value);
    }
    void add_bytes(const void* data, std::size_t count) {
        if (count > 0)  // null would reset the sum
            sum_ = static_cast<std::uint32_t>(crc32_z(sum_, static_cast<const Bytef*>(data), count));
    }

    std::uint32_t sum_ = 0;
};

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
UsedFile used_lines(const std::string& role, const std::string& path, const gis::FeatureLayer& layer);
UsedFile used_marks(const std::string& role, const std::string& path, const gis::Marks& marks);
UsedFile used_hydrograph(const std::string& path, const std::vector<HydrographPoint>& points);
UsedFile used_rain(const std::string& path, const Rain& rain);
UsedFile used_features(const std::string& role, const std::string& path, const gis::FeatureLayer& layer);
/// A data file of one's own: a hazard scheme, a friction table. `called`: its title.
UsedFile used_data_file(const std::string& role, const std::string& path, const std::string& called);
/// `content`: its checksum.
UsedFile used_picture(const std::string& role, const std::string& path, std::uint32_t content);

}  // namespace frana::app
