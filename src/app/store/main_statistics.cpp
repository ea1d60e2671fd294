// SPDX-License-Identifier: Apache-2.0
#include "app/store/main_statistics.h"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/store/json_file.h"
#include "app/store/result_files.h"
#include "core/error.h"

namespace frana::app {

std::optional<MainStatistics> read_main_statistics(const std::string& result_folder) {
    const std::string path = (std::filesystem::path(result_folder) / k_summary_file).string();
    if (!std::filesystem::exists(path)) return std::nullopt;
    const std::optional<Json> summary = read_json_file(path);
    if (!summary)
        throw Error(ErrorKind::input, Problem{"is incomplete", path, "", "", "Restore it, or compute the scene again"});
    MainStatistics statistics;
    const std::pair<const char*, double*> k_places[] = {
        {"/trace_threshold_m", &statistics.threshold},
        {"/covered_area_m2", &statistics.covered_area_m2},
        {"/runout/horizontal_m", &statistics.run_out.horizontal_m},
        {"/runout/drop_m", &statistics.run_out.drop_m},
        {"/runout/reach_angle_deg", &statistics.run_out.reach_angle_deg}};
    for (const auto& [name, value] : k_places) {
        const std::optional<double> number = value_in<double>(*summary, name);
        if (!number) return std::nullopt;
        *value = *number;
    }
    return statistics;
}

}  // namespace frana::app
