// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "source_tree.h"

namespace frana::test {
namespace {

// What each room may include besides itself: the floors below it, as the house is drawn. src/app may include
// all.
const std::map<std::string, std::set<std::string>> k_may_include{
    {"core", {}},
    {"params", {"core"}},
    {"analysis", {"core"}},
    {"particles", {"core"}},
    {"physics", {"core", "particles"}},
    {"mpm", {"core", "particles", "physics"}},
    {"fluid", {"core", "particles", "physics"}},
    {"models", {"core", "particles", "physics", "mpm", "fluid"}},
    {"simulation", {"core", "params", "particles", "physics", "mpm", "fluid", "models", "analysis"}},
    {"bench", {"core", "params", "particles", "physics", "mpm", "fluid", "models", "simulation", "analysis"}},
    {"gis", {"core"}},
    {"render", {"core"}},
    {"app",
     {"core", "params", "analysis", "particles", "physics", "mpm", "fluid", "models", "simulation", "bench",
      "gis", "render"}},
};

/// "src/mpm/shape.h" -> "mpm", "gis/crs/crs.h" -> "gis".
std::string room_of(const std::string& path) {
    const std::string rest = path.rfind("src/", 0) == 0 ? path.substr(4) : path;
    return rest.substr(0, rest.find('/'));
}

/// What stands between the quotes or brackets of an #include line; empty for other lines.
std::string included(const std::string& line) {
    if (line.rfind("#include", 0) != 0) return {};
    const auto begin = line.find_first_of("<\"");
    const auto end = line.find_last_of(">\"");
    return begin == std::string::npos || end <= begin ? std::string()
                                                      : line.substr(begin + 1, end - begin - 1);
}

bool starts_with_any(const std::string& text, const std::vector<std::string>& beginnings) {
    return std::any_of(beginnings.begin(), beginnings.end(),
                       [&](const std::string& beginning) { return text.rfind(beginning, 0) == 0; });
}

TEST(IncludeDirections, NoArrowRunsUpTheHouse) {
    const auto files = source_files({"src", "gis", "render"}, {".h", ".cpp"});
    ASSERT_GT(files.size(), 50U) << "the source tree was not found at " FRANA_SOURCE_DIR;
    for (const std::string& file : files) {
        const std::string room = room_of(file);
        ASSERT_EQ(k_may_include.count(room), 1U) << file << " lies in a room that the house does not have";
        for (const std::string& line : lines_of(file)) {
            const std::string target = included(line);
            const std::string other = target.substr(0, target.find('/'));
            if (target.find('/') == std::string::npos || other == room || k_may_include.count(other) == 0)
                continue;
            EXPECT_EQ(k_may_include.at(room).count(other), 1U) << file << ": " << line;
        }
    }
}

TEST(IncludeDirections, LibrariesStayInTheirRooms) {
    const std::vector<std::string> files_and_coordinates{"gdal", "ogr", "cpl_", "proj"};
    const std::vector<std::string> graphics{"vtk", "GL/", "libav", "libsw"};
    for (const std::string& file : source_files({"src", "gis", "render"}, {".h", ".cpp"})) {
        const std::string room = room_of(file);
        for (const std::string& line : lines_of(file)) {
            const std::string target = included(line);
            if (target.empty()) continue;
            EXPECT_TRUE(room == "gis" || !starts_with_any(target, files_and_coordinates)) << file << ": " << line;
            EXPECT_TRUE(room == "render" || !starts_with_any(target, graphics)) << file << ": " << line;
        }
    }
}

TEST(IncludeDirections, OnlyTheProgramTalksToTheTerminal) {
    for (const std::string& file : source_files({"src", "gis", "render"}, {".h", ".cpp"})) {
        if (room_of(file) == "app") continue;
        for (const std::string& line : lines_of(file))
            for (const std::string word : {"std::cout", "std::cerr", "std::exit(", "std::abort("})
                EXPECT_EQ(line.find(word), std::string::npos) << file << ": " << line;
    }
}

}  // namespace
}  // namespace frana::test
