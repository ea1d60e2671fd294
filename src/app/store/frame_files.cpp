// SPDX-License-Identifier: Apache-2.0
#include "app/store/frame_files.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "app/store/result_files.h"
#include "core/error.h"

namespace frana::app {
namespace {

namespace fs = std::filesystem;

std::string frame_name(const FrameFile& file, std::size_t index) {
    char number[16];
    std::snprintf(number, sizeof number, "_%04zu", index);
    return file.what + number + file.ending;
}

// For frames of checkpoints without records.
std::string problem_without_records(const std::string& folder, std::size_t count) {
    std::vector<FrameFile> wanted{k_depth_file, k_velocity_file};
    for (const std::string& name : names_of_frames(folder, 1)) {
        const auto place = name.rfind('_');
        wanted.push_back({name.substr(0, place), fs::path(name).extension().string()});
    }
    for (std::size_t i = 0; i < count; ++i)
        for (const FrameFile& file : wanted)
            if (!fs::exists(frame_path(folder, file, i))) return "is missing: " + frame_path(folder, file, i);
    return {};
}

}  // namespace

ParticleFormats particle_formats(const std::vector<std::string>& formats) {
    const auto has = [&](const char* word) { return std::find(formats.begin(), formats.end(), word) != formats.end(); };
    return {has("particles-gpkg"), has("particles-vtp")};
}

std::string frames_of_run(const std::string& result) {
    const fs::path whole = fs::path(result) / k_whole_frames;
    return fs::is_directory(whole) ? whole.string() : (fs::path(result) / k_frame_folder).string();
}

std::vector<FrameFile> frame_files(const Frame& frame, ParticleFormats formats) {
    std::vector<FrameFile> files{k_depth_file, k_velocity_file};
    for (const NamedRaster& raster : frame.more) files.push_back({raster.name, ".tif"});
    if (formats.gpkg) files.push_back(k_particle_table);
    if (formats.vtp) files.push_back(k_particle_cloud);
    return files;
}

std::string frame_path(const std::string& folder, const FrameFile& file, std::size_t index) {
    return (fs::path(folder) / frame_name(file, index)).string();
}

std::optional<std::size_t> frame_index(const std::string& name) {
    constexpr std::size_t k_most_digits = 15;
    const auto place = name.rfind('_');
    if (place == std::string::npos) return std::nullopt;
    const std::string ending = fs::path(name).extension().string();
    const auto is_its = [&](const FrameFile& file) { return file.ending == ending; };
    const std::array<FrameFile, 3> endings{k_depth_file, k_particle_table, k_particle_cloud};
    if (std::none_of(endings.begin(), endings.end(), is_its) || name.size() < place + 1 + ending.size())
        return std::nullopt;
    const std::string digits = name.substr(place + 1, name.size() - place - 1 - ending.size());
    if (digits.empty() || digits.size() > k_most_digits || digits.find_first_not_of("0123456789") != std::string::npos)
        return std::nullopt;
    return static_cast<std::size_t>(std::stoull(digits));
}

FrameRecord record_of(const std::string& path) {
    FrameRecord record{fs::path(path).filename().string(), 0, 0};
    std::ifstream file(path, std::ios::binary);
    std::vector<char> buffer(1 << 16);
    uLong sum = 0;
    while (file.read(buffer.data(), static_cast<std::streamsize>(buffer.size())) || file.gcount() > 0) {
        const auto part = static_cast<std::size_t>(file.gcount());
        sum = crc32_z(sum, reinterpret_cast<const Bytef*>(buffer.data()), part);
        record.bytes += part;
    }
    if (!file.eof()) throw Error(ErrorKind::environment, Problem{"cannot be read", path, "", "", ""});
    record.sum = static_cast<std::uint32_t>(sum);
    return record;
}

std::vector<std::string> names_of_frames(const std::string& folder, std::size_t count) {
    std::vector<std::string> names;
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
        std::string name = entry.path().filename().string();
        const auto index = frame_index(name);
        if (index && *index < count) names.push_back(std::move(name));
    }
    std::sort(names.begin(), names.end());
    return names;
}

std::string frame_problem(const std::string& folder, std::size_t count, const std::vector<FrameRecord>& records) {
    if (records.empty()) return problem_without_records(folder, count);
    for (const FrameRecord& record : records) {
        const std::string path = (fs::path(folder) / record.name).string();
        std::error_code error;
        const std::uint64_t bytes = fs::file_size(path, error);
        if (error) return "is missing: " + path;
        if (bytes != record.bytes || record_of(path).sum != record.sum) return "is not as it was written: " + path;
    }
    return {};
}

}  // namespace frana::app
