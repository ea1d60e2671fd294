// SPDX-License-Identifier: Apache-2.0
#include "params/keys/materials.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "core/error.h"
#include "params/grammar/value_text.h"

namespace frana {
namespace {

std::vector<std::string> comments_of(const std::filesystem::path& path) {
    std::vector<std::string> comments;
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);) {
        if (line.rfind('#', 0) != 0 || line.find("SPDX-License-Identifier") != std::string::npos) continue;
        comments.push_back(trimmed(line.substr(1)));
    }
    return comments;
}

}  // namespace

std::vector<MaterialPreset> material_presets(const std::string& directory) {
    namespace fs = std::filesystem;
    std::error_code error;
    std::vector<MaterialPreset> presets;
    for (const fs::directory_entry& entry : fs::directory_iterator(directory, error)) {
        if (entry.path().extension() != ".ini") continue;
        presets.push_back({entry.path().stem().string(), entry.path().string(), comments_of(entry.path()),
                           read_ini(entry.path().string())});
    }
    if (error)
        throw Error(ErrorKind::environment, Problem{"the folder of material presets cannot be read", directory, "", "",
                                                    "Set FRANA_SHARE to frana's share folder"});
    std::sort(presets.begin(), presets.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
    return presets;
}

std::vector<std::string> paragraphs_of(const std::vector<std::string>& comments) {
    std::vector<std::string> paragraphs;
    for (const std::string& line : comments) {
        const std::size_t colon = line.find(": ");
        const bool has_label = colon != std::string::npos && line.find(' ') > colon;
        if (paragraphs.empty() || has_label)
            paragraphs.push_back(line);
        else
            paragraphs.back() += " " + line;
    }
    return paragraphs;
}

}  // namespace frana
