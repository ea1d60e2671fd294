// SPDX-License-Identifier: Apache-2.0
#include "bench/accuracy/lake_dtm.h"

#include <algorithm>

#include "bench/accuracy/lake.h"

namespace frana::bench {
namespace {

// Every `skip`-th elevation, no mean.
Raster thinned(const Raster& dtm, std::int64_t skip) {
    const GridSpec& fine = dtm.grid;
    Raster coarse(plain_grid(fine.columns / skip, fine.rows / skip, fine.cell_size * static_cast<double>(skip)));
    for (std::int64_t row = 0; row < coarse.grid.rows; ++row)
        for (std::int64_t column = 0; column < coarse.grid.columns; ++column)
            coarse.at(row, column) = dtm.at(row * skip + skip / 2, column * skip + skip / 2);
    return coarse;
}

// Returns the level below which a third of the ground is.
double flood_level(const Raster& dtm) {
    std::vector<double> elevations = dtm.values;
    const auto third = elevations.begin() + static_cast<std::ptrdiff_t>(elevations.size() / 3);
    std::nth_element(elevations.begin(), third, elevations.end());
    return *third;
}

}  // namespace

AccuracyCase lake_dtm(const Raster& dtm) {
    const double cell = dtm.grid.cell_size, level = flood_level(dtm);
    return {"lake-dtm",
            "the sample's terrain flooded, 60 s",
            {8 * cell, 4 * cell, 2 * cell, cell},
            true,
            [dtm, level](double cell_size, Scheme scheme) {
                const Raster bed = thinned(dtm, std::llround(cell_size / dtm.grid.cell_size));
                CaseStatistics statistics = run_lake(bed, level, water(), scheme, 0, 60);
                statistics.own.back().mark = 1e-4;
                return statistics;
            }};
}

}  // namespace frana::bench
