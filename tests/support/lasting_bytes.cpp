// SPDX-License-Identifier: Apache-2.0
#include "support/lasting_bytes.h"

#include <cctype>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>
#include <vector>

#include "support/program.h"

namespace frana::test {
namespace {

// Removes values about the computation rather than the result.
void leave_out_cost(Json& summary) {
    for (const char* key :
         {"date", "threads", "wall_seconds", "particle_steps_per_second", "peak_memory_bytes", "members_per_hour"})
        summary.erase(key);
}

// Removes the time of a list of files, and the marks of files that contain times.
void leave_out_times(Json& manifest) {
    manifest.erase("written");
    for (Json& file : manifest["files"]) {
        const std::string name = file["name"];
        if (name.ends_with(".gpkg") || name == "log.txt" || name == "summary.json" || name == "report.html" ||
            name == "convergence.csv" || name == "convergence.png" || name == "members.csv" || name == "records.frana")
            file = {{"name", name}};
    }
}

// Bytes that are no object, the user's own, are unchanged.
template <class LeaveOut>
std::string without(const std::string& bytes, const LeaveOut& leave_out) {
    Json json = Json::parse(bytes, nullptr, false);
    if (!json.is_object()) return bytes;
    leave_out(json);
    return frana::json_text(json);
}

// Removes the columns of seconds.
std::string without_seconds(const std::string& table) {
    std::istringstream lines(table);
    std::string kept;
    std::vector<std::string> names;
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::size_t column = 0;
        for (std::string word; std::getline(words, word, ','); ++column) {
            if (names.size() <= column) names.push_back(word);
            if (!names[column].ends_with("_seconds")) kept += word + ",";
        }
        kept += "\n";
    }
    return kept;
}

// A GeoPackage contains its time of writing: 2026-11-22T14:26:06.028Z.
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
    if (name == "summary.json") return without(bytes, leave_out_cost);
    if (name == "manifest.json") return without(bytes, leave_out_times);
    if (name == "convergence.csv" || name == "members.csv") return without_seconds(bytes);
    if (name == "log.txt" || name == "report.html" || name == "convergence.png")
        return bytes.empty() ? "" : "some text";
    if (name == "records.frana") return std::to_string(bytes.size());  // each member has the time that it took
    return name.ends_with(".gpkg") ? without_dates(bytes) : bytes;
}

std::string lasting_bytes_but_warnings(const std::string& file) {
    const std::string bytes = lasting_bytes(file);
    if (std::filesystem::path(file).filename() != "summary.json") return bytes;
    return without(bytes, [](Json& summary) { summary.erase("warnings"); });
}

}  // namespace frana::test
