// SPDX-License-Identifier: Apache-2.0
#include "gis/raster/raster_in.h"

#include <gdal_priv.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "gis/access/gdal_session.h"
#include "gis/crs/crs.h"
#include "gis/crs/crs_transform.h"
#include "plane_raster.h"
#include "support/files.h"
#include "support/problems.h"

namespace frana::gis {
namespace {

using test::error_of;
using test::Folder;
using test::make_raster;
using test::plane;
using test::plane_raster;
using test::TestRaster;
using test::utm_grid;

TEST(InspectRaster, ReadsTheFilesProperties) {
    const Folder folder;
    TestRaster raster = plane_raster(4, 3, 5);
    raster.nodata = -9999;
    make_raster(folder.file("dtm.tif"), raster);
    const RasterInfo info = inspect_raster(folder.file("dtm.tif"), "scene.ini: terrain.dtm");
    EXPECT_EQ(info.crs_label, "EPSG:32632 (WGS 84 / UTM zone 32N)");
    EXPECT_EQ(info.driver, "GTiff");
    EXPECT_EQ(info.columns, 4);
    EXPECT_EQ(info.rows, 3);
    EXPECT_EQ(info.cell_x, 5);
    EXPECT_EQ(info.bounds.east, 527020);
    EXPECT_EQ(info.bounds.south, 5094985);
    EXPECT_TRUE(info.has_nodata);
    EXPECT_EQ(info.nodata, -9999);
    EXPECT_EQ(info.vertical_unit, "m");
    EXPECT_FALSE(info.rotated);
    EXPECT_EQ(folder.names(), std::vector<std::string>{"dtm.tif"}) << "reading must leave no file behind";
}

TEST(InspectRaster, RefusesWithPathAndKey) {
    const Folder folder;
    test::write_text(folder.file("note.txt"), "not a raster");
    test::write_text(folder.file("nowhere.asc"), "");
    std::vector<std::string> remedies;
    for (const char* name : {"missing.tif", "note.txt"}) {
        const Error error = error_of([&] { (void)inspect_raster(folder.file(name), "scene.ini: terrain.dtm"); });
        EXPECT_EQ(error.kind(), ErrorKind::input);
        EXPECT_EQ(error.problems().front().where, "scene.ini: terrain.dtm");
        EXPECT_EQ(error.problems().front().value, folder.file(name));
        remedies.push_back(error.problems().front().remedy);
    }
    EXPECT_NE(remedies[0], remedies[1]) << "a file that does not exist needs another remedy";
    test::write_text(folder.file("unplaced.pgm"), "P2\n2 2\n255\n1 2\n3 4\n");
    EXPECT_EQ(error_of([&] { (void)inspect_raster(folder.file("unplaced.pgm"), ""); }).kind(), ErrorKind::input);
}

// 4 cells whose blocks would need 2.5 GB, all bands interleaved.
TEST(InspectRaster, RefusesBlocksThatNeedTooMuchMemory) {
    const Folder folder;
    const GdalSession session;
    const char* const options[] = {"TILED=YES",      "BLOCKXSIZE=1024",  "BLOCKYSIZE=1024",
                                   "SPARSE_OK=TRUE", "INTERLEAVE=PIXEL", nullptr};
    GDALDriver& driver = *GetGDALDriverManager()->GetDriverByName("GTiff");
    GDALDatasetUniquePtr(
        driver.Create(folder.file("blocks.tif").c_str(), 2, 2, 300, GDT_Float64, const_cast<char**>(options)))
        .reset();
    const Error error = error_of([&] { (void)inspect_raster(folder.file("blocks.tif"), "scene.ini: terrain.dtm"); });
    EXPECT_TRUE(has_problem(error.problems(), "scene.ini: terrain.dtm", "1024 x 1024 cells, 300 bands", "up to 1 GB"));
}

TEST(ReadRaster, SameCellsAreCopiedBitByBit) {
    const Folder folder;
    make_raster(folder.file("dtm.tif"), plane_raster(40, 30, 5));
    const RasterRead read =
        read_raster_on(folder.file("dtm.tif"), utm_grid(527010, 5094990, 5, 20, 10), "", Resampling::automatic);
    EXPECT_EQ(read.resampling_used, "exact copy");
    EXPECT_EQ(read.nodata_cells, 0);
    for (int row = 0; row < 10; ++row) {
        for (int column = 0; column < 20; ++column) {
            const double x = 527000 + (column + 2.5) * 5, y = 5095000 - (row + 2.5) * 5;
            ASSERT_EQ(read.raster.at(row, column), plane(x, y));
        }
    }
}

TEST(ReadRaster, BeyondTheFileThereIsNoData) {
    const Folder folder;
    make_raster(folder.file("dtm.tif"), plane_raster(4, 4, 5));
    for (const double cell : {5.0, 2.5}) {
        const RasterRead read =
            read_raster_on(folder.file("dtm.tif"), utm_grid(526990, 5095010, cell, 12, 12), "", Resampling::automatic);
        const auto inside = static_cast<std::int64_t>(20 / cell * 20 / cell);
        const auto covered = std::min<std::int64_t>(inside, cell == 5 ? 16 : 64);
        EXPECT_EQ(read.nodata_cells, 144 - covered) << cell;
        EXPECT_TRUE(std::isnan(read.raster.at(0, 0)));
    }
    const RasterRead nothing =
        read_raster_on(folder.file("dtm.tif"), utm_grid(600000, 5095010, 5, 3, 3), "", Resampling::automatic);
    EXPECT_EQ(nothing.nodata_cells, 9);
}

TEST(ReadRaster, APlaneStaysAPlane) {
    const Folder folder;
    make_raster(folder.file("dtm.tif"), plane_raster(60, 60, 5));
    struct Wanted {
        double cell;
        Resampling resampling;
        const char* name;
    };
    for (const Wanted& w : {Wanted{2, Resampling::automatic, "bilinear"}, Wanted{15, Resampling::automatic, "average"},
                            Wanted{10, Resampling::average, "average"}, Wanted{2, Resampling::cubic, "cubic"}}) {
        const int n = static_cast<int>(240 / w.cell);
        const GridSpec grid = utm_grid(527030, 5094970, w.cell, n, n);
        const RasterRead read = read_raster_on(folder.file("dtm.tif"), grid, "", w.resampling);
        EXPECT_EQ(read.resampling_used, w.name);
        for (int row = 0; row < n; ++row) {
            for (int column = 0; column < n; ++column) {
                const Point centre = grid.cell_centre(row, column);
                // Rounding of weights only: 1e-9 of values about 1000.
                ASSERT_NEAR(read.raster.at(row, column), plane(centre.x, centre.y), 1e-6) << w.name << " " << w.cell;
            }
        }
    }
}

// Larger cells that are no integer multiple of the file's, on any lattice: a mean over partial cells, each as a step,
// would make the plane uneven by up to an eighth of a cell's rise, here 0.2 m.
TEST(ReadRaster, APlaneStaysAPlaneWhateverTheRatio) {
    const Folder folder;
    make_raster(folder.file("dtm.tif"), plane_raster(60, 60, 5));
    for (const double cell : {6.3, 7.5, 8.7, 10.0, 12.0, 12.5, 17.0}) {
        const int n = static_cast<int>(270 / cell);
        const GridSpec grid = utm_grid(527011.7, 5094986.1, cell, n, n);
        const RasterRead read = read_raster_on(folder.file("dtm.tif"), grid, "", Resampling::automatic);
        EXPECT_EQ(read.resampling_used, "average");
        for (int row = 0; row < n; ++row) {
            for (int column = 0; column < n; ++column) {
                const Point centre = grid.cell_centre(row, column);
                ASSERT_NEAR(read.raster.at(row, column), plane(centre.x, centre.y), 1e-9) << cell;  // rounding
            }
        }
    }
}

// One high cell: its volume is conserved, wherever the edges of the larger cells divide it.
TEST(ReadRaster, AnAverageConservesVolume) {
    const Folder folder;
    TestRaster spike = plane_raster(60, 60, 5);
    spike.values.assign(spike.values.size(), 0);
    spike.values[31 * 60 + 29] = 1;
    make_raster(folder.file("spike.tif"), spike);
    const auto kept = [&](double cell, double shift) {
        const int n = static_cast<int>(250 / cell);
        const GridSpec grid = utm_grid(527020 + shift, 5094980 - 0.7 * shift, cell, n, n);
        const RasterRead read = read_raster_on(folder.file("spike.tif"), grid, "", Resampling::average);
        double sum = 0;
        for (const double value : read.raster.values) sum += value;
        return sum * cell * cell / 25;
    };
    for (const double shift : {0.0, 0.9, 1.7, 3.1, 4.2}) {
        // One or two points for each cell along each side distribute it exactly.
        for (const double cell : {5.0, 7.5, 10.0, 12.5, 20.0}) ASSERT_NEAR(kept(cell, shift), 1, 1e-9) << cell;
        // Otherwise to the difference of a hat function's sum over points from its integral: its transform, sinc^2, at
        // multiples of the number of points per cell; in both directions.
        for (const double cell : {12.0, 10.5, 6.5}) {
            const double points = std::ceil(2 * cell / 5) / (cell / 5);
            double off = 0;
            for (int m = 1; m < 100; ++m) off += 2 * std::pow(std::sin(M_PI * m * points) / (M_PI * m * points), 2);
            ASSERT_NEAR(kept(cell, shift), 1, (1 + off) * (1 + off) - 1) << cell << ' ' << shift;
        }
    }
}

TEST(ReadRaster, StripsLeaveNoSeam) {
    const Folder folder;
    // 3000 x 3000 cells averaged onto 30 x 30: more than is read at once.
    make_raster(folder.file("dtm.tif"), plane_raster(3000, 3000, 0.1));
    const GridSpec grid = utm_grid(527000, 5095000, 10, 30, 30);
    const RasterRead read = read_raster_on(folder.file("dtm.tif"), grid, "", Resampling::automatic);
    for (int row = 0; row < 30; ++row) {
        const Point centre = grid.cell_centre(row, 7);
        ASSERT_NEAR(read.raster.at(row, 7), plane(centre.x, centre.y), 1e-6);
    }
}

TEST(ReadRaster, FeetBecomeMetres) {
    const Folder folder;
    struct Wanted {
        const char* unit;
        const char* crs;
        const char* override_unit;
        double factor;
    };
    for (const Wanted& w :
         {Wanted{"ft", "EPSG:32632", "auto", 0.3048}, Wanted{"US survey foot", "EPSG:32632", "auto", 1200.0 / 3937},
          Wanted{"m", "EPSG:32632", "auto", 1}, Wanted{"", "EPSG:32632+6360", "auto", 1200.0 / 3937},
          Wanted{"", "EPSG:32632+5703", "auto", 1}, Wanted{"", "EPSG:32632", "foot", 0.3048},
          Wanted{"ft", "EPSG:32632", "metre", 1}}) {
        TestRaster raster = plane_raster(4, 4, 5);
        raster.unit = w.unit;
        raster.crs = w.crs;
        make_raster(folder.file("dtm.tif"), raster);
        const RasterRead read = read_raster_on(folder.file("dtm.tif"), utm_grid(527000, 5095000, 5, 4, 4), "",
                                               Resampling::automatic, w.override_unit);
        EXPECT_DOUBLE_EQ(read.raster.at(0, 0), raster.values[0] * w.factor) << w.unit << " " << w.crs;
    }
}

TEST(ReadRaster, ReprojectsToTheRightPlace) {
    const Folder folder;
    // A plane in degrees, 0.0001 degree cells; its values at any UTM point follow from the point's own
    // degrees.
    const auto height = [](Point degrees) { return 1000 + 5000 * (degrees.x - 9.37) + 8000 * (degrees.y - 46); };
    TestRaster raster{400, 300, 9.36, 46.02, 1e-4, 1e-4, "EPSG:4326", {}, std::nullopt, "", 1, 0, 0, false};
    for (int row = 0; row < 300; ++row) {
        for (int column = 0; column < 400; ++column) {
            raster.values.push_back(height({9.36 + (column + 0.5) * 1e-4, 46.02 - (row + 0.5) * 1e-4}));
        }
    }
    make_raster(folder.file("dtm.tif"), raster);
    const GridSpec grid = utm_grid(528400, 5094800, 5, 200, 100);
    const RasterRead read = read_raster_on(folder.file("dtm.tif"), grid, "", Resampling::bilinear);
    EXPECT_EQ(read.nodata_cells, 0);
    const CrsTransform to_degrees(grid.crs_wkt, crs_from_user("EPSG:4326", ""));
    for (int row = 0; row < 100; row += 7) {
        for (int column = 0; column < 200; column += 7) {
            // Positions are approximated to 0.01 cell of 1e-4 degrees, in each direction.
            const double tolerance = 0.01 * 1e-4 * (5000 + 8000);
            ASSERT_NEAR(read.raster.at(row, column), height(to_degrees(grid.cell_centre(row, column))), tolerance);
        }
    }
}

TEST(ReadRaster, TiltedRastersAndOblongCellsGiveThePlane) {
    const Folder folder;
    for (const auto& [cell_y, rotation] : {std::pair{5.0, 0.5}, {10.0, 0.0}}) {
        TestRaster raster = plane_raster(40, 40, 5);
        raster.cell_y = cell_y;
        raster.rotation = rotation;
        for (int row = 0; row < 40; ++row) {
            for (int column = 0; column < 40; ++column) {
                const double c = column + 0.5, r = row + 0.5;
                raster.values[static_cast<std::size_t>(row * 40 + column)] =
                    plane(527000 + 5 * c + rotation * r, 5095000 + rotation * c - cell_y * r);
            }
        }
        make_raster(folder.file("dtm.tif"), raster);
        EXPECT_EQ(inspect_raster(folder.file("dtm.tif"), "").rotated, rotation != 0);
        const GridSpec grid = utm_grid(527050, 5094950, 5, 20, 20);
        const RasterRead read = read_raster_on(folder.file("dtm.tif"), grid, "", Resampling::bilinear);
        for (int i = 0; i < 20; ++i) {
            const Point centre = grid.cell_centre(i, 19 - i);
            ASSERT_NEAR(read.raster.at(i, 19 - i), plane(centre.x, centre.y), 1e-6);
        }
    }
}

TEST(ReadRaster, StoredFromTheSouthItIsTheSame) {
    const Folder folder;
    TestRaster raster = plane_raster(6, 4, 5);
    TestRaster upside_down = raster;
    upside_down.north = raster.north - 4 * 5;
    upside_down.cell_y = -5;
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 6; ++column) {
            upside_down.values[static_cast<std::size_t>((3 - row) * 6 + column)] =
                raster.values[static_cast<std::size_t>(row * 6 + column)];
        }
    }
    make_raster(folder.file("dtm.tif"), raster);
    make_raster(folder.file("south.tif"), upside_down);
    for (const GridSpec& grid :
         {utm_grid(527000, 5095000, 5, 6, 4), utm_grid(527005, 5094995, 5, 9, 9), utm_grid(526990, 5095010, 5, 4, 4)}) {
        const RasterRead right = read_raster_on(folder.file("dtm.tif"), grid, "", Resampling::automatic);
        const RasterRead turned = read_raster_on(folder.file("south.tif"), grid, "", Resampling::automatic);
        EXPECT_EQ(turned.resampling_used, "exact copy");
        for (std::size_t i = 0; i < right.raster.values.size(); ++i) {
            const double a = right.raster.values[i], b = turned.raster.values[i];
            ASSERT_TRUE(a == b || (std::isnan(a) && std::isnan(b))) << i << ": " << a << ", " << b;
        }
    }
}

TEST(ReadRaster, AcrossTheAntimeridianThereIsNoGap) {
    const Folder folder;
    // Taveuni, Fiji: counted 179.9 to 180.1, as a mosaic of tiles is, and -180.1 to -179.9.
    for (const double west : {179.9, -180.1}) {
        TestRaster raster{200, 100, west, -16.4, 1e-3, 1e-3, "EPSG:4326", {}, std::nullopt, "", 1, 0, 0, false};
        for (int row = 0; row < 100; ++row)
            for (int column = 0; column < 200; ++column) raster.values.push_back(column);
        make_raster(folder.file("dtm.tif"), raster);
        // UTM zone 1 south around 180 E 16.45 S, which gdaltransform puts at 179629.768, 8178910.424.
        const GridSpec grid{175000, 8180000, 100, 90, 20, crs_from_user("EPSG:32701", "")};
        const RasterRead read = read_raster_on(folder.file("dtm.tif"), grid, "", Resampling::bilinear);
        EXPECT_EQ(read.nodata_cells, 0);
        // Column 99.5 there; half a cell of the grid is half a cell of the file.
        const Point at_180 = grid.local_from_map({179629.768, 8178910.424});
        EXPECT_NEAR(read.raster.at(10, static_cast<std::int64_t>(at_180.x / 100)), 99.5, 0.5) << west;
    }
}

TEST(ReadRaster, WithoutACrsOnlyLocalWorks) {
    const Folder folder;
    TestRaster raster = plane_raster(4, 4, 5);
    raster.crs.clear();
    make_raster(folder.file("dtm.tif"), raster);
    GridSpec grid = utm_grid(527000, 5095000, 5, 4, 4);
    const Error error =
        error_of([&] { (void)read_raster_on(folder.file("dtm.tif"), grid, "", Resampling::automatic); });
    EXPECT_TRUE(has_problem(error.problems(), "dtm.tif"));
    EXPECT_NE(error.problems().front().remedy.find("-a_srs"), std::string::npos);
    EXPECT_EQ(read_raster_on(folder.file("dtm.tif"), grid, grid.crs_wkt, Resampling::automatic).nodata_cells, 0);
    grid.crs_wkt.clear();
    EXPECT_EQ(read_raster_on(folder.file("dtm.tif"), grid, "", Resampling::automatic).nodata_cells, 0);
}

}  // namespace
}  // namespace frana::gis
