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

}  // namespace
}  // namespace frana::gis
