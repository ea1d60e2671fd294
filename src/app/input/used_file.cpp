// SPDX-License-Identifier: Apache-2.0
#include "app/input/used_file.h"

#include "app/text/number_text.h"
#include "core/text.h"
#include "core/words/words.h"
#include "gis/crs/crs.h"
#include "params/grammar/ini_file.h"

namespace frana::app {
namespace {

bool in_place(const gis::TransformInfo& transform) {
    return transform.operation.empty() || transform.operation == "none";
}

}  // namespace

std::string accuracy_text(const gis::TransformInfo& transform) {
    if (transform.accuracy_m < 0) return "unknown";
    return transform.accuracy_m == 0 ? "exact" : number_text(transform.accuracy_m, 3) + " m";
}

std::string transform_text(const gis::TransformInfo& transform) {
    return in_place(transform) ? "none" : transform.operation;
}

void report_transform(const Sentence& input, const gis::TransformInfo& transform, double cell_size, Findings found) {
    if (in_place(transform)) return;
    found.log.note(input.text() + " transformed by: " + transform_text(transform) + ", accuracy " +
                   accuracy_text(transform));
    if (transform.accuracy_m < 0) {
        found.warn(
            worded("{1}: transformation accuracy unknown ({2}): position may be wrong", {input, transform.operation}));
    } else if (transform.accuracy_m > cell_size / 2) {
        found.warn(worded("{1}: position ± {2} m, half a cell is {3} m ({4})",
                          {input, numeral(number_text(transform.accuracy_m, 3)), numeral(number_text(cell_size / 2, 3)),
                           transform.operation}));
    }
    if (!transform.needs_missing_grid) return;
    const auto known = [](bool is_known, const std::string& text) { return is_known ? text : std::string("?"); };
    found.warn(
        worded("{1}: grid file {2} not installed ({3} m possible): see proj-data, projsync",
               {input, known(!transform.missing_grid.empty(), transform.missing_grid),
                numeral(known(transform.missing_accuracy_m >= 0, number_text(transform.missing_accuracy_m, 3)))}));
}

namespace {

UsedFile positioned(const std::string& role, const std::string& path, const std::string& crs_wkt,
                    const std::string& crs_label, const Bounds& bounds, const gis::TransformInfo& transform) {
    UsedFile file;
    file.role = role;
    file.path = path;
    file.crs_label = crs_wkt.empty() ? "none" : crs_label;
    file.bounds = bounds;
    file.degrees = !crs_wkt.empty() && gis::longitude_turn(crs_wkt) > 0;
    file.transform = transform;
    return file;
}

std::string counted(std::size_t count, const char* what) {
    return count == 0 ? "" : Words()(what, {std::to_string(count)});
}

std::string counted_lines(std::size_t count) {
    return counted(count, worded("lines: {1}"));
}

}  // namespace

UsedFile used_raster(const std::string& role, const gis::RasterInfo& from, const gis::RasterRead& read) {
    UsedFile file = positioned(role, from.path, from.crs_wkt, from.crs_label, from.bounds, read.transform);
    file.content = grouped(from.columns) + " x " + grouped(from.rows) + "\n" + number_text(from.cell_x, 6) + " x " +
                   number_text(from.cell_y, 6) + (file.degrees ? "°\n" : "\n") + from.data_type + ", " +
                   from.vertical_unit + (from.vertical_unit_stated ? "" : " (" + std::string(worded("assumed")) + ")") +
                   (from.rotated ? "\n" + std::string(worded("rotated")) : "");
    file.nodata = grouped(read.nodata_cells) + "\n" + (from.has_nodata ? number_text(from.nodata, 9) : "none declared");
    file.resampling = read.resampling_used;
    file.checksum.add(read.raster);
    return file;
}

void do_not_count_nodata(UsedFile& raster) {
    raster.nodata.replace(0, raster.nodata.find('\n'), "not counted");
}

UsedFile used_polygons(const std::string& role, const std::string& path, const gis::PolygonLayer& layer) {
    UsedFile file = positioned(role, path, layer.crs_wkt, layer.crs_label, layer.own_bounds, layer.transform);
    file.layer = layer.layer_name;
    double area_m2 = 0;
    file.checksum.add(static_cast<double>(layer.features.size()));
    for (const Feature& feature : layer.features) {
        area_m2 += area(feature.shape.areas);
        file.checksum.add_all(feature.shape.areas, feature.numbers);  // texts are remarks
    }
    file.content = counted(layer.features.size(), worded("polygons: {1}")) + "\n" + grouped(area_m2) + " m2";
    return file;
}

UsedFile used_lines(const std::string& role, const std::string& path, const gis::FeatureLayer& layer) {
    UsedFile file = positioned(role, path, layer.crs_wkt, layer.crs_label, layer.own_bounds, layer.transform);
    file.content = counted_lines(layer.features.size());
    file.checksum.add(layer.features);
    return file;
}

UsedFile used_marks(const std::string& role, const std::string& path, const gis::Marks& marks) {
    UsedFile file = positioned(role, path, marks.crs_wkt, marks.crs_label, marks.own_bounds, marks.transform);
    const std::string lines = counted_lines(marks.lines.size()),
                      points = counted(marks.points.size(), worded("points: {1}"));
    file.content = lines + (lines.empty() || points.empty() ? "" : "\n") + points;
    file.checksum.add_all(marks.lines, marks.points);
    return file;
}

namespace {

template <class Point>
UsedFile used_series(const std::string& role, const std::string& path, const std::vector<Point>& points) {
    UsedFile file;
    file.role = role;
    file.path = path;
    file.content = shortest_text(points.front().time) + " – " + shortest_text(points.back().time) + " s";
    file.checksum.add(points);
    return file;
}

}  // namespace

UsedFile used_hydrograph(const std::string& path, const std::vector<HydrographPoint>& points) {
    return used_series(worded("Hydrograph"), path, points);
}

UsedFile used_rain(const std::string& path, const Rain& rain) {
    return used_series(worded("Rain"), path, rain.points);
}

UsedFile used_features(const std::string& role, const std::string& path, const gis::FeatureLayer& layer) {
    UsedFile file = positioned(role, path, layer.crs_wkt, layer.crs_label, layer.own_bounds, layer.transform);
    file.layer = layer.layer_name;
    file.content = counted(layer.features.size(), worded("features: {1}"));
    file.checksum.add(layer.features);
    return file;
}

UsedFile used_data_file(const std::string& role, const std::string& path, const std::string& called) {
    UsedFile file;
    file.role = role;
    file.path = path;
    file.content = called;
    for (const IniEntry& entry : read_ini(path)) file.checksum.add_all(entry.name, entry.value);
    return file;
}

UsedFile used_picture(const std::string& role, const std::string& path, std::uint32_t content) {
    UsedFile file;
    file.role = role;
    file.path = path;
    file.content = worded("picture");
    file.checksum.add(content);
    return file;
}

}  // namespace frana::app
