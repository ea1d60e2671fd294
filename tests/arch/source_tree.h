// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace frana::test {

/// Returns files of the source tree with these endings below these folders, as paths from the root, sorted.
inline std::vector<std::string> source_files(const std::vector<std::string>& folders,
                                             const std::vector<std::string>& endings) {
    namespace fs = std::filesystem;
    const fs::path root = FRANA_SOURCE_DIR;
    std::vector<std::string> files;
    for (const std::string& folder : folders) {
        if (!fs::exists(root / folder)) continue;
        for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
            const fs::path& path = entry.path();
            if (std::find(endings.begin(), endings.end(), path.extension().string()) != endings.end())
                files.push_back(path.lexically_relative(root).string());
        }
    }
    std::sort(files.begin(), files.end());
    return files;
}

inline std::vector<std::string> lines_of(const std::string& path) {
    std::ifstream file(std::filesystem::path(FRANA_SOURCE_DIR) / path);
    std::vector<std::string> lines;
    for (std::string line; std::getline(file, line);) lines.push_back(line);
    return lines;
}

}  // namespace frana::test
