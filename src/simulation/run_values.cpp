// SPDX-License-Identifier: Apache-2.0
#include "simulation/run_values.h"

#include <algorithm>
#include <cmath>

#include "simulation/run_statistics.h"

namespace frana {
namespace {

void add_gauges(const RunResult& result, const Scene& scene, std::vector<RunValue>& values) {
    const std::vector<Gauge>& gauges = scene.recording.gauges;
    std::vector<double> depth(gauges.size()), speed(gauges.size());
    for (const GaugeRow& row : result.gauges) {
        depth[row.gauge] = std::max(depth[row.gauge], row.depth);
        speed[row.gauge] = std::max(speed[row.gauge], row.speed);
    }
    for (std::size_t i = 0; i < gauges.size(); ++i) {
        const std::string& name = gauges[i].name;
        values.push_back({"gauge " + name + ": max_depth_m", "greatest depth at gauge " + name, "m", depth[i], 0,
                          scene.numerics.minimum_depth});
        values.push_back({"gauge " + name + ": max_speed_ms", "greatest speed at gauge " + name, "m/s", speed[i], 0,
                          scene.time.moving_speed});
    }
}

void add_sections(const RunResult& result, const Scene& scene, std::vector<RunValue>& values) {
    const std::vector<CrossSection>& sections = scene.recording.sections;
    std::vector<double> discharge(sections.size()), volume(sections.size());
    for (const SectionRow& row : result.sections) {
        discharge[row.section] = std::max(discharge[row.section], std::abs(row.discharge));
        volume[row.section] = row.volume;
    }
    for (std::size_t i = 0; i < sections.size(); ++i) {
        const std::string& name = sections[i].name;
        values.push_back({"section " + name + ": max_discharge_m3s", "greatest discharge through " + name, "m3/s",
                          discharge[i], 0, 0});
        values.push_back({"section " + name + ": volume_m3", "volume through " + name, "m3", volume[i], 0, 0});
    }
}

}  // namespace

std::vector<RunValue> reported_values(const RunResult& result, const Scene& scene, double threshold) {
    const RunStatistics statistics = run_statistics(result, threshold);
    std::vector<RunValue> values;
    for (const RunStatistic& row : k_run_statistics) {
        if (!is_reported(row)) continue;
        const double value = row.of(statistics);
        const bool is_run_out = std::string_view(row.key) == k_run_out_key;
        values.push_back({row.key, row.title, row.unit, std::isnan(value) ? 0 : value,
                          is_run_out ? result.max_depth.grid.cell_size : 0, 0});
    }
    add_gauges(result, scene, values);
    add_sections(result, scene, values);
    return values;
}

}  // namespace frana
