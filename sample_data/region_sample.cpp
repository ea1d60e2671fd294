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
#include "core/text.h"
#include "gis/crs/crs.h"
#include "gis/crs/crs_transform.h"
#include "sample_data/bindo_terrain.h"

namespace frana::sample {
namespace {

constexpr int k_rim_points = 24;

/// Where a slope may fail, in local metres, and on what bed.
struct Place {
    const char *name, *valley;
    Point middle;
    double friction;
};
constexpr Place k_places[] = {{"Alpe", "west", {160, 700}, 0.30},
                              {"Costa", "west", {395, 640}, 0.27},
                              {"Piano", "east", {1080, 660}, 0.30},
                              {"Sasso", "east", {1335, 600}, 0.33}};

struct Event {
    const char* name;
    int years;
    double radius, thickness;
};
constexpr Event k_events[] = {{"T30", 30, 18, 1}, {"T100", 100, 28, 1.5}, {"T300", 300, 40, 2.5}};

void write_text(const std::string& path, const std::string& text) {
    FileAside file(path);
    std::ofstream stream(file.partial_path(), std::ios::binary);
    stream << text;
    stream.close();
    if (!stream) throw Error(ErrorKind::environment, Problem{"cannot be written", path, "", "", "Check the folder"});
    file.rename_into_place();
}

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

std::string slopes_text(const GridSpec& grid) {
    std::vector<std::string> features;
    for (const Place& place : k_places) {
        for (const Event& event : k_events) {
            Polyline rim;
            for (int i = 0; i <= k_rim_points; ++i) {  // the first once more; counter-clockwise, longer downslope
                const double angle = 2 * std::numbers::pi * (i % k_rim_points) / k_rim_points;
                rim.push_back(grid.map_from_local({place.middle.x + 0.7 * event.radius * std::cos(angle),
                                                   place.middle.y + 1.3 * event.radius * std::sin(angle)}));
            }
            features.push_back(feature(
                "\"NAME\": \"" + std::string(place.name) + " " + event.name + "\", \"VALLEY\": \"" + place.valley +
                    "\", \"SCENARIO\": \"" + event.name + "\", \"YEARS\": " + std::to_string(event.years) +
                    ", \"THICK\": " + shortest_text(event.thickness) + ", \"MU\": " + shortest_text(place.friction),
                "Polygon", "[" + places_text(rim, 100) + "]"));
        }
    }
    return collection(R"("crs": {"type": "name", "properties": {"name": "urn:ogc:def:crs:EPSG::32632"}}, )", features);
}

std::string exposed_text(const GridSpec& grid) {
    constexpr double k_parts = 1e8;  // of a degree
    const gis::CrsTransform to_degrees(grid.crs_wkt, gis::crs_from_user("EPSG:4326", ""), grid.bounds());
    const auto moved = [&](Point local) { return to_degrees(grid.map_from_local(local)); };
    const auto named = [](const std::string& name, int people) {
        return "\"what\": \"" + name + "\", \"people\": " + std::to_string(people);
    };
    std::vector<std::string> features;
    // Some where the larger events come.
    const double houses[][2] = {{88, 120}, {205, 70},  {340, 125},  {455, 75},
                                {760, 66}, {1065, 60}, {1110, 150}, {1366, 155}};
    int number = 0;
    for (const auto& [x, from_river] : houses) {
        const double y = river_line(x) + from_river;
        Polyline rim;
        for (const Point corner : {Point{x, y}, {x + 14, y}, {x + 14, y + 10}, {x, y + 10}, {x, y}})
            rim.push_back(moved(corner));
        ++number;
        features.push_back(feature(named("house " + std::to_string(number), 3 + number % 3), "Polygon",
                                   "[" + places_text(rim, k_parts) + "]"));
    }
    Polyline road;
    for (double x = 20; x <= 1480; x += 20) road.push_back(moved({x, river_line(x) + 45}));
    features.push_back(feature(named("valley road", 40), "LineString", places_text(road, k_parts)));
    const Point camp = moved({700, river_line(700) + 40});
    features.push_back(
        feature(named("camp", 25), "Point", "[" + rounded(camp.x, k_parts) + ", " + rounded(camp.y, k_parts) + "]"));
    return collection("", features);
}

}  // namespace

void write_region_sample(const std::string& folder) {
    GridSpec grid = bindo_grid();
    grid.crs_wkt = gis::crs_from_user("EPSG:32632", "");
    const std::filesystem::path in = folder;
    write_text((in / "slopes.geojson").string(), slopes_text(grid));
    write_text((in / "exposed.geojson").string(), exposed_text(grid));
}

}  // namespace frana::sample
