// SPDX-License-Identifier: Apache-2.0
#include "support/tiny_scene.h"

#include <ogr_spatialref.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <sstream>

namespace frana::test {
namespace {

namespace fs = std::filesystem;

double slope(int, int column) {
    const double x = (column + 0.5) * k_cell;
    return 300 - 0.5 * std::min(x, 200.0);
}

/// An ASCII grid's .prj contains ESRI's own version of WKT.
std::string esri_utm_32() {
    OGRSpatialReference utm;
    utm.importFromEPSG(32632);
    char* text = nullptr;
    const char* const options[] = {"FORMAT=WKT1_ESRI", nullptr};
    utm.exportToWkt(&text, options);
    const std::string result = text;
    CPLFree(text);
    return result;
}

}  // namespace

TinyScene::TinyScene() {
    std::string name = "frana_cli_" + std::to_string(::getpid()) + "_" +
                       ::testing::UnitTest::GetInstance()->current_test_info()->name();
    std::replace(name.begin(), name.end(), '/', '_');  // parameterised tests
    folder_ = fs::temp_directory_path() / name;
    fs::create_directories(folder_);
    write_dtm();
    write_polygon("perimeter", {{20, 55}, {70, 55}, {70, 95}, {20, 95}});
    write_scene();
}

TinyScene::~TinyScene() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
}

void TinyScene::write(const std::string& name, const std::string& text) const {
    fs::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name, std::ios::binary) << text;
}

void TinyScene::write_dtm(const std::function<double(int, int)>& elevation, bool with_crs,
                          const std::string& name) const {
    std::ofstream file(folder_ / name);
    file.precision(12);
    file << "ncols " << k_columns << "\nnrows " << k_rows << "\nxllcorner " << k_west << "\nyllcorner " << k_south
         << "\ncellsize " << k_cell << "\nNODATA_value -9999\n";
    for (int row = 0; row < k_rows; ++row) {
        for (int column = 0; column < k_columns; ++column)
            file << (elevation ? elevation(row, column) : slope(row, column)) << (column + 1 < k_columns ? ' ' : '\n');
    }
    const fs::path projection = (folder_ / name).replace_extension(".prj");
    fs::remove(projection);
    if (with_crs) std::ofstream(projection) << esri_utm_32();
}

void TinyScene::write_features(const std::string& name, const std::vector<TestFeature>& features) const {
    std::ofstream file(folder_ / (name + ".geojson"));
    file.precision(12);
    file
        << R"({"type": "FeatureCollection", "crs": {"type": "name", "properties": {"name": "urn:ogc:def:crs:EPSG::32632"}},)"
        << R"( "features": [)";
    for (const TestFeature& feature : features) {
        Places places = feature.places;
        if (feature.type == "Polygon") places.push_back(places.front());
        std::ostringstream coordinates;
        coordinates.precision(12);
        for (const auto& [x, y] : places)
            coordinates << (coordinates.tellp() > 0 ? "," : "") << '[' << k_west + x << ',' << k_south + y << ']';
        const int rings = feature.type == "Point" ? 0 : feature.type == "Polygon" ? 2 : 1;
        file << (&feature == &features.front() ? "" : ",") << R"({"type": "Feature", "properties": {)"
             << feature.properties << R"(}, "geometry": {"type": ")" << feature.type << R"(", "coordinates": )"
             << std::string(rings, '[') << coordinates.str() << std::string(rings, ']') << "}}";
    }
    file << "]}\n";
}

void TinyScene::write_scene(const std::string& more) const {
    write("scene.ini",
          "[terrain]\ndtm = dtm.asc\n[release]\nperimeter = perimeter.geojson\nthickness = 2\n[material]\n"
          "friction-angle = 15\nturbulence = 500\n[time]\nend = 4\n" +
              more + (more.find("[output]") == std::string::npos ? k_numbers_only : ""));
}

std::vector<std::string> TinyScene::files() const {
    std::vector<std::string> list;
    for (const auto& entry : fs::recursive_directory_iterator(folder_))
        list.push_back(entry.path().lexically_relative(folder_).string());
    std::sort(list.begin(), list.end());
    return list;
}

}  // namespace frana::test
