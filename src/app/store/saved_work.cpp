// SPDX-License-Identifier: Apache-2.0
#include "app/store/saved_work.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "app/store/checkpoints.h"
#include "app/store/result_files.h"
#include "app/store/unfinished_results.h"
#include "core/folder_entries.h"

namespace frana::app {
namespace {

namespace fs = std::filesystem;

constexpr const char *k_record_beginning = "record_", *k_record_ending = ".frana";

}  // namespace

std::string record_file(const std::string& folder, std::size_t member) {
    char name[40];
    std::snprintf(name, sizeof name, "%s%07zu%s", k_record_beginning, member, k_record_ending);
    return (fs::path(folder) / k_record_folder / name).string();
}

std::vector<std::string> records_in(const std::string& folder) {
    std::vector<std::string> files;
    for (const fs::directory_entry& entry : folder_entries(fs::path(folder) / k_record_folder)) {
        const std::string name = entry.path().filename().string();
        if (entry.is_directory())
            for (std::string& file : records_in(entry.path().string())) files.push_back(std::move(file));
        const bool partial = name.find(".partial") != std::string::npos;
        if (name.starts_with(k_record_beginning) && name.ends_with(k_record_ending) && !partial)
            files.push_back(entry.path().string());
    }
    std::sort(files.begin(), files.end());
    return files;
}

bool has_saved_work(const std::string& folder) {
    return !checkpoints_in(folder).empty() || !records_in(folder).empty();
}

std::string interrupted_study(const std::string& directory) {
    for (const std::string& folder : abandoned_results(directory))
        if (!records_in(folder).empty()) return folder;
    return {};
}

}  // namespace frana::app
