// SPDX-License-Identifier: Apache-2.0
#include "sample_data/samples.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <vector>

#include "core/error.h"
#include "core/files.h"
#include "core/geometry.h"
#include "core/raster.h"
#include "core/text.h"
#include "gis/crs/crs.h"
#include "gis/crs/crs_transform.h"
#include "gis/raster/raster_out.h"
#include "sample_data/fan_terrain.h"

namespace frana::sample {
namespace {

/// A gully's slope, its yearly rate with a standard deviation, and what it releases in three return periods.
struct Slope {
    const char *name, *rate;
    double distance;  ///< of the outline's middle from the foot [m]
    int volumes[3];   ///< [m3]
};
constexpr Slope k_slopes[k_fan_gullies] = {{"Rio Nero", "0.0333 +- 0.01", 950, {4000, 12000, 30000}},
                                           {"Rio Bianco", "0.0333 +- 0.01", 900, {2500, 8000, 20000}}};

struct Event {
    const char* name;
    int years;
    double half_length, half_width;  ///< of the outline [m]
};
constexpr Event k_events[] = {{"T30", 30, 45, 18}, {"T100", 100, 65, 24}, {"T300", 300, 90, 30}};

std::string rounded(double value, double parts) {
    return shortest_text(std::round(value * parts) / parts);
}

std::string places_text(const Polyline& places, double parts) {
    std::string text;
    for (const Point& p : places)
        text += (text.empty() ? "[" : ", [") + rounded(p.x, parts) + ", " + rounded(p.y, parts) + "]";
    return "[" + text + "]";
}

std::string feature(const std::string& properties, const char* type, const std::string& coordinates) {
    return R"({"type": "Feature", "properties": {)" + properties + R"(}, "geometry": {"type": ")" + type +
           R"(", "coordinates": )" + coordinates + "}}";
}

std::string collection(const std::string& crs, const std::vector<std::string>& features) {
    std::string text = "{\"type\": \"FeatureCollection\", " + crs + "\"features\": [\n";
    for (std::size_t i = 0; i < features.size(); ++i) text += features[i] + (i + 1 < features.size() ? ",\n" : "\n");
    return text + "]}\n";
}

constexpr const char* k_crs = R"("crs": {"type": "name", "properties": {"name": "urn:ogc:def:crs:EPSG::32632"}}, )";

std::string text_column(const char* name, const std::string& value) {
    return "\"" + std::string(name) + "\": \"" + value + "\"";
}

/// The outline of an event, which follows its gully: closed, counter-clockwise, map coordinates.
Polyline outline(const GridSpec& grid, int gully, const Event& event) {
    constexpr int k_rim_points = 28;
    Polyline rim;
    for (int i = 0; i <= k_rim_points; ++i) {
        const double angle = 2 * std::numbers::pi * (i % k_rim_points) / k_rim_points;
        const double distance = k_slopes[gully].distance + event.half_length * std::sin(angle);
        const double x = gully_line(gully, distance) + event.half_width * std::cos(angle);
        rim.push_back(grid.map_from_local({x, distance + fan_foot(x)}));
    }
    return rim;
}

std::string slopes_text(const GridSpec& grid) {
    std::vector<std::string> features;
    for (int gully = 0; gully < k_fan_gullies; ++gully) {
        const Slope& slope = k_slopes[gully];
        std::string volumes;
        for (std::size_t e = 0; e < std::size(k_events); ++e)
            volumes +=
                (e > 0 ? ", " : "") + std::to_string(slope.volumes[e]) + ": " + std::to_string(k_events[e].years);
        for (std::size_t e = 0; e < std::size(k_events); ++e) {
            const Event& event = k_events[e];
            const std::string columns = text_column("NAME", slope.name) + ", " + text_column("SCENARIO", event.name) +
                                        ", \"YEARS\": " + std::to_string(event.years) +
                                        ", \"VOLUME\": " + std::to_string(slope.volumes[e]) + ", " +
                                        text_column("RATE", slope.rate) + ", " + text_column("VOLUMES", volumes);
            features.push_back(feature(columns, "Polygon", "[" + places_text(outline(grid, gully, event), 100) + "]"));
        }
    }
    return collection(k_crs, features);
}

/// The road crosses the fan in a bend around its middle.
double road_line(double x) {
    return fan_foot(600) - 30 - 60 * std::exp(-std::pow((x - 600) / 170, 2)) + 8 * std::sin(x / 70);
}

/// A house: easting, distance from the road (south is negative), floor plan [m], people, value [EUR].
struct House {
    double x, from_road, length, width;
    int people, value;
};
constexpr House k_houses[] = {
    {330, 14, 14, 10, 4, 450000},  {365, -30, 16, 11, 5, 520000}, {405, 16, 14, 10, 3, 400000},
    {440, -28, 18, 12, 6, 610000}, {470, 20, 14, 11, 4, 480000},  {500, 62, 15, 11, 4, 530000},
    {515, -26, 14, 10, 2, 350000}, {545, 24, 16, 12, 5, 560000},  {560, -70, 22, 14, 0, 900000},
    {585, -24, 14, 10, 3, 420000}, {610, 30, 15, 11, 4, 470000},  {620, 84, 14, 10, 2, 330000},
    {640, -32, 20, 12, 8, 980000}, {665, 26, 14, 10, 4, 430000},  {690, -64, 15, 11, 5, 500000},
    {715, 22, 16, 10, 3, 390000},  {745, -28, 14, 11, 4, 460000}, {785, 18, 15, 10, 4, 440000},
    {830, -26, 18, 12, 6, 640000}, {880, 16, 14, 10, 3, 410000}};

std::string exposed_text(const GridSpec& grid) {
    constexpr double k_parts = 1e8;  // of a degree
    const gis::CrsTransform to_degrees(grid.crs_wkt, gis::crs_from_user("EPSG:4326", ""), grid.bounds());
    const auto moved = [&](Point local) { return to_degrees(grid.map_from_local(local)); };
    const auto columns = [](const std::string& name, const char* kind, int people, int value) {
        return text_column("NAME", name) + ", " + text_column("KIND", kind) +
               ", \"PEOPLE\": " + std::to_string(people) + ", \"VALUE\": " + std::to_string(value);
    };
    std::vector<std::string> features;
    int number = 0;
    for (const House& house : k_houses) {
        const double x = house.x, y = road_line(x) + house.from_road;
        Polyline rim;
        for (const Point corner :
             {Point{x, y}, {x + house.length, y}, {x + house.length, y + house.width}, {x, y + house.width}, {x, y}})
            rim.push_back(moved(corner));
        features.push_back(feature(columns("house " + std::to_string(++number), "house", house.people, house.value),
                                   "Polygon", "[" + places_text(rim, k_parts) + "]"));
    }
    Polyline road;
    for (double x = 20; x <= 1180; x += 20) road.push_back(moved({x, road_line(x)}));
    features.push_back(feature(columns("valley road", "road", 30, 1200000), "LineString", places_text(road, k_parts)));
    return collection("", features);
}

/// Where the road meets the channels' line, and in the upper fan.
std::string gauges_text(const GridSpec& grid) {
    const auto gauge = [&](const char* name, Point local) {
        const Point at = grid.map_from_local(local);
        return feature(text_column("NAME", name), "Point", "[" + rounded(at.x, 100) + ", " + rounded(at.y, 100) + "]");
    };
    return collection(k_crs, {gauge("upper fan", {gully_line(0, 150), fan_foot(gully_line(0, 150)) + 150}),
                              gauge("road", {600, road_line(600)})});
}

}  // namespace

void write_fan_sample(const std::string& folder) {
    GridSpec grid = fan_grid();
    grid.crs_wkt = gis::crs_from_user("EPSG:32632", "");
    const std::filesystem::path in = folder;
    Raster dtm(grid);
    for (std::int64_t row = 0; row < grid.rows; ++row)
        for (std::int64_t column = 0; column < grid.columns; ++column)
            dtm.at(row, column) =
                std::round(fan_height(grid.local_from_map(grid.cell_centre(row, column))) * 100) / 100;
    gis::write_geotiff((in / "dtm.tif").string(), dtm,
                       {"dtm", "Synthetic ground", "m", {{"ORIGIN", "Made by frana's sample generator"}}});
    write_text((in / "slopes.geojson").string(), slopes_text(grid));
    write_text((in / "exposed.geojson").string(), exposed_text(grid));
    write_text((in / "gauges.geojson").string(), gauges_text(grid));
}

}  // namespace frana::sample
