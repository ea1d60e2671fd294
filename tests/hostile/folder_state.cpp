// SPDX-License-Identifier: Apache-2.0
#include "folder_state.h"

#include <cpl_error.h>
#include <gdal.h>

#include <filesystem>
#include <sstream>

#include "../cli/program.h"

namespace frana::test {
namespace {

namespace fs = std::filesystem;

// Without the lines that tell how long it took, on how many threads, what memory held, and what was warned
// of.
std::string figures_of(const std::string& summary) {
    std::istringstream lines(summary);
    std::string kept;
    for (std::string line; std::getline(lines, line);) {
        if (line.find("\"warnings\": [") != std::string::npos) {
            while (line.find(']') == std::string::npos && std::getline(lines, line)) {
            }
            continue;
        }
        bool wanted = true;
        for (const char* name : {"\"threads\"", "\"total\"", "\"input\"", "\"engine\"", "\"output\"",
                                 "\"render\"", "particle_steps_per_second", "peak_memory_bytes"})
            wanted = wanted && line.find(name) == std::string::npos;
        if (wanted) kept += line + "\n";
    }
    return kept;
}

// Without the column of seconds.
std::string levels_of(const std::string& table) {
    std::istringstream lines(table);
    std::string kept;
    std::vector<std::string> names;
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::size_t column = 0;
        for (std::string word; std::getline(words, word, ','); ++column) {
            if (names.size() <= column) names.push_back(word);
            if (names[column] != "wall_seconds") kept += word + ",";
        }
        kept += "\n";
    }
    return kept;
}

// Without the time of day and what tells one log, summary, report or study from another.
std::string list_of(const std::string& manifest) {
    std::istringstream lines(manifest);
    std::string kept;
    int left_out = 0;
    for (std::string line; std::getline(lines, line); --left_out) {
        for (const char* name : {"\"log.txt\"", "\"summary.json\"", "\"report.html\"", "\"convergence.csv\""})
            if (line.find("\"name\": " + std::string(name)) != std::string::npos) left_out = 3;
        if (left_out <= 0 && line.find("\"written\"") == std::string::npos) kept += line + "\n";
    }
    return kept;
}

std::string comparable(const fs::path& file) {
    const std::string name = file.filename().string();
    const std::string text = read_text(file.string());
    if (name == "summary.json") return figures_of(text);
    if (name == "manifest.json") return list_of(text);
    if (name == "convergence.csv") return levels_of(text);
    if (name == "log.txt" || name == "report.html") return text.empty() ? "" : "some text";
    return text;
}

bool can_be_read(const std::string& path) {
    CPLErrorReset();
    CPLPushErrorHandler(CPLQuietErrorHandler);
    GDALDatasetH dataset = GDALOpen(path.c_str(), GA_ReadOnly);
    bool good = dataset != nullptr;
    if (good) {
        const int columns = GDALGetRasterXSize(dataset), rows = GDALGetRasterYSize(dataset);
        std::vector<float> row(static_cast<std::size_t>(columns));
        for (int k = 0; k < rows && good; ++k)
            good = GDALRasterIO(GDALGetRasterBand(dataset, 1), GF_Read, 0, k, columns, 1, row.data(), columns,
                                1, GDT_Float32, 0, 0) == CE_None;
        GDALClose(dataset);
    }
    CPLPopErrorHandler();
    return good;
}

}  // namespace

FolderState state_of(const std::string& folder) {
    FolderState state;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        const std::string name = entry.path().lexically_relative(folder).string();
        if (entry.is_symlink()) {
            state[name] = "link to " + fs::read_symlink(entry.path()).string();
        } else if (entry.is_directory()) {
            state[name + "/"] = "";
        } else if (entry.is_regular_file()) {
            state[name] = comparable(entry.path());
        } else {
            state[name] = "no regular file";
        }
    }
    return state;
}

std::vector<std::string> differences(const FolderState& expected, const FolderState& found) {
    std::vector<std::string> list;
    for (const auto& [path, content] : expected) {
        const auto place = found.find(path);
        if (place == found.end()) {
            list.push_back("missing: " + path);
        } else if (place->second != content) {
            list.push_back("changed: " + path + " (" + std::to_string(content.size()) + " bytes, now " +
                           std::to_string(place->second.size()) + ")");
        }
    }
    for (const auto& [path, content] : found)
        if (!expected.contains(path)) list.push_back("new: " + path);
    return list;
}

std::string in_lines(const std::vector<std::string>& texts) {
    std::string all;
    for (const std::string& text : texts) all += "    " + text + "\n";
    return all;
}

std::vector<std::string> broken_rasters(const std::string& folder) {
    GDALAllRegister();
    std::vector<std::string> broken;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.path().extension() == ".tif" && !can_be_read(entry.path().string()))
            broken.push_back(entry.path().string());
    return broken;
}

}  // namespace frana::test
