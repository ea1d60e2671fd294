// SPDX-License-Identifier: Apache-2.0
// Compares the change of elevation of a result with a surveyed one, for share/doc/validation.md.
//
//     compare_change RESULT_DIR SURVEYED.tif
//
// The run must have removed the release from the DTM. Its change is: deposit minus release, minus erosion, plus
// deposition into the bed.
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <string>

#include "gis/raster/raster_in.h"

namespace frana {
namespace {

Raster or_zero(const std::string& path, const GridSpec& grid) {
    Raster raster(grid);
    if (!std::filesystem::exists(path)) return raster;
    raster = gis::read_result_raster(path);
    for (double& value : raster.values) value = std::isnan(value) ? 0 : value;
    return raster;
}

struct Volumes {
    double lowered = 0, raised = 0;

    void add(double change, double area) { (change < 0 ? lowered : raised) += change * area; }
};

int compare(const std::string& result, const std::string& survey) {
    const Raster dtm = gis::read_result_raster(result + "/dtm.tif");
    const GridSpec& grid = dtm.grid;
    const Raster surveyed = gis::read_raster_on(survey, grid, "", gis::Resampling::nearest, "metre").raster;
    const Raster left = or_zero(result + "/final_depth.tif", grid), gone = or_zero(result + "/release.tif", grid),
                 eroded = or_zero(result + "/eroded_depth.tif", grid),
                 deposited = or_zero(result + "/deposited_depth.tif", grid);
    Volumes observed, computed, computed_there;
    double squares = 0;
    std::int64_t cells = 0;
    for (std::size_t i = 0; i < surveyed.values.size(); ++i) {
        const double change = left.values[i] - gone.values[i] - eroded.values[i] + deposited.values[i];
        computed.add(change, grid.cell_area());
        if (std::isnan(surveyed.values[i])) continue;
        observed.add(surveyed.values[i], grid.cell_area());
        computed_there.add(change, grid.cell_area());
        squares += std::pow(change - surveyed.values[i], 2);
        ++cells;
    }
    std::printf("surveyed: lowered %.0f m3, raised %.0f m3 on %.0f m2\n", observed.lowered, observed.raised,
                static_cast<double>(cells) * grid.cell_area());
    std::printf("frana:    lowered %.0f m3, raised %.0f m3; on the surveyed ground %.0f and %.0f m3\n",
                computed.lowered, computed.raised, computed_there.lowered, computed_there.raised);
    std::printf("root mean square difference on the surveyed ground %.2f m\n",
                std::sqrt(squares / static_cast<double>(cells)));
    return 0;
}

}  // namespace
}  // namespace frana

int main(int argc, char** argv) {
    if (argc != 3) {
        std::fputs("compare_change RESULT_DIR SURVEYED.tif\n", stderr);
        return 2;
    }
    try {
        return frana::compare(argv[1], argv[2]);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    }
}
