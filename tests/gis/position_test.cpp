// SPDX-License-Identifier: Apache-2.0
// One square on the ground near the Brenner, given in four systems, is in one place.
#include <gtest/gtest.h>

#include <cmath>

#include "gis/crs/crs.h"
#include "gis/raster/footprint.h"
#include "gis/raster/raster_in.h"
#include "gis/vector/vector_in.h"
#include "support/files.h"

namespace frana::gis {
namespace {

// 200 m by 200 m in EPSG:31287, west 261000, south 346000. The other corners by
// echo X Y | gdaltransform -s_srs EPSG:31287 -t_srs EPSG:4326 -output_xy (to 32632 likewise, to 3003 from
// 4326)
const char* const k_degrees =
    "POLYGON((11.5043530639534 46.9988363492288,11.5069827019365 46.9988787383153,"
    "11.5069207856338 47.0006778082109,11.5042910587053 47.0006354176913,11.5043530639534 46.9988363492288))";
const char* const k_gauss_boaga =
    "POLYGON((1690426.88070405 5208101.40808177,1690626.64461596 5208112.51556459,"
    "1690615.53705491 5208312.27958864,1690415.7731088 5208301.17191517,1690426.88070405 5208101.40808177))";
const Point k_utm_corners[] = {{690394.861190, 5208078.846468},
                               {690594.621304, 5208089.954564},
                               {690583.513130, 5208289.714786},
                               {690383.752982, 5208278.606499}};

constexpr double k_release_cell = 5;

TEST(Position, ASquareInThreeSystemsCoversTheSameCells) {
    const test::Folder folder;
    // A terrain model of 5 m cells, 10 m high inside the square and 0 outside.
    test::TestRaster dtm{120, 120, 260800, 346400, k_release_cell, k_release_cell, "EPSG:31287", {}, std::nullopt,
                         "",  1,   0,      0,      false};
    for (int row = 0; row < 120; ++row)
        for (int column = 0; column < 120; ++column)
            dtm.values.push_back(row >= 40 && row < 80 && column >= 40 && column < 80 ? 10 : 0);
    test::make_raster(folder.file("dtm.tif"), dtm);
    test::make_vector(folder.file("release.geojson"), "GeoJSON", "EPSG:4326", {k_degrees});
    test::make_vector(folder.file("scar.shp"), "ESRI Shapefile", "EPSG:3003", {k_gauss_boaga});

    for (const char* working : {"EPSG:31287", "EPSG:32632", "EPSG:25833"}) {
        const std::string crs = crs_from_user(working, "");
        const PolygonLayer release = read_polygons(folder.file("release.geojson"), crs, "release.perimeter");
        const PolygonLayer scar = read_polygons(folder.file("scar.shp"), crs, "scar.perimeter");
        const GridSpec grid{std::floor(release.bounds.west / k_release_cell) * k_release_cell - 100,
                            std::ceil(release.bounds.north / k_release_cell) * k_release_cell + 100,
                            k_release_cell,
                            100,
                            100,
                            crs};
        const Raster square = read_raster_on(folder.file("dtm.tif"), grid, "", Resampling::bilinear).raster;
        const Raster released = coverage(release.features[0].shape.areas, grid);
        const Raster scarred = coverage(scar.features[0].shape.areas, grid);
        // Half a cell all along the outline of 800 m is the area of 80 cells. The two outlines are within a centimetre
        // of each other: of their cells only those whose centres are on an edge may differ.
        int by_raster = 0, by_scar = 0;
        for (std::size_t i = 0; i < square.values.size(); ++i) {
            by_raster += (square.values[i] > 5) != (released.values[i] > 0);
            by_scar += scarred.values[i] != released.values[i];
        }
        EXPECT_LE(by_raster, 80) << working;
        EXPECT_LE(by_scar, 40) << working;
        // The mean position must agree far better: a shift of half a cell would show in the centroids.
        const auto centroid = [&](const Raster& raster, double limit) {
            Point sum;
            int n = 0;
            for (std::int64_t row = 0; row < grid.rows; ++row) {
                for (std::int64_t column = 0; column < grid.columns; ++column) {
                    if (!(raster.at(row, column) > limit)) continue;
                    const Point centre = grid.cell_centre(row, column);
                    sum.x += centre.x - grid.west;
                    sum.y += centre.y - grid.south();
                    ++n;
                }
            }
            return Point{sum.x / n, sum.y / n};
        };
        const Point a = centroid(square, 5), b = centroid(released, 0), c = centroid(scarred, 0);
        EXPECT_LT(std::hypot(a.x - b.x, a.y - b.y), k_release_cell / 2) << working;
        EXPECT_LT(std::hypot(c.x - b.x, c.y - b.y), k_release_cell / 2) << working;
    }
}

TEST(Position, CornersAgreeWithGdaltransform) {
    const test::Folder folder;
    test::make_vector(folder.file("release.geojson"), "GeoJSON", "EPSG:4326", {k_degrees});
    test::make_vector(folder.file("scar.shp"), "ESRI Shapefile", "EPSG:3003", {k_gauss_boaga});
    const std::string utm = crs_from_user("EPSG:32632", "");
    for (const char* name : {"release.geojson", "scar.shp"}) {
        const PolygonLayer layer = read_polygons(folder.file(name), utm, "");
        for (const Point& corner : k_utm_corners) {
            double nearest = HUGE_VAL;
            for (const Point& p : layer.features[0].shape.areas[0].outer)
                nearest = std::min(nearest, std::hypot(p.x - corner.x, p.y - corner.y));
            EXPECT_LT(nearest, 0.01) << name;
        }
    }
}

}  // namespace
}  // namespace frana::gis
