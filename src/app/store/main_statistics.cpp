// SPDX-License-Identifier: Apache-2.0
#include "app/store/main_statistics.h"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/store/json_file.h"
#include "app/store/result_files.h"
#include "app/store/series_ends.h"
#include "core/error.h"

namespace frana::app {

std::optional<MainStatistics> read_main_statistics(const std::string& result_folder) {
    const std::string path = (std::filesystem::path(result_folder) / k_summary_file).string();
    if (!std::filesystem::exists(path)) return std::nullopt;
    const std::optional<Json> summary = read_json_file(path);
    if (!summary)
        throw Error(ErrorKind::input, Problem{"is incomplete", path, "", "", "Restore it, or compute the scene again"});
    MainStatistics statistics;
    const auto read = [&](const std::string& name, double& value) {
        const std::optional<double> number = value_in<double>(*summary, name);
        value = number.value_or(0);
        return number.has_value();
    };
    const auto read_runout = [&](const std::string& place) {
        Runout& one = statistics.run_outs.emplace_back();
        return read(place + "/horizontal_m", one.horizontal_m) && read(place + "/drop_m", one.drop_m) &&
               read(place + "/reach_angle_deg", one.reach_angle_deg);
    };
    if (!read("/trace_threshold_m", statistics.threshold) || !read("/covered_area_m2", statistics.covered_area_m2) ||
        !read_runout("/runout"))
        return std::nullopt;
    // The first of the flows is the one in "runout". Results of older programs do not list them.
    for (std::size_t i = 0; summary->contains(Json::json_pointer("/flows/" + std::to_string(i))); ++i) {
        const std::string flow = "/flows/" + std::to_string(i);
        if (i > 0 && !read_runout(flow)) return std::nullopt;
        Runout& one = statistics.run_outs.back();
        read(flow + "/covered_area_m2", one.covered_area_m2);
        for (const auto& [name, point] : {std::pair{"/top", &one.top}, std::pair{"/tip", &one.tip}}) {
            read(flow + name + "_x", point->x);
            read(flow + name + "_y", point->y);
        }
    }
    const auto reason = value_in<std::string>(*summary, "/stop_reason_text");
    const std::string series = (std::filesystem::path(result_folder) / k_series_file).string();
    if (reason && std::filesystem::exists(series)) {
        const SeriesEnds ends = read_series_ends(series);
        statistics.end = run_end(*reason, ends.simulated_seconds, ends.last_speed,
                                 value_in<double>(*summary, "/moving_fraction").value_or(0),
                                 value_in<bool>(*summary, "/settling/front_is_final").value_or(false));
    }
    return statistics;
}

std::vector<Point> flow_tops(const std::optional<MainStatistics>& statistics) {
    std::vector<Point> tops;
    if (!statistics) return tops;
    for (const Runout& one : statistics->run_outs)
        if (one.covered_area_m2 > 0) tops.push_back(one.top);
    return tops;
}

}  // namespace frana::app
