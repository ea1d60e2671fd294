// SPDX-License-Identifier: Apache-2.0
#include "app/store/error_estimate.h"

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "app/text/text_file.h"
#include "params/scene/write_scene.h"

namespace frana::app {
namespace {

// FNV-1a, 64 bits.
std::uint64_t hash(const std::string& text) {
    std::uint64_t h = 0xcbf29ce484222325ULL;
    for (const char c : text) h = (h ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
    return h;
}

// Returns a scene's text without its comments, which state the source of each value.
std::string values_only(const std::string& text) {
    std::istringstream lines(text);
    std::string line, values;
    while (std::getline(lines, line)) {
        if (!line.empty() && line.front() != '#') values += line.substr(0, line.find(" #")) + '\n';
    }
    return values;
}

}  // namespace

std::string numbers_fingerprint(const SceneSpec& scene) {
    SceneSpec numbers = scene;
    numbers.output = OutputSpec{};
    numbers.observed = ObservedSpec{};
    numbers.time.frame_interval = TimeSpec{}.frame_interval;
    char text[32];
    std::snprintf(text, sizeof text, "%016llx",
                  static_cast<unsigned long long>(hash(values_only(scene_text(numbers, {})))));
    return text;
}

std::string convergence_directory(const std::string& result_directory) {
    return result_directory + "-convergence";
}

void write_error_estimate(const std::string& folder, const SceneSpec& scene, const std::string& sentences) {
    write_text_file((std::filesystem::path(folder) / k_error_estimate_file).string(),
                    numbers_fingerprint(scene) + '\n' + sentences);
}

std::optional<std::string> read_error_estimate(const std::string& result_directory, const SceneSpec& scene) {
    std::ifstream file(std::filesystem::path(convergence_directory(result_directory)) / k_error_estimate_file);
    std::string fingerprint;
    if (!std::getline(file, fingerprint) || fingerprint != numbers_fingerprint(scene)) return std::nullopt;
    std::ostringstream rest;
    rest << file.rdbuf();
    return rest.str();
}

}  // namespace frana::app
