// SPDX-License-Identifier: Apache-2.0
// Hydrographs, read and divided into rows of inflow.
#include <algorithm>
#include <cmath>

#include "app/input/prepare_inflow.h"
#include "harness.h"
#include "simulation/arrivals.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace frana;
    const fuzz::MemoryFile file("/vsimem/fuzz/hydrograph.csv", data, size);
    fuzz::refused_or_done([&] {
        const std::vector<HydrographPoint> points =
            app::read_hydrograph(file.path(), "inflow.hydrograph", 9.81, 20).points;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const HydrographPoint& p = points[i];
            if (!std::isfinite(p.time + p.discharge + p.speed) || p.discharge < 0 || p.speed < 0) __builtin_trap();
            if (i > 0 && p.time < points[i - 1].time) __builtin_trap();
        }
        // The program refuses more rows than fit in memory; here a million are enough.
        double fastest = 0, volume = 0;
        for (const HydrographPoint& p : points) fastest = std::max(fastest, p.speed);
        if (fastest > 1e4) return;
        for (const InflowBatch& batch : cut_hydrograph(points, 1, 100)) volume += batch.volume;
        if (!std::isfinite(volume)) __builtin_trap();
    });
    return 0;
}
