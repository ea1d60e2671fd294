// SPDX-License-Identifier: Apache-2.0
#include "folder_state.h"

#include <cpl_error.h>
#include <gdal.h>

#include <filesystem>

#include "support/lasting_bytes.h"

namespace frana::test {
namespace {

namespace fs = std::filesystem;

bool can_be_read(const std::string& path) {
    CPLErrorReset();
    CPLPushErrorHandler(CPLQuietErrorHandler);
    GDALDatasetH dataset = GDALOpen(path.c_str(), GA_ReadOnly);
    bool good = dataset != nullptr;
    if (good) {
        const int columns = GDALGetRasterXSize(dataset), rows = GDALGetRasterYSize(dataset);
        std::vector<float> row(static_cast<std::size_t>(columns));
        for (int k = 0; k < rows && good; ++k)
            good = GDALRasterIO(GDALGetRasterBand(dataset, 1), GF_Read, 0, k, columns, 1, row.data(), columns, 1,
                                GDT_Float32, 0, 0) == CE_None;
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
            state[name] = lasting_bytes_but_warnings(entry.path().string());
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
