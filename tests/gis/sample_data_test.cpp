// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>

#include "gis/crs/crs.h"
#include "gis/raster/raster_in.h"
#include "gis/vector/vector_in.h"
#include "sample_data/bindo_terrain.h"
#include "sample_data/samples.h"
#include "support/files.h"

namespace frana::gis {
namespace {

const std::filesystem::path k_committed = std::filesystem::path(FRANA_SOURCE_DIR) / "sample_data" / "bindo";

std::string committed(const char* name) {
    return (k_committed / name).string();
}

TEST(SampleData, IsGeneratedBitForBitAsCommitted) {
    const test::Folder folder;
    sample::write_bindo_sample(folder.file("."));
    std::size_t compared = 0;
    for (const std::string& name : folder.names()) {
        EXPECT_TRUE(test::text_in(folder.file(name)) == test::text_in(committed(name.c_str())))
            << name << " differs: run generate_sample bindo sample_data/bindo if the change is wanted";
        ++compared;
    }
    EXPECT_EQ(compared, 12U);  // two rasters, two shapefiles of five files each
}

TEST(SampleData, OtherScenesAreGeneratedBitForBitAsCommitted) {
    using Write = void (*)(const std::string&);
    for (const auto& [name, write] : {std::pair<const char*, Write>{"fan", sample::write_fan_sample},
                                      {"flume", sample::write_flume_sample},
                                      {"fracture", sample::write_fracture_sample},
                                      {"reservoir", sample::write_reservoir_sample}}) {
        const test::Folder folder;
        write(folder.file("."));
        for (const std::string& file : folder.names())
            EXPECT_TRUE(test::text_in(folder.file(file)) == test::text_in((k_committed / ".." / name / file).string()))
                << name << '/' << file << " differs: run generate_sample " << name << " if the change is wanted";
        const std::string sample = name;
        EXPECT_EQ(folder.names().size(), sample == "flume" ? 3U : sample == "reservoir" ? 2U : 4U);
    }
}

TEST(SampleData, ReleaseHasItsVolumeAndIsInItsPerimeter) {
    const Raster thickness = read_result_raster(committed("thickness.tif"));
    double volume = 0, thickest = 0;
    for (const double value : thickness.values) {
        volume += value * thickness.grid.cell_area();
        thickest = std::max(thickest, value);
    }
    EXPECT_NEAR(volume, sample::k_release_volume, 0.01 * sample::k_release_volume);  // the accuracy stated for the
                                                                                     // sample
    EXPECT_NEAR(thickest, sample::k_release_thickest, 0.1);
    const PolygonLayer perimeter = read_polygons(committed("perimeter.shp"), thickness.grid.crs_wkt, "perimeter");
    ASSERT_EQ(perimeter.features.size(), 1U);
    for (std::int64_t row = 0; row < thickness.grid.rows; ++row) {
        for (std::int64_t column = 0; column < thickness.grid.columns; ++column) {
            // The edge's 120 straight segments are up to 0.15 m inside the curve, where the bowl is thinner than 0.2 m.
            if (thickness.at(row, column) < 0.2) continue;
            ASSERT_TRUE(contains(perimeter.features[0].shape.areas, thickness.grid.cell_centre(row, column)));
        }
    }
}

TEST(SampleData, OutlinesOfBothDatumsAreWhereTheyWereDrawn) {
    const GridSpec grid = sample::bindo_grid();
    const std::string utm = crs_from_user("EPSG:32632", "");
    struct Wanted {
        const char* file;
        Ring ring;
        const char* crs;
        double rounding;
    };
    // Coordinates are rounded to 1e-9 degrees (0.1 mm) and to 1 mm (0.7 mm in the plane). PROJ inverts the
    // datum shift to first order in its rotations: 1.4e-5 squared times the Earth's radius is another 1.2 mm.
    for (const Wanted& w : {Wanted{"perimeter.shp", sample::release_rim(), "EPSG:4326", 2e-4},
                            Wanted{"scar.shp", sample::scar_outline(), "EPSG:3003", 2e-3}}) {
        const PolygonLayer layer = read_polygons(committed(w.file), utm, w.file);
        EXPECT_EQ(layer.crs_label.substr(0, 9), w.crs);
        const Ring& read = layer.features[0].shape.areas[0].outer;
        for (const Point& local : w.ring) {
            const Point map = grid.map_from_local(local);
            double nearest = 1e9;
            for (const Point& point : read) nearest = std::min(nearest, std::hypot(point.x - map.x, point.y - map.y));
            EXPECT_LT(nearest, w.rounding) << w.file;
        }
    }
}

TEST(SampleData, TheHillsideIsAsSteepAsTheEvents) {
    const Raster dtm = read_result_raster(committed("dtm.tif"));
    EXPECT_EQ(dtm.grid.columns, 300);
    EXPECT_EQ(dtm.grid.rows, 270);
    EXPECT_EQ(dtm.grid.cell_size, 5);
    double fall = 0;
    for (std::int64_t column = 0; column < 300; ++column) fall += dtm.at(0, column) - dtm.at(190, column);
    const double degrees = std::atan(fall / 300 / (190 * 5)) * 180 / 3.14159265358979;
    EXPECT_NEAR(degrees, 28, 1);
    // The river flows to the east: its bed there is lower.
    const auto lowest = [&](std::int64_t column) {
        double low = 1e9;
        for (std::int64_t row = 0; row < 270; ++row) low = std::min(low, dtm.at(row, column));
        return low;
    };
    EXPECT_GT(lowest(0) - lowest(299), 15);
}

}  // namespace
}  // namespace frana::gis
