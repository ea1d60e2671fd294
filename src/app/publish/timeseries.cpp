// SPDX-License-Identifier: Apache-2.0
#include "app/publish/timeseries.h"

#include "core/shortest_text.h"

namespace frana::app {

std::string timeseries_csv(const std::vector<SeriesRow>& series) {
    std::string text =
        "time_s,step,dt_s,volume_m3,volume_left_m3,max_depth_m,max_speed_ms,front_distance_m,kinetic_energy_"
        "j,"
        "covered_area_m2,volume_entered_m3,volume_inflow_m3,volume_eroded_m3,volume_deposited_m3\n";
    for (const SeriesRow& row : series) {
        text += shortest_text(row.time);
        text += ',';
        text += std::to_string(row.step);
        for (const double value :
             {row.dt, row.volume, row.volume_left, row.max_depth, row.max_speed, row.front_distance, row.kinetic_energy,
              row.covered_area, row.volume_entered, row.volume_inflow, row.volume_eroded, row.volume_deposited}) {
            text += ',';
            text += shortest_text(value);
        }
        text += '\n';
    }
    return text;
}

}  // namespace frana::app
