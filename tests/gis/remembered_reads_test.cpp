// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <filesystem>
#include <memory>

#include "core/session.h"
#include "gis/raster/plane_raster.h"
#include "gis/raster/raster_in.h"
#include "gis/raster/working_grid.h"
#include "support/files.h"

namespace frana::gis {
namespace {

using test::Folder;
using test::make_raster;
using test::plane_raster;
using test::utm_grid;

TEST(RememberedReads, TheSameReadIsMadeOnce) {
    const Folder folder;
    const std::string file = folder.file("dtm.tif");
    make_raster(file, plane_raster(8, 6, 5));
    const GridSpec grid = utm_grid(527000, 5095000, 5, 8, 6);
    const RasterRead direct = read_raster_on(file, grid, "", Resampling::automatic);
    const Session session{0, std::make_shared<RememberedReads>()};
    const auto read = [&](const GridSpec& on, Resampling resampling, const std::string& unit,
                          std::optional<double> nodata) {
        return session.read(read_raster_on, file, on, "", resampling, unit, nodata, "");
    };
    const RasterRead first = read(grid, Resampling::automatic, "auto", std::nullopt);
    (void)session.read(inspect_raster, file, "key");
    std::filesystem::remove(file);
    const RasterRead again = read(grid, Resampling::automatic, "auto", std::nullopt);
    for (const RasterRead* one : {&first, &again}) {
        EXPECT_EQ(one->raster.values, direct.raster.values);
        EXPECT_EQ(one->resampling_used, direct.resampling_used);
    }
    EXPECT_EQ(session.read(inspect_raster, file, "key").columns, 8);
    // Any other argument is another read, of a file that is no longer there.
    GridSpec other = grid;
    other.columns = 7;
    EXPECT_THROW((void)read(other, Resampling::automatic, "auto", std::nullopt), Error);
    EXPECT_THROW((void)read(grid, Resampling::cubic, "auto", std::nullopt), Error);
    EXPECT_THROW((void)read(grid, Resampling::automatic, "foot", std::nullopt), Error);
    EXPECT_THROW((void)read(grid, Resampling::automatic, "auto", 3.0), Error);
    EXPECT_THROW((void)session.read(inspect_raster, file, "another key"), Error);
    EXPECT_THROW((void)Session{}.read(read_raster_on, file, grid, "", Resampling::automatic, "auto", std::nullopt, ""),
                 Error);
}

// A raster's properties are an argument of working_grid: each of them that it depends on is in the key.
TEST(RememberedReads, PropertiesTellRastersApart) {
    const Folder folder;
    make_raster(folder.file("dtm.tif"), plane_raster(8, 6, 5));
    const RasterInfo info = inspect_raster(folder.file("dtm.tif"), "key");
    const Session session{0, std::make_shared<RememberedReads>()};
    const auto columns = [&](const RasterInfo& of) {
        return session.read(working_grid, of, of.crs_wkt, std::nullopt, std::nullopt).columns;
    };
    EXPECT_EQ(columns(info), 8);
    RasterInfo wider = info;
    wider.bounds.east += 10;
    EXPECT_EQ(columns(wider), 10);
    RasterInfo coarser = info;
    coarser.cell_x = coarser.cell_y = 10;
    EXPECT_EQ(columns(coarser), 4);
    EXPECT_EQ(columns(info), 8);
}

}  // namespace
}  // namespace frana::gis
