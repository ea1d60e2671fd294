// SPDX-License-Identifier: Apache-2.0
// Damaged inputs, results and checkpoints: flipped bits, truncated ends, zeroed ranges, pieces in the wrong place. The
// program refuses them or computes; it does not crash, hang or change them.
#include <gdal_utils.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "trial_ground.h"
#include "trials.h"

namespace frana::test {
namespace {

namespace fs = std::filesystem;

std::string damaged(std::string bytes, RandomNumbers& random, std::string& how) {
    if (bytes.empty()) return "x";
    const std::size_t place = random.below(bytes.size());
    const std::size_t length = 1 + random.below(std::min<std::size_t>(bytes.size() - place, 512));
    const std::string at = " from byte " + std::to_string(place);
    switch (random.below(5)) {
        case 0: {
            const std::size_t count = 1 + random.below(8);
            how = std::to_string(count) + " bits turned over";
            for (std::size_t k = 0; k < count; ++k)
                bytes[random.below(bytes.size())] ^= static_cast<char>(1U << random.below(8));
            break;
        }
        case 1:
            how = "cut off" + at;
            bytes.resize(place);
            break;
        case 2:
            how = std::to_string(length) + " bytes of zero" + at;
            std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>(place), length, '\0');
            break;
        case 3:
            how = std::to_string(length) + " bytes left out" + at;
            bytes.erase(place, length);
            break;
        default:
            how = std::to_string(length) + " bytes twice" + at;
            bytes.insert(place, bytes.substr(place, length));
    }
    return bytes;
}

class Damaged : public TrialGround {
  protected:
    /// Damages one of these files; returns which and how.
    std::string damage_one_of(const std::vector<std::string>& files) {
        const std::string& file = files[random_.below(files.size())];
        std::string how;
        const std::string bytes = damaged(read_text(at(file)), random_, how);
        std::ofstream(at(file), std::ios::binary) << bytes;
        return file + ", " + how;
    }

    void expect_untouched(const FolderState& before, const char* who) const {
        const auto found =
            differences(before, part_of(state(), [](const auto& name) { return name.rfind("in/", 0) == 0; }));
        EXPECT_TRUE(found.empty()) << who << " changes inputs:\n" << in_lines(found);
    }

    [[nodiscard]] std::vector<std::string> files_of(const std::string& beginning) const {
        std::vector<std::string> files;
        for (const auto& [path, content] : state())
            if (path.rfind(beginning, 0) == 0 && !path.ends_with("/") && !is_users(path)) files.push_back(path);
        return files;
    }

    RandomNumbers random_{trial_seed(), 4};
};

void translate_vector(const std::string& from, const std::string& to, const char* format) {
    const char* options[] = {"-f", format, nullptr};
    GDALVectorTranslateOptions* how = GDALVectorTranslateOptionsNew(const_cast<char**>(options), nullptr);
    GDALDatasetH source = GDALOpenEx(from.c_str(), GDAL_OF_VECTOR, nullptr, nullptr, nullptr);
    GDALClose(GDALVectorTranslate(to.c_str(), nullptr, 1, &source, how, nullptr));
    GDALClose(source);
    GDALVectorTranslateOptionsFree(how);
}

void translate_raster(const std::string& from, const std::string& to) {
    GDALDatasetH source = GDALOpen(from.c_str(), GA_ReadOnly);
    GDALClose(GDALTranslate(to.c_str(), source, nullptr, nullptr));
    GDALClose(source);
}

TEST_F(Damaged, InputsAreRefusedOrComputed) {
    GDALAllRegister();
    translate_raster(at("in/dtm.asc"), at("in/dtm.tif"));
    translate_vector(at("in/perimeter.geojson"), at("in/outline.shp"), "ESRI Shapefile");
    translate_vector(at("in/perimeter.geojson"), at("in/outline.gpkg"), "GPKG");
    keep("inputs");
    const std::vector<std::pair<std::string, std::string>> ways{
        {"dtm.asc", "perimeter.geojson"}, {"dtm.tif", "outline.shp"}, {"dtm.tif", "outline.gpkg"}};
    Trials trials;
    for (int k = 0; k < trial_count(4); ++k) {
        trials.begin("damaged inputs");
        restore("inputs");
        const auto& [dtm, outline] = ways[random_.below(ways.size())];
        const std::string stem = outline.substr(0, outline.find('.'));
        std::vector<std::string> files{"in/" + dtm, "in/scene.ini"};
        for (const std::string& file : files_of("in/" + (outline.ends_with("shp") ? stem + "." : outline)))
            files.push_back(file);
        const std::string what = damage_one_of(files);
        SCOPED_TRACE("seed " + std::to_string(trial_seed()) + ", trial " + std::to_string(k) + ": " + what);
        const FolderState before = part_of(state(), [](const auto& name) { return name.rfind("in/", 0) == 0; });
        std::vector<std::string> arguments{
            "check", "in/scene.ini", "--set", "terrain.dtm=" + dtm, "--set", "release.perimeter=" + outline,
            "--set", "time.end=1"};
        const Ending checked = run(Launch{arguments});
        expect_decent_end(checked);
        expect_untouched(before, "check");
        arguments.front() = "run";
        arguments.insert(arguments.end(), {"--out", "out/r", "--memory-limit", "1GB"});
        Launch launch{arguments};
        launch.stop_after_seconds = 20;
        const Ending ended = run(launch);
        expect_decent_end(ended);
        trials.ended(ended.exit_code);
        expect_untouched(before, "run");
        EXPECT_EQ(in_lines(broken_rasters(at("out"))), "");
        const bool for_memory = ended.err.find("--memory-limit") != std::string::npos;
        EXPECT_TRUE(for_memory || (checked.exit_code == 2) == (ended.exit_code == 2))
            << "check says " << checked.exit_code << ": " << checked.err << "run says " << ended.exit_code << ": "
            << ended.err;
    }
}

TEST_F(Damaged, ResultsAndCheckpointsAreRefusedOrDrawnAndChangeNoResult) {
    std::vector<TriedCommand> tried = commands();
    tried.push_back({"render --charts", "older", {"render", "out/r", "--charts", "--size", "640x480"}, {}, false});
    std::erase_if(tried,
                  [](const TriedCommand& command) { return command.begins_in == "inputs" || command.name == "check"; });
    Trials trials;
    for (int k = 0; k < trial_count(4); ++k) {
        trials.begin("damaged results and checkpoints");
        TriedCommand& command = tried[random_.below(tried.size())];
        measure(command);
        ASSERT_FALSE(HasFatalFailure());
        restore(command.begins_in);
        const std::string what = damage_one_of(files_of("out/r"));
        SCOPED_TRACE("seed " + std::to_string(trial_seed()) + ", trial " + std::to_string(k) + ": " + command.name +
                     ", " + what);
        const Ending ended = run(Launch{command.arguments});
        expect_decent_end(ended);
        trials.ended(ended.exit_code);
        const FolderState now = state();
        EXPECT_EQ(in_lines(differences(part_of(command.before, is_users), part_of(now, is_users))), "");
        // Damaged files are replaced as a whole, or not used.
        if (ended.exit_code == 0 && command.whole) {
            std::vector<std::string> wrong = differences(command.after, now);
            EXPECT_EQ(in_lines(wrong), "");
        }
    }
}

}  // namespace
}  // namespace frana::test
