// SPDX-License-Identifier: Apache-2.0
#include "app/store/main_figures.h"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/store/json_file.h"
#include "app/store/result_files.h"
#include "core/error.h"

namespace frana::app {

std::optional<MainFigures> read_main_figures(const std::string& result_folder) {
    const std::string path = (std::filesystem::path(result_folder) / k_summary_file).string();
    if (!std::filesystem::exists(path)) return std::nullopt;
    const std::optional<Json> summary = read_json_file(path);
    if (!summary)
        throw Error(ErrorKind::input, Problem{"is incomplete", path, "", "", "Restore it, or compute the scene again"});
    MainFigures figures;
    const std::pair<const char*, double*> k_places[] = {{"/trace_threshold_m", &figures.threshold},
                                                        {"/covered_area_m2", &figures.covered_area_m2},
                                                        {"/runout/horizontal_m", &figures.run_out.horizontal_m},
                                                        {"/runout/drop_m", &figures.run_out.drop_m},
                                                        {"/runout/reach_angle_deg", &figures.run_out.reach_angle_deg}};
    for (const auto& [name, value] : k_places) {
        const std::optional<double> number = value_in<double>(*summary, name);
        if (!number) return std::nullopt;
        *value = *number;
    }
    return figures;
}

}  // namespace frana::app
