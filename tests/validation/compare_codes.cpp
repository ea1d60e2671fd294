// SPDX-License-Identifier: Apache-2.0
// The tables and pictures of share/doc/validation.md: a result of frana beside other codes' rasters of the same case.
//
//     compare_codes RESULT_DIR MODELS_DIR THRESHOLD OUT.png TITLE
//
// MODELS_DIR contains each code's greatest thickness, normal to the bed, as *_pft.tif or *_h_max.tif, and greatest
// speed,
// *_pfv.tif or *_s_max.tif. Prints a Markdown row of each and of frana, its thickness measured the same way, and draws
// for every cell how many codes exceeded the threshold [m] with frana's outline on it.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "analysis/ground_statistics.h"
#include "analysis/trace.h"
#include "gis/crs/crs.h"
#include "gis/raster/footprint.h"
#include "gis/raster/raster_in.h"
#include "render/map/map2d.h"

namespace frana {
namespace {

double area_over(const Raster& thickness, double threshold) {
    return masked_area(trace_mask(thickness, threshold));
}

std::vector<std::string> thickness_files(const std::string& folder) {
    std::vector<std::string> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        const std::string name = entry.path().string();
        if (name.ends_with("_pft.tif") || name.ends_with("_h_max.tif")) files.push_back(name);
    }
    std::sort(files.begin(), files.end());
    return files;
}

/// A row of the tables: areas over three thicknesses [m2], greatest thickness [m], greatest speed [m/s].
void print_row(const std::string& code, const Raster& thickness, const Raster& speed) {
    std::printf("| %s | %.0f | %.0f | %.0f | %.1f | %.1f |\n", code.c_str(), area_over(thickness, 0.1),
                area_over(thickness, 0.5), area_over(thickness, 1), maximum(thickness), maximum(speed));
}

int compare(const std::string& result, const std::string& models, double threshold, const std::string& picture,
            const std::string& title) {
    const Raster bed = gis::read_result_raster(result + "/bed.tif"),
                 speed = gis::read_result_raster(result + "/max_velocity.tif"),
                 thickness = normal_depth(gis::read_result_raster(result + "/max_depth.tif"), bed);
    print_row("frana", thickness, speed);

    GridSpec local = bed.grid;  // most of the codes' files name no CRS; their coordinates are the terrain's
    local.crs_wkt.clear();
    Raster codes(bed.grid);
    const std::vector<std::string> files = thickness_files(models);
    for (const std::string& file : files) {
        const std::string name = std::filesystem::path(file).stem().string();
        const bool is_pft = name.ends_with("_pft");
        const std::string stem = file.substr(0, file.rfind(is_pft ? "_pft" : "_h_max"));
        print_row(name, gis::read_result_raster(file),
                  gis::read_result_raster(stem + (is_pft ? "_pfv.tif" : "_s_max.tif")));
        const Raster theirs = gis::read_raster_on(file, local, "", gis::Resampling::nearest, "metre").raster;
        for (std::size_t i = 0; i < codes.values.size(); ++i) codes.values[i] += theirs.values[i] > threshold;
    }
    const int count = static_cast<int>(files.size());
    for (double& n : codes.values) n = n > 0 ? n : k_no_data;

    render::MapSpec map;
    map.title = title;
    map.subtitle = "Where the greatest thickness exceeds " + std::to_string(threshold).substr(0, 3) + " m";
    map.legend_title = "Codes of " + std::to_string(count);
    map.terrain = &bed;
    map.layer = &codes;
    const int third = count / 3;
    map.categories = {{1, "1 to " + std::to_string(third), {253, 216, 140}},
                      {2, std::to_string(third + 1) + " to " + std::to_string(count - 1), {240, 130, 60}},
                      {3, "all " + std::to_string(count), {150, 40, 30}}};
    for (double& n : codes.values)
        if (!std::isnan(n)) n = n == count ? 3 : n > third ? 2 : 1;
    map.outlines = {{"frana", gis::polygonise(trace_mask(thickness, threshold)), {0, 60, 200}, 3, false}};
    map.crs_label = bed.grid.crs_wkt.empty() ? "local" : gis::crs_name(bed.grid.crs_wkt);
    map.attribution = "Other codes: ISeeSnow pilot study (AvaFrame, 2023)";
    render::write_png(picture, render::draw_map(map));
    return EXIT_SUCCESS;
}

}  // namespace
}  // namespace frana

int main(int argc, char** argv) {
    if (argc != 6) {
        std::fputs("compare_codes RESULT_DIR MODELS_DIR THRESHOLD OUT.png TITLE\n", stderr);
        return 2;
    }
    try {
        return frana::compare(argv[1], argv[2], std::atof(argv[3]), argv[4], argv[5]);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    }
}
