// SPDX-License-Identifier: Apache-2.0
// A result with a file missing, empty, truncated, of another kind or of another size: everything that can be drawn is
// drawn, otherwise the file is named. FRANA_BROKEN=all tries every damage with every command, for a quarter of an hour.
#include <cstdlib>
#include <map>
#include <optional>

#include "gis/raster/raster_in.h"
#include "gis/raster/raster_out.h"
#include "support/tiny_scene.h"

namespace frana::test {
namespace {

namespace fs = std::filesystem;

using Arguments = std::vector<std::string>;

const std::map<std::string, Arguments> k_commands{
    {"maps", {"render", "broken", "--size", "640x480", "--out", "drawn"}},
    {"view", {"render", "broken", "--view", "3d", "--map", "depth@2", "--size", "640x480", "--out", "drawn"}},
    {"film", {"render", "broken", "--animation", "drawn/film.gif", "--size", "640x480"}},
    {"speeds", {"render", "broken", "--animation", "drawn/film.gif", "--map", "velocity", "--size", "640x480"}},
    {"particles", {"render", "broken", "--animation", "drawn.gif", "--map", "particles", "--size", "640x480"}},
    {"charts", {"render", "broken", "--charts", "--size", "640x480", "--out", "drawn"}},
    {"compare", {"compare", "broken", "--scar", "scar.geojson", "--out", "drawn", "--size", "640x480"}}};

enum class Damage { missing, empty, half, garbage, other };

/// A file of a result, and the exit codes of the commands that read it, by damage: 2 is a refusal that names the file.
struct ReadFile {
    std::string file;
    Arguments readers;
    std::map<Damage, int> codes;
};

// Without a missing file everything else is drawn; a damaged file is always refused.
const std::map<Damage, int> k_needed{{Damage::missing, 2}, {Damage::empty, 2}, {Damage::half, 2}, {Damage::other, 2}};
const std::map<Damage, int> k_exchanged{{Damage::other, 2}};
const std::map<Damage, int> k_optional{{Damage::missing, 0}, {Damage::other, 2}};
const std::map<Damage, int> k_optional_table{{Damage::missing, 0}, {Damage::half, 2}};

const std::vector<ReadFile> k_cases{
    {"frames/frames.csv", {"film", "view", "particles"}, k_needed},
    {"frames/depth_0000.tif", {"film"}, k_needed},
    {"frames/depth_0004.tif", {"film"}, k_exchanged},
    {"frames/velocity_0001.tif", {"speeds"}, k_exchanged},
    {"frames/particles_0001.gpkg", {"particles"}, {{Damage::missing, 2}, {Damage::garbage, 2}}},
    {"max_depth.tif", {"film", "compare"}, {{Damage::empty, 2}, {Damage::other, 2}}},
    {"max_velocity.tif", {"maps"}, k_exchanged},
    {"release.tif", {"maps"}, k_exchanged},
    {"bed.tif", {"maps"}, {{Damage::missing, 0}, {Damage::other, 0}}},  // they contain nothing of it
    {"dtm.tif", {"maps"}, k_optional},
    {"dtm.tif", {"view"}, {{Damage::missing, 2}}},
    {"comparison.tif", {"maps"}, k_exchanged},
    {"comparison.json", {"maps"}, {{Damage::half, 2}}},
    {"timeseries.csv", {"maps", "charts"}, {{Damage::missing, 0}, {Damage::empty, 2}, {Damage::other, 2}}},
    {"profiles.csv", {"charts"}, k_optional_table},
    {"comparison_curve.csv", {"charts"}, {{Damage::garbage, 2}}},
    {"extent.gpkg", {"maps"}, {{Damage::missing, 0}, {Damage::half, 2}}},
    {"profiles.gpkg", {"maps"}, {{Damage::garbage, 2}}},
    {"scene.ini", {"maps"}, {{Damage::missing, 0}}},
    {"summary.json", {"maps"}, {{Damage::missing, 0}, {Damage::half, 2}}},
};

class BrokenResult : public TinyScene {
  protected:
    void SetUp() override {
        write_polygon("scar", {{15, 50}, {180, 50}, {180, 100}, {15, 100}});
        write_scene(
            "frame-interval = 1\n[output]\nmaps = off\nanimation = off\ncharts = off\nreport = off\nformats = geotiff, "
            "particles-gpkg\n"
            "[scar]\nperimeter = scar.geojson\n");
        ran();
    }

    void damage(const std::string& file, Damage how) const {
        const std::string whole = read_text(path("broken/" + file));
        ASSERT_FALSE(whole.empty()) << file;
        switch (how) {
            case Damage::missing:
                fs::remove(path("broken/" + file));
                break;
            case Damage::empty:
                write("broken/" + file, "");
                break;
            case Damage::half:
                write("broken/" + file, whole.substr(0, whole.size() / 2));
                break;
            case Damage::garbage:
                write("broken/" + file, "\x89\xFF\x01,;\n<no> [such] {file\n");
                break;
            case Damage::other:
                file.ends_with(".tif") ? write_smaller("broken/" + file)
                                       : write("broken/" + file, whole.substr(0, whole.find('\n') + 1));
                break;
        }
    }

    /// The same raster, of its north-western cells.
    void write_smaller(const std::string& file) const {
        const Raster whole = gis::read_result_raster(path(file));
        GridSpec grid = whole.grid;
        grid.columns = 20;
        grid.rows = 20;
        Raster part(grid);
        for (std::int64_t row = 0; row < grid.rows; ++row)
            for (std::int64_t column = 0; column < grid.columns; ++column)
                part.values[part.index(row, column)] = whole.at(row, column);
        gis::write_geotiff(path(file), part, {"part", "Of another size", "m", {}});
    }

    void attempt(const std::string& file, Damage how, const std::string& command, std::optional<int> expected) const {
        SCOPED_TRACE(file + ", damage " + std::to_string(static_cast<int>(how)) + ": " + command);
        for (const char* folder : {"broken", "drawn"}) fs::remove_all(path(folder));
        fs::copy(path("result"), path("broken"), fs::copy_options::recursive);
        fs::create_directory(path("drawn"));
        damage(file, how);
        const Outcome outcome = frana(k_commands.at(command));
        if (expected)
            EXPECT_EQ(outcome.exit_code, *expected) << outcome.err;
        else
            EXPECT_TRUE(outcome.exit_code == 0 || outcome.exit_code == 2) << outcome.exit_code << "\n" << outcome.err;
        if (outcome.exit_code != 0) {
            EXPECT_NE(outcome.err.find(fs::path(file).filename().string()), std::string::npos) << outcome.err;
        }
    }
};

TEST_F(BrokenResult, FilesAreNamedAndNothingCrashes) {
    for (const ReadFile& one : k_cases)
        for (const std::string& command : one.readers)
            for (const auto& [how, code] : one.codes) {
                // One reader tests all damages of a file; for the others the empty file is enough.
                if (command != one.readers.front() && how != Damage::empty) continue;
                attempt(one.file, how, command, code);
            }
    if (std::getenv("FRANA_BROKEN") == nullptr) return;  // minutes
    for (const auto& entry : fs::recursive_directory_iterator(path("result"))) {
        const std::string file = entry.path().lexically_relative(path("result")).string();
        if (!entry.is_regular_file() || file.ends_with(".qml") || file.ends_with(".sld")) continue;
        for (const auto& [command, arguments] : k_commands)
            for (const Damage how : {Damage::missing, Damage::empty, Damage::half, Damage::garbage, Damage::other})
                attempt(file, how, command, {});
    }
}

}  // namespace
}  // namespace frana::test
