// SPDX-License-Identifier: Apache-2.0
#include "app/ensemble/recorded_study.h"

#include <filesystem>
#include <utility>

#include "app/store/recorded_inputs.h"

namespace frana::app {
namespace {

bool is_never_replaced(const std::string&) {
    return false;
}

std::string folder_of(const std::string& file) {
    return std::filesystem::path(file).parent_path().string();
}

}  // namespace

void find_recorded_inputs(study::StudyReading& reading, RunLog& log) {
    const auto where = [&](const std::string& key) {
        const bool of_region = reading.study.region && key.starts_with("study.");
        return reading.where(of_region ? "region" + key.substr(key.find('.')) : key);
    };
    find_recorded_files(
        {[&](const NamingText::FileMap& map) { reading.study = with_files(std::move(reading.study), map); }, where,
         is_never_replaced, true},
        folder_of(reading.study.file), log);
}

void find_recorded_inputs(study::CalibrationReading& reading, RunLog& log) {
    const auto map_files = [&](const NamingText::FileMap& map) {
        reading.calibration = with_files(std::move(reading.calibration), map);
    };
    find_recorded_files(
        {map_files, [&](const std::string& key) { return reading.where(key); }, is_never_replaced, true},
        folder_of(reading.calibration.study.file), log);
}

}  // namespace frana::app
