// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/error.h"

namespace frana::gis::test {

/// A folder that is removed with its contents.
class Folder {
  public:
    Folder();
    ~Folder();
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    [[nodiscard]] std::string file(const std::string& name) const { return (path_ / name).string(); }
    [[nodiscard]] std::vector<std::string> names() const;

  private:
    std::filesystem::path path_;
};

/// Properties of a test raster; values row by row from the north.
struct TestRaster {
    int columns = 0, rows = 0;
    double west = 0, north = 0, cell_x = 1, cell_y = 1;
    std::string crs;  ///< user input; empty: none
    std::vector<double> values;
    std::optional<double> nodata;
    std::string unit;
    double scale = 1, offset = 0;
    double rotation = 0;  ///< geotransform's second term
    bool bytes = false;
};
void make_raster(const std::string& path, const TestRaster& raster);
/// Copies a raster as a file of another GDAL driver: "PNG", "JPEG".
void copy_as(const std::string& from, const std::string& to, const std::string& driver);

/// Writes a vector file of one layer from WKT geometries, with a number "thick" (10, 20, ...) and a text "name".
void make_vector(const std::string& path, const std::string& driver, const std::string& crs,
                 const std::vector<std::string>& wkt, const std::string& layer = "shapes");

std::string text_in(const std::string& path);
void write_text(const std::string& path, const std::string& text);

/// Returns the Error that a call throws; fails the test (and returns an empty one) if it throws none.
Error error_of(const std::function<void()>& call);

}  // namespace frana::gis::test
