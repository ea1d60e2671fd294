// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <map>
#include <optional>
#include <set>

#include "source_tree.h"

namespace frana::test {
namespace {

// The folders within a library, each above those before it. Between libraries the compiler refuses what CMake does not
// link (frana_headers).
const std::map<std::string, std::vector<std::string>> k_layers{
    {"params", {"grammar", "keys", "check", "scene"}},
    {"bench", {"exact", "set_up", "accuracy", "stability", "speed", "program"}},
    {"gis", {"access", "crs", "vector", "raster"}},
    {"render", {"vtk", "libav", "canvas", "chart", "map", "view", "animation"}},
    {"app/study",
     {"study_spec.h", "member_record.h", "member_record.cpp", "record_files.h", "record_files.cpp", "openturns",
      "ranks", "plan", "statistics", "pool", "publish"}},
};

/// "src/mpm/shape.h" -> "mpm", "gis/crs/crs.h" -> "gis".
std::string library_of(const std::string& path) {
    const std::string rest = path.rfind("src/", 0) == 0 ? path.substr(4) : path;
    return rest.substr(0, rest.find('/'));
}

/// Returns the position of a file's folder in a library or room of k_layers, from below; none for a file outside it.
std::optional<std::size_t> level_in(const std::string& room, const std::string& path) {
    const std::string rest = (path.rfind("src/", 0) == 0 ? path.substr(4) : path);
    if (!rest.starts_with(room + "/")) return std::nullopt;
    const std::string inside = rest.substr(room.size() + 1), folder = inside.substr(0, inside.find('/'));
    const std::vector<std::string>& folders = k_layers.at(room);
    const auto found = std::find(folders.begin(), folders.end(), folder);
    EXPECT_NE(found, folders.end()) << path << " is in a folder that " << room << " does not list";
    return static_cast<std::size_t>(found - folders.begin());
}

/// Returns the text between the quotes or brackets of an #include line; empty for other lines.
std::string included(const std::string& line) {
    if (line.rfind("#include", 0) != 0) return {};
    const auto begin = line.find_first_of("<\"");
    const auto end = line.find_last_of(">\"");
    return begin == std::string::npos || end <= begin ? std::string() : line.substr(begin + 1, end - begin - 1);
}

bool starts_with_any(const std::string& text, const std::vector<std::string>& beginnings) {
    return std::any_of(beginnings.begin(), beginnings.end(),
                       [&](const std::string& beginning) { return text.rfind(beginning, 0) == 0; });
}

TEST(IncludeDirections, NoIncludeOfAHigherFolder) {
    const auto files = source_files({"src", "gis", "render"}, {".h", ".cpp"});
    ASSERT_GT(files.size(), 50U) << "the source tree was not found at " FRANA_SOURCE_DIR;
    for (const std::string& file : files) {
        for (const std::string& line : lines_of(file)) {
            const std::string target = included(line);
            EXPECT_EQ(target.find(".."), std::string::npos) << file << ": " << line;
            for (const auto& [room, folders] : k_layers) {
                const auto level = level_in(room, file);
                if (level) {
                    EXPECT_LE(level_in(room, target), level) << file << ": " << line;
                }
            }
        }
    }
}

TEST(IncludeDirections, LibrariesIncludeOnlyTheirFolders) {
    const std::vector<std::string> files_and_coordinates{"gdal", "ogr", "cpl_", "proj"};
    // In modules, which the program loads when it needs them.
    const std::vector<std::string> graphics{"vtk", "GL/"}, films{"libav", "libsw"}, uncertainty{"openturns/"},
        messages{"mpi.h"};
    for (const std::string& file : source_files({"src", "gis", "render"}, {".h", ".cpp"})) {
        const std::string library = library_of(file);
        for (const std::string& line : lines_of(file)) {
            const std::string target = included(line);
            if (target.empty()) continue;
            EXPECT_TRUE(library == "gis" || !starts_with_any(target, files_and_coordinates)) << file << ": " << line;
            EXPECT_TRUE(file.starts_with("render/vtk/") || !starts_with_any(target, graphics)) << file << ": " << line;
            EXPECT_TRUE(file.starts_with("render/libav/") || !starts_with_any(target, films)) << file << ": " << line;
            EXPECT_TRUE(file.starts_with("src/app/study/openturns/") || !starts_with_any(target, uncertainty))
                << file << ": " << line;
            EXPECT_TRUE(file.starts_with("src/app/study/ranks/mpi/") || !starts_with_any(target, messages))
                << file << ": " << line;
        }
    }
}

TEST(IncludeDirections, OnlyTheProgramWritesToTheTerminal) {
    for (const std::string& file : source_files({"src", "gis", "render"}, {".h", ".cpp"})) {
        if (library_of(file) == "app" || file.starts_with("src/bench/program/")) continue;
        for (const std::string& line : lines_of(file))
            for (const std::string word : {"std::cout", "std::cerr", "std::exit(", "std::abort("})
                EXPECT_EQ(line.find(word), std::string::npos) << file << ": " << line;
    }
}

// An edited law is compiled where it is chosen, where its values are read and in sweeps that are compiled for it:
// scenes and states keep parameters or a function made of the law. Exempt is what all laws share.
TEST(IncludeDirections, ALawIsCompiledInFewSources) {
    constexpr std::size_t k_most_sources = 10;
    const std::set<std::string> shared{"bed_state", "friction_sum", "law", "law_values", "parameters", "strain_rate"};
    std::map<std::string, std::vector<std::string>> includes;
    for (const std::string& file : source_files({"src"}, {".h", ".cpp"}))
        for (const std::string& line : lines_of(file))
            if (const std::string target = included(line); !target.empty()) includes[file].push_back("src/" + target);
    std::map<std::string, std::vector<std::string>> sources;  // by header that they include, directly or not
    for (const std::string& source : source_files({"src"}, {".cpp"})) {
        std::set<std::string> reached{source};
        for (std::vector<std::string> open{source}; !open.empty();) {
            const std::string file = open.back();
            open.pop_back();
            for (const std::string& header : includes[file])
                if (reached.insert(header).second) open.push_back(header);
        }
        for (const std::string& header : reached) sources[header].push_back(source);
    }
    for (const std::string& header : source_files({"src/physics"}, {".h"})) {
        if (shared.count(std::filesystem::path(header).stem().string()) > 0) continue;
        EXPECT_FALSE(sources[header].empty()) << header;
        EXPECT_LE(sources[header].size(), k_most_sources) << header << ": " << testing::PrintToString(sources[header]);
    }
}

}  // namespace
}  // namespace frana::test
