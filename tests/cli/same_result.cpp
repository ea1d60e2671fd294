// SPDX-License-Identifier: Apache-2.0
#include "same_result.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <sstream>

#include "app/manifest.h"
#include "program.h"

namespace frana::test {
namespace {

namespace fs = std::filesystem;

// Those lines of a summary say how it was computed, not what.
std::string without_cost(const std::string& summary) {
    std::istringstream lines(summary);
    std::string kept;
    for (std::string line; std::getline(lines, line);) {
        bool wanted = true;
        for (const char* name : {"\"threads\"", "\"total\"", "\"input\"", "\"engine\"", "\"output\"",
                                 "\"render\"", "particle_steps_per_second", "peak_memory_bytes"})
            wanted = wanted && line.find(name) == std::string::npos;
        if (wanted) kept += line + "\n";
    }
    return kept;
}

// A GeoPackage says when it was written: 2026-11-22T14:26:06.028Z.
std::string without_dates(std::string bytes) {
    const std::string form = "dddd-dd-ddTdd:dd:dd.dddZ";
    const auto fits = [&](std::size_t at) {
        for (std::size_t i = 0; i < form.size(); ++i) {
            const auto c = static_cast<unsigned char>(bytes[at + i]);
            if (form[i] == 'd' ? std::isdigit(c) == 0 : c != static_cast<unsigned char>(form[i]))
                return false;
        }
        return true;
    };
    for (std::size_t dash = bytes.find('-', 4); dash != std::string::npos; dash = bytes.find('-', dash + 1))
        if (dash + form.size() - 4 <= bytes.size() && fits(dash - 4))
            bytes.replace(dash - 4, form.size(), form);
    return bytes;
}

bool tells_time(const std::string& name) {
    return name.ends_with(".gpkg") || name == "log.txt" || name == "report.html" || name == "summary.json";
}

std::string marks(const std::string& result) {
    const auto manifest = app::read_manifest(result);
    if (!manifest) return "no manifest";
    std::string text = manifest->scene_hash + " " + std::to_string(manifest->simulated_seconds) + "\n";
    for (const auto& [name, mark] : manifest->files)
        text += name + " " + (tells_time(name) ? "" : mark.checksum) + "\n";
    return text;
}

}  // namespace

std::vector<std::string> files_below(const std::string& folder) {
    std::vector<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (!entry.is_directory()) names.push_back(entry.path().lexically_relative(folder).string());
    std::sort(names.begin(), names.end());
    return names;
}

std::string lasting_bytes(const std::string& result, const std::string& name) {
    if (name == "log.txt" || name == "report.html") return {};
    if (name == "manifest.json") return marks(result);
    const std::string bytes = read_text((fs::path(result) / name).string());
    if (name == "summary.json") return without_cost(bytes);
    return name.ends_with(".gpkg") ? without_dates(bytes) : bytes;
}

std::size_t expect_same_files(const std::string& expected, const std::string& result) {
    const std::vector<std::string> names = files_below(expected);
    EXPECT_EQ(names, files_below(result));
    for (const std::string& name : names) {
        if (fs::exists(fs::path(result) / name)) {
            EXPECT_TRUE(lasting_bytes(expected, name) == lasting_bytes(result, name))
                << result << "/" << name;
        }
    }
    return names.size();
}

}  // namespace frana::test
