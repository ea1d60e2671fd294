// SPDX-License-Identifier: Apache-2.0
// A result replaces an older one: nothing of the older one is mistaken for the new, and no file of the user is lost.
#include <algorithm>
#include <csignal>
#include <map>

#include "app/store/manifest.h"
#include "app/store/result_files.h"
#include "app/store/unfinished_results.h"
#include "params/keys/result_rasters.h"
#include "result_scenes.h"
#include "resuming.h"
#include "same_result.h"
#include "support/lasting_bytes.h"

namespace frana::test {
namespace {

namespace fs = std::filesystem;

class Overwrite : public ResultScenes {
  protected:
    /// Makes results of all commands that run many scenes: "range", "union", "region", "fitted", "fitted_to_two".
    void make_studies() const;
};

TEST_F(Overwrite, LeavesTheFilesOfAFreshRun) {
    const std::map<std::string, std::string> scenes{
        {"all_of_the_first_model", k_voellmy + k_entrainment + k_every_output + "[output]\nanimation = off\n"},
        {"all_of_the_second_model", k_structured + k_every_output + "[output]\nanimation = off\n"},
        {"least", k_voellmy + "[output]\nmaps = off\nanimation = off\nframes = off\nreport = off\n"},
        {"film", k_voellmy + "[output]\nmaps = off\nframes = off\nmap-size = 800x600\n"},
        {"scar", k_voellmy + k_numbers_only + "[scar]\nperimeter = scar.geojson\n"},
        {"other_frames", k_voellmy + "[output]\nmaps = off\nanimation = off\nformats = geotiff, zarr\n"}};
    for (const auto& [name, text] : scenes) run(text, name);
    for (const auto& [older, older_text] : scenes) {
        if (!older.starts_with("all") && older != "film") continue;
        for (const auto& [name, text] : scenes) {
            if (name == older || name == "film") continue;
            if (older != "all_of_the_first_model" && name != "least" && !name.starts_with("all")) continue;
            if (older == "film" && name != "least") continue;
            SCOPED_TRACE(older + " replaced by " + name);
            fs::remove_all(path("old"));
            copy(older, "old");
            if (name == "least" && older == "all_of_the_first_model") render_all();
            run(text, "old", {"--overwrite"});
            EXPECT_GT(expect_same_files(path(name), path("old")), 20U);
        }
    }
}

void Overwrite::make_studies() const {
    const std::string two_keys =
        "[vary]\nmaterial.friction-angle = uniform(12, 20)\nmaterial.turbulence = uniform(200, 400)\n";
    write_scene(k_numbers_only + "pressure-thresholds = 5\n[hazard]\nscheme = swiss-debris-flow\n");
    write("study.ini", "[study]\nscene = scene.ini\nsamples = 8\nsampling = random\nkeep = all\n" + two_keys);
    write("union.ini", "[study]\nscene = scene.ini\nper-polygon = on\n");
    write("region.ini",
          "[region]\nscene = scene.ini\nscenario = depth\nreturn-period = depth\nwindow = 120\n[set]\n"
          "output.exposure = perimeter.geojson\n");
    write("surveyed.ini", read_text(path("scene.ini")) + "[scar]\nperimeter = scar.geojson\n");
    write("again.ini", read_text(path("surveyed.ini")));
    const std::string few = "\nsamples = 6\nrefine = 6\n[objective]\njaccard = 1\n" + two_keys;
    write("fitted.ini", "[study]\nscene = surveyed.ini" + few);
    write("fitted_to_two.ini",
          "[study]\nscene = surveyed.ini, again.ini" + few + "[vary again]\nrelease.volume = uniform(3000, 5000)\n");
    for (const std::vector<std::string>& command :
         {std::vector<std::string>{"ensemble", "study.ini", "--out", "range", "--quiet"},
          {"compare", "range", "--scar", "scar.geojson"},
          {"ensemble", "union.ini", "--out", "union", "--quiet"},
          {"batch", "region.ini", "--out", "region", "--quiet"},
          {"calibrate", "fitted.ini", "--out", "fitted", "--quiet"},
          {"calibrate", "fitted_to_two.ini", "--out", "fitted_to_two", "--quiet"}}) {
        const Outcome outcome = frana(command);
        ASSERT_EQ(outcome.exit_code, 0) << command[1] << ": " << outcome.err;
    }
}

// The table is complete, and every row of it exists.
TEST_F(Overwrite, EveryFileOfAResultIsInItsManifestAndInTheTable) {
    run(k_voellmy + k_entrainment + k_every_output, "old");
    render_all();
    run(k_structured + k_every_output, "other");
    make_studies();
    std::map<std::string, int> rows;
    for (const std::string result : {"old", "other", "range", "union", "region", "fitted", "fitted_to_two"}) {
        const auto manifest = app::read_manifest(path(result));
        ASSERT_TRUE(manifest);
        for (const std::string& name : files_below(path(result))) {
            const app::ResultFile* row = app::existing_file(name);
            const bool has_a_place_of_its_own = name == "film.gif" || name.starts_with("pictures/") ||
                                                name.starts_with("more/") || name.starts_with("compared/");
            EXPECT_EQ(row == nullptr, has_a_place_of_its_own) << name;
            if (row != nullptr) ++rows[row->pattern];
            if (name == "manifest.json") continue;
            ASSERT_EQ(manifest->files.count(name), 1U) << name;
            EXPECT_TRUE(manifest->files.at(name) == app::mark_of(path(result + "/" + name))) << name;
        }
        EXPECT_EQ(manifest->files.size() + 1, files_below(path(result)).size());
    }
    // Requested by none of the scenes: notes of an unfinished run, other formats of the same.
    const auto needs_luck = [](const app::ResultFile& row) {
        const ResultRaster* const raster = find_result_raster(row.pattern.substr(0, row.pattern.find('.')));
        return raster != nullptr && raster->if_it_happens;
    };
    for (const app::ResultFile& row : app::result_files()) {
        if (needs_luck(row) || row.kind == app::FileKind::working || row.pattern == "animation.gif" ||
            row.pattern.ends_with(".tif") || rows.count(row.pattern) > 0)
            continue;
        ADD_FAILURE() << row.pattern << " is in the table, and no run writes it";
    }
}

TEST_F(Overwrite, KeepsTheUsersFilesInEveryFolder) {
    run(k_voellmy + k_entrainment + "[output]\nmap-size = 800x600\nmaps = max_depth\nanimation = off\n", "old");
    const std::map<std::string, std::string> same_name{{"notes.txt", "a"},
                                                       {"maps/mine.png", "b"},
                                                       {"charts/mine.csv", "c"},
                                                       {"frames/mine.tif", "d"},
                                                       {"frames/depth_9999_mine.txt", "d2"},
                                                       {"gis/deep/er.qgz", "e"},
                                                       {"manifest.json.bak", "f"}};
    // Changed files, and those that a GIS creates beside a raster: they would be read with the new raster.
    const std::map<std::string, std::string> other_name{{"max_depth.qml", "max_depth.kept-1.qml"},
                                                        {"eroded_depth.tif", "eroded_depth.kept-1.tif"},
                                                        {"maps/max_depth.png", "maps/max_depth.kept-1.png"},
                                                        {"max_depth.tif.aux.xml", "max_depth.tif.aux.kept-1.xml"},
                                                        {"extent.gpkg-wal", "extent.kept-1.gpkg-wal"},
                                                        {"hazard.tif", "hazard.kept-1.tif"},
                                                        {"frames/depth_0001.tif", "frames/depth_0001.kept-1.tif"}};
    for (const auto& [name, text] : same_name) {
        fs::create_directories(fs::path(path("old/" + name)).parent_path());
        write("old/" + name, text);
    }
    for (const auto& [name, later] : other_name) write("old/" + name, "mine: " + name);
    fs::create_symlink("/nowhere", path("old/link"));
    fs::create_directory(path("old/empty"));
    write("old/max_depth.kept-1.sld", "of an earlier time");

    run(k_voellmy + k_numbers_only, "fresh");
    run(k_voellmy + k_numbers_only, "old", {"--overwrite"});
    for (const auto& [name, text] : same_name) EXPECT_EQ(read_text(path("old/" + name)), text) << name;
    for (const auto& [name, later] : other_name) EXPECT_EQ(read_text(path("old/" + later)), "mine: " + name) << name;
    EXPECT_EQ(fs::read_symlink(path("old/link")), "/nowhere");
    EXPECT_TRUE(fs::is_directory(path("old/empty")));
    EXPECT_EQ(read_text(path("old/max_depth.kept-1.sld")), "of an earlier time");
    const std::string log = read_text(path("old/log.txt"));
    EXPECT_NE(log.find("max_depth.qml, which was changed since frana wrote it, is kept as max_depth.kept-1.qml"),
              std::string::npos)
        << log;
    const auto manifest = app::read_manifest(path("old"));
    ASSERT_TRUE(manifest);
    EXPECT_TRUE(manifest->files.at("log.txt") == app::mark_of(path("old/log.txt")));
    // The rest is what a fresh run writes.
    for (const std::string& name : files_below(path("fresh")))
        EXPECT_TRUE(lasting_bytes(path("fresh/" + name)) == lasting_bytes(path("old/" + name))) << name;
    EXPECT_EQ(files_below(path("old")).size(),
              files_below(path("fresh")).size() + same_name.size() + other_name.size() + 2);
    // The second time the numbers continue.
    write("old/max_depth.qml", "again");
    run(k_voellmy + k_numbers_only, "old", {"--overwrite"});
    EXPECT_EQ(read_text(path("old/max_depth.kept-2.qml")), "again");
    EXPECT_EQ(read_text(path("old/max_depth.kept-1.qml")), "mine: max_depth.qml");
    for (const std::string& name : files()) EXPECT_EQ(name.find(".partial"), std::string::npos) << name;
}

// Drawing and comparing again replace their own files, and keep files changed by the user.
TEST_F(Overwrite, RedrawingKeepsChangedFiles) {
    run(k_voellmy + k_numbers_only, "old");
    for (int time = 0; time < 2; ++time) {
        render({"--map", "max_depth", "--size", "800x600"});
        ASSERT_EQ(frana({"compare", "old", "--scar", "scar.geojson"}).exit_code, 0);
    }
    EXPECT_FALSE(exists("old/maps/max_depth.kept-1.png"));
    write("old/maps/max_depth.png", "my arrows");
    write("old/maps/final_depth.png", "my own");
    write("old/comparison.qml", "my style");
    render({"--map", "max_depth", "--map", "final_depth", "--size", "800x600"});
    const Outcome compared = frana({"compare", "old", "--scar", "scar.geojson"});
    ASSERT_EQ(compared.exit_code, 0) << compared.err;
    EXPECT_NE(compared.err.find("comparison.qml is not as frana wrote it: kept as comparison.kept-1.qml"),
              std::string::npos)
        << compared.err;
    EXPECT_EQ(read_text(path("old/maps/max_depth.kept-1.png")), "my arrows");
    EXPECT_EQ(read_text(path("old/maps/final_depth.kept-1.png")), "my own");
    EXPECT_EQ(read_text(path("old/comparison.kept-1.qml")), "my style");
    EXPECT_GT(fs::file_size(path("old/maps/max_depth.png")), 1000U);
}

TEST_F(Overwrite, AnotherProgramsFolderIsNoResult) {
    run(k_voellmy + k_numbers_only, "old");
    fs::create_directory(path("foreign"));
    write("foreign/scene.ini", "[cars]\n");
    write("foreign/summary.json", "{\"program\": \"another\"}");
    write("foreign/manifest.json", "{\"program\": \"another\", \"format\": 1, \"files\": []}");
    const std::vector<std::string> before = files();
    const Outcome outcome = frana({"run", "scene.ini", "--out", "foreign", "--overwrite"});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_NE(outcome.err.find("not a result; it is never overwritten"), std::string::npos) << outcome.err;
    EXPECT_EQ(files(), before);
}

TEST_F(Overwrite, AnOlderResultWithoutAManifestIsKeptWhole) {
    run(k_voellmy + k_numbers_only, "old");
    run(k_voellmy + k_numbers_only, "fresh");
    write("old/notes.txt", "mine");
    fs::remove(path("old/manifest.json"));
    const std::vector<std::string> before = files_below(path("old"));
    const Outcome outcome = frana({"run", "scene.ini", "--out", "old", "--overwrite"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_NE(outcome.err.find("kept whole in " + path("old.kept-1")), std::string::npos) << outcome.err;
    EXPECT_EQ(files_below(path("old.kept-1")), before);
    expect_same_files(path("fresh"), path("old"));
}

// A manifest is only text: it must not lead out of the folder.
TEST_F(Overwrite, AManifestAffectsNoFileElsewhere) {
    run(k_voellmy + k_numbers_only, "old");
    fs::create_directory(path("photos"));
    write("photos/one.jpg", "a photograph");
    fs::create_directory_symlink("../photos", path("old/album"));
    auto manifest = app::read_manifest(path("old"));
    ASSERT_TRUE(manifest);
    for (const std::string name : {"../photos/one.jpg", "album/one.jpg"})
        manifest->files[name] = app::mark_of(path("photos/one.jpg"));
    app::write_manifest(path("old"), *manifest);
    run(k_voellmy + k_numbers_only, "old", {"--overwrite"});
    EXPECT_EQ(read_text(path("photos/one.jpg")), "a photograph");
    EXPECT_EQ(fs::read_symlink(path("old/album")), "../photos");
}

// Folders beside the result belong to frana only if they have a note with their own name.
TEST_F(Overwrite, FoldersBesideTheResultAreKept) {
    run(k_voellmy + k_numbers_only, "old");
    copy("old", "old.partial-backup");
    fs::create_directories(path("old.partial-Ab12Cd/maps"));
    write("old.partial-Ab12Cd/maps/mine.png", "x");
    const std::vector<std::string> backup = files_below(path("old.partial-backup"));
    run(k_voellmy + k_numbers_only, "old", {"--overwrite"});
    EXPECT_EQ(files_below(path("old.partial-backup")), backup);
    EXPECT_TRUE(exists("old.partial-Ab12Cd/maps/mine.png"));
}

// A run killed after the results were exchanged, and before the user's files were moved.
TEST_F(Overwrite, TheNextRunCompletesWhatAKilledOneLeft) {
    run(k_voellmy + k_entrainment + k_numbers_only, "old");
    run(k_voellmy + k_numbers_only, "fresh");
    copy("fresh", "new");
    write("old/notes.txt", "mine");
    write("old/max_depth.qml", "my style");
    app::note_replaced(path("old"), "result.partial-Ab12Cd");
    fs::rename(path("old"), path("result.partial-Ab12Cd"));
    fs::rename(path("new"), path("result"));
    copy("result.partial-Ab12Cd", "result.partial-backup");
    run(k_voellmy + k_numbers_only, "result", {"--overwrite"});
    EXPECT_EQ(read_text(path("result/notes.txt")), "mine");
    EXPECT_EQ(read_text(path("result/max_depth.kept-1.qml")), "my style");
    EXPECT_FALSE(exists("result/eroded_depth.tif"));
    EXPECT_FALSE(exists("result.partial-Ab12Cd"));
    EXPECT_TRUE(exists("result.partial-backup/notes.txt"));
    EXPECT_EQ(files_below(path("result")).size(), files_below(path("fresh")).size() + 2);
}

// One that cannot be exchanged, as on some file systems or if another folder was put there.
TEST_F(Overwrite, AResultThatCannotBeRenamedIsKeptBesideIt) {
    write("scene.ini",
          "[terrain]\ndtm = dtm.asc\n[release]\nperimeter = perimeter.geojson\nthickness = 2\n[time]\n"
          "end = 60\nstop-when-still = off\n" +
              k_voellmy + k_numbers_only);
    StartedProgram program(folder_.string(), {"run", "scene.ini", "--out", "result", "--quiet"});
    ASSERT_TRUE(program.wait_until([&] {
        const auto names = files();
        return std::any_of(names.begin(), names.end(), [](const std::string& name) {
            return name.starts_with("result.partial-") && name.ends_with("extent.gpkg");
        });
    }));
    fs::create_directory(path("result"));
    write("result/notes.txt", "mine");
    const Outcome outcome = program.wait();
    EXPECT_EQ(outcome.exit_code, 4) << outcome.err;
    const auto at = outcome.err.find("the new one is kept in ");
    ASSERT_NE(at, std::string::npos) << outcome.err;
    EXPECT_EQ(files_below(path("result")), std::vector<std::string>{"notes.txt"});
    int kept = 0;
    for (const std::string& name : files()) {
        kept += name.starts_with("result.kept-") && name.ends_with("/manifest.json") ? 1 : 0;
        EXPECT_EQ(name.find("partial"), std::string::npos) << name;
        EXPECT_EQ(name.find("being_"), std::string::npos) << name;
    }
    EXPECT_EQ(kept, 1);
}

// With every output, of either model.
TEST_F(Overwrite, AResumedRunWritesTheFilesOfAFreshOne) {
    const std::map<std::string, std::string> models{{"first", k_voellmy + k_entrainment}, {"second", k_structured}};
    for (const auto& [name, text] : models) {
        SCOPED_TRACE(name);
        const std::string whole = name + "_whole", result = name + "_resumed";
        const std::vector<std::string> longer{
            "--set", "time.end=8",           "--set", "terrain.cell-size=2.5", "--set", "time.frame-interval=1",
            "--set", "output.maps=max_depth"};
        run(text + k_every_output, whole, longer);
        std::vector<std::string> arguments{"run", "scene.ini", "--out", result, "--quiet"};
        arguments.insert(arguments.end(), longer.begin(), longer.end());
        StartedProgram program(folder_.string(), arguments);
        ASSERT_TRUE(program.wait_until([&] {
            const auto names = files();
            return std::any_of(names.begin(), names.end(), [&](const std::string& one) {
                return one.starts_with(result + ".partial-") && one.ends_with("depth_0001.tif");
            });
        }));
        program.send(SIGINT);
        ASSERT_EQ(program.wait().exit_code, 130);
        arguments.push_back("--resume");
        const Outcome resumed = frana(arguments);
        ASSERT_EQ(resumed.exit_code, 0) << resumed.err;
        EXPECT_GT(expect_same_files(path(whole), path(result)), 80U);
    }
}

class LeftBehind : public Resuming {};

TEST_F(LeftBehind, ACopyOrAUsersFileSavesTheFolderOfAKilledRun) {
    interrupt("result");
    std::string left;
    for (const auto& entry : fs::directory_iterator(folder_))
        if (entry.path().filename().string().starts_with("result.partial-")) left = entry.path().filename().string();
    ASSERT_NE(left, "");
    fs::copy(path(left), path("result.partial-backup"), fs::copy_options::recursive);
    write(left + "/notes.txt", "mine");
    const std::vector<std::string> killed = files_below(path(left)),
                                   backup = files_below(path("result.partial-backup"));
    const Outcome outcome = frana(run("result", {"--overwrite"}));
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_NE(outcome.err.find(left + "; it contains files that frana did not write, and is kept"), std::string::npos)
        << outcome.err;
    EXPECT_EQ(files_below(path(left)), killed);
    EXPECT_EQ(files_below(path("result.partial-backup")), backup);
    fs::remove(path(left + "/notes.txt"));
    ASSERT_EQ(frana(run("result", {"--overwrite"})).exit_code, 0);
    EXPECT_FALSE(fs::exists(path(left)));
    EXPECT_EQ(files_below(path("result.partial-backup")), backup);
}

}  // namespace
}  // namespace frana::test
