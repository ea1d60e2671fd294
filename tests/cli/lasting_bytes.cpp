// SPDX-License-Identifier: Apache-2.0
#include "lasting_bytes.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <functional>
#include <initializer_list>
#include <sstream>
#include <vector>

#include "program.h"

namespace frana::test {
namespace {

bool has_any(const std::string& text, std::initializer_list<const char*> words) {
    return std::any_of(words.begin(), words.end(),
                       [&](const char* word) { return text.find(word) != std::string::npos; });
}

std::string lines_where(const std::string& text, const std::function<bool(const std::string&)>& is_wanted) {
    std::istringstream lines(text);
    std::string kept;
    for (std::string line; std::getline(lines, line);)
        if (is_wanted(line)) kept += line + "\n";
    return kept;
}

// Those lines of a summary say how it was computed, not what.
std::string without_cost(const std::string& summary) {
    return lines_where(summary, [](const std::string& line) {
        return !has_any(line, {"\"threads\"", "\"total\"", "\"input\"", "\"engine\"", "\"output\"", "\"render\"",
                               "particle_steps_per_second", "peak_memory_bytes"});
    });
}

std::string without_warnings(const std::string& summary) {
    bool inside = false;
    return lines_where(summary, [&](const std::string& line) {
        const bool was_inside = inside;
        inside = (inside || line.find("\"warnings\": [") != std::string::npos) && line.find(']') == std::string::npos;
        return !inside && !was_inside && line.find("\"warnings\": [") == std::string::npos;
    });
}

// A list of files without its own time, and without the marks of files that tell theirs.
std::string without_times(const std::string& manifest) {
    int left_out = 0;
    return lines_where(manifest, [&](const std::string& line) {
        if (line.find("\"written\"") != std::string::npos) return false;
        const bool is_name = line.find("\"name\": ") != std::string::npos;
        if (is_name && has_any(line, {".gpkg\"", "\"log.txt\"", "\"summary.json\"", "\"report.html\"",
                                      "\"convergence.csv\"", "\"robustness.csv\""})) {
            left_out = 2;  // bytes and checksum
            return true;
        }
        return left_out-- <= 0;
    });
}

// Without the column of seconds.
std::string without_seconds(const std::string& table) {
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

// A GeoPackage says when it was written: 2026-11-22T14:26:06.028Z.
std::string without_dates(std::string bytes) {
    const std::string form = "dddd-dd-ddTdd:dd:dd.dddZ";
    const auto fits = [&](std::size_t at) {
        for (std::size_t i = 0; i < form.size(); ++i) {
            const auto c = static_cast<unsigned char>(bytes[at + i]);
            if (form[i] == 'd' ? std::isdigit(c) == 0 : c != static_cast<unsigned char>(form[i])) return false;
        }
        return true;
    };
    for (std::size_t dash = bytes.find('-', 4); dash != std::string::npos; dash = bytes.find('-', dash + 1))
        if (dash + form.size() - 4 <= bytes.size() && fits(dash - 4)) bytes.replace(dash - 4, form.size(), form);
    return bytes;
}

}  // namespace

std::string lasting_bytes(const std::string& file) {
    const std::string name = std::filesystem::path(file).filename().string(), bytes = read_text(file);
    if (name == "summary.json") return without_cost(bytes);
    if (name == "manifest.json") return without_times(bytes);
    if (name == "convergence.csv" || name == "robustness.csv") return without_seconds(bytes);
    if (name == "log.txt" || name == "report.html") return bytes.empty() ? "" : "some text";
    return name.ends_with(".gpkg") ? without_dates(bytes) : bytes;
}

std::string lasting_bytes_but_warnings(const std::string& file) {
    const std::string bytes = lasting_bytes(file);
    return std::filesystem::path(file).filename() == "summary.json" ? without_warnings(bytes) : bytes;
}

}  // namespace frana::test
