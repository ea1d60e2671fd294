// SPDX-License-Identifier: Apache-2.0
// A result replaces an older one: nothing of the older one is mistaken for the new, and users' files are in the way.
#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <map>

#include "app/store/manifest.h"
#include "app/store/own_files.h"
#include "app/store/result_directory.h"
#include "app/store/result_files.h"
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
    /// Makes results of commands that run many scenes, "range", "region", "fitted", "fitted_to_two", and a comparison
    /// of "old".
    void make_studies() const;
    /// Expects that --overwrite is refused with these words.
    void expect_refused(const std::string& words, const std::string& result = "old") const {
        Problems problems;
        EXPECT_FALSE(app::check_result_directory(path(result), app::Older::replaced, {}, "--out", problems));
        std::string told;
        for (const Problem& problem : problems.list()) told += describe(problem) + '\n';
        EXPECT_NE(told.find(words), std::string::npos) << words << "\nin " << told;
    }
    /// The same by the program, which changes nothing.
    void expect_refused_by_the_program(const std::string& words, const std::string& result = "old") const {
        const auto before = bytes_below(folder_.string());
        refusal_of(frana({"run", "scene.ini", "--out", result, "--overwrite"}), {words});
        EXPECT_TRUE(bytes_below(folder_.string()) == before);
    }
    [[nodiscard]] static std::map<std::string, std::string> bytes_below(const std::string& folder) {
        std::map<std::string, std::string> all;
        for (const std::string& name : files_below(folder)) {
            const fs::path file = fs::path(folder) / name;
            all[name] = fs::is_symlink(file) ? fs::read_symlink(file).string() : read_text(file.string());
        }
        return all;
    }
};

TEST_F(Overwrite, LeavesTheFilesOfAFreshRun) {
    const std::map<std::string, std::string> scenes{
        {"all_of_the_first_model",
         k_voellmy + k_stress + k_entrainment + k_every_output + "[output]\nanimation = off\n"},
        {"all_of_the_second_model", k_structured + k_every_output + "[output]\nanimation = off\n"},
        {"least", k_voellmy + k_numbers_only},
        {"film", k_voellmy + "[output]\nmaps = off\nframes = off\nreport = off\nmap-size = 640x480\n"},
        {"other_frames", k_voellmy + "[output]\nmaps = off\nanimation = off\nreport = off\nformats = geotiff, "
                                     "particles-gpkg\n"}};
    for (const auto& [name, text] : scenes) run(text, name);
    for (const auto& [older, older_text] : scenes) {
        if (!older.starts_with("all") && older != "film") continue;
        for (const auto& [name, text] : scenes) {
            if (name == older || name == "film") continue;
            if (older != "all_of_the_first_model" && name != "least") continue;
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
    write_scene(k_pages_only +
                "formats = geotiff, shp, kmz, dxf\npressure-thresholds = 5\nmomentum-flux-thresholds = "
                "1\n[hazard]\nscheme = swiss-debris-flow\nprocess "
                "= all\n[material]\n"
                "density = 2000\n");
    write("study.ini",
          "[study]\nscene = scene.ini\nsamples = 8\nsampling = random\nkeep = all\n[frequency]\nrate = 0.05\n"
          "[set]\noutput.exposure = perimeter.geojson\n" +
              two_keys);
    write("region.ini",
          "[region]\nscene = scene.ini\nscenario = depth\nreturn-period = depth\n[set]\n"
          "output.exposure = perimeter.geojson\n");
    write("surveyed.ini", read_text(path("scene.ini")) + "[scar]\nperimeter = scar.geojson\n");
    write("again.ini", read_text(path("surveyed.ini")));
    const std::string few = "\nsamples = 8\n[objective]\njaccard = 1\n" + two_keys;
    write("fitted.ini", "[study]\nscene = surveyed.ini" + few);
    write("fitted_to_two.ini",
          "[study]\nscene = surveyed.ini, again.ini" + few + "[vary again]\nrelease.volume = uniform(3000, 5000)\n");
    const std::vector<std::vector<std::string>> commands{
        {"ensemble", "study.ini", "--out", "range", "--quiet"},
        {"batch", "region.ini", "--out", "region", "--quiet"},
        {"calibrate", "fitted.ini", "--out", "fitted", "--quiet"},
        {"compare", "old", "--scar", "scar.geojson", "--size", "640x480"},
        {"calibrate", "fitted_to_two.ini", "--out", "fitted_to_two", "--quiet"}};
    for (const std::vector<std::string>& command : commands) {
        succeeded(frana(command));
    }
}

// The table is complete, and every row of it exists.
TEST_F(Overwrite, EveryFileOfAResultIsInItsManifestAndInTheTable) {
    run(k_voellmy + k_stress + k_entrainment + k_every_output, "old");
    render_all();
    run(k_structured + k_every_output +
            "[structured]\nsoil-conductivity = 10\nsoil-suction = 0.1\nsoil-moisture-deficit = 0.3\n",
        "other");
    run("[material]\nfriction-table = ngi-avalanche\nreturn-period = 100\n" + k_every_output, "table");
    run(k_voellmy + k_numbers_only + "formats = geotiff, shp, kmz, dxf\n[hazard]\nscheme = austrian-torrent\n",
        "zones");
    make_studies();
    std::map<std::string, int> rows;
    for (const std::string result : {"zones", "old", "other", "table", "range", "region", "fitted", "fitted_to_two"}) {
        const auto manifest = app::read_manifest(path(result));
        ASSERT_TRUE(manifest);
        for (const std::string& name : files_below(path(result))) {
            const app::ResultFile* row = app::existing_file(name);
            const bool has_a_place_of_its_own =
                name == "film.gif" || name.starts_with("more/") || name.starts_with("compared/");
            EXPECT_EQ(row == nullptr, has_a_place_of_its_own) << name;
            if (row != nullptr) ++rows[row->pattern];
            if (name == "manifest.json") continue;
            ASSERT_EQ(manifest->files.count(name), 1U) << name;
            EXPECT_EQ(manifest->files.at(name), fs::file_size(path(result + "/" + name))) << name;
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
    // A study is not replaced either while users' files are in the way.
    const std::map<std::string, std::vector<std::string>> commands{{"range", {"ensemble", "study.ini"}},
                                                                   {"region", {"batch", "region.ini"}},
                                                                   {"fitted", {"calibrate", "fitted.ini"}}};
    for (const auto& [result, words] : commands) {
        write(result + "/notes.txt", "mine");
        const auto before = bytes_below(path(result));
        refusal_of(frana({words[0], words[1], "--out", result, "--quiet", "--overwrite"}),
                   {"contains a file that frana did not write, or that was changed since: notes.txt"});
        EXPECT_TRUE(bytes_below(path(result)) == before);
    }
}

TEST_F(Overwrite, IsRefusedWhileUsersFilesAreInTheWay) {
    run(k_voellmy + k_entrainment + "[output]\nmap-size = 640x480\nmaps = max_depth\nanimation = off\n", "old");
    const std::string one = "contains a file that frana did not write, or that was changed since: ";
    // Of the user's own, with a name of frana's that is not listed, changed, and a journal with changes in it.
    for (const std::string name :
         {"notes.txt", "maps/mine.png", "frames/depth_9999_mine.txt", "gis/deep/er.qgz", "manifest.json.bak",
          "hazard.tif", "max_depth.tif.aux.xml.old", "extent.gpkg-wal", "notes.txt.aux.xml"}) {
        fs::create_directories(fs::path(path("old/" + name)).parent_path());
        write("old/" + name, "mine");
        expect_refused(one + name + " (value ");
        fs::remove(path("old/" + name));
    }
    for (const std::string name :
         {"max_depth.qml", "eroded_depth.tif", "maps/max_depth.png", "frames/depth_0001.tif"}) {
        const std::string before = read_text(path("old/" + name));
        for (const std::string& changed : {std::string("mine"), before + "\n"}) {
            write("old/" + name, changed);
            expect_refused(one + name + " (changed) (value ");
        }
        write("old/" + name, before);
    }
    fs::create_symlink("/nowhere", path("old/link"));
    expect_refused(one + "link");
    expect_refused_by_the_program("Move them to another folder, or choose another result directory with --out");
    for (int i = 0; i < 12; ++i) write("old/note_" + std::to_string(i), "mine");
    expect_refused("contains 13 files that frana did not write, or that were changed since: link, note_0, ");
    expect_refused("note_6, and 3 more");
    for (int i = 0; i < 12; ++i) fs::remove(path("old/note_" + std::to_string(i)));
    fs::remove(path("old/link"));
    // Folders without files, and files that are missing, are no files of the user's.
    fs::create_directories(path("old/empty/deeper"));
    fs::remove(path("old/maps/max_depth.png"));
    run(k_voellmy + k_numbers_only, "fresh");
    run(k_voellmy + k_numbers_only, "old", {"--overwrite"});
    expect_same_files(path("fresh"), path("old"));
    EXPECT_EQ(files_below(path("old")).size(), files_below(path("fresh")).size());
    EXPECT_FALSE(exists("old/empty"));
    EXPECT_FALSE(exists("old.partial"));
}

/// As QGIS does to show a GeoPackage, and to change it.
void open_as_a_gis(const std::string& file, const std::string& statement) {
    const std::string script = "import sqlite3; c = sqlite3.connect('" + file + "', isolation_level=None); " +
                               "[c.execute(s).fetchall() for s in ('PRAGMA journal_mode = wal', \"\"\"" + statement +
                               "\"\"\", 'PRAGMA journal_mode = delete')]";
    std::ofstream(file + ".py") << script;
    ASSERT_EQ(std::system(("python3 '" + file + ".py'").c_str()), 0);
    fs::remove(file + ".py");
}

TEST_F(Overwrite, IsNotRefusedForWhatAGisMakesToShowAResult) {
    run(k_voellmy + k_numbers_only, "old");
    const std::string outlines = read_text(path("old/extent.gpkg"));
    for (int time = 0; time < 3; ++time) open_as_a_gis(path("old/extent.gpkg"), "SELECT count(*) FROM gpkg_contents");
    EXPECT_TRUE(read_text(path("old/extent.gpkg")) != outlines);
    for (const char* name : {"max_depth.tif.aux.xml", "extent.gpkg-shm", "result.qgz~"})
        write("old/" + std::string(name), "of QGIS");
    write("old/extent.gpkg-wal", "");
    run(k_voellmy + k_numbers_only, "old", {"--overwrite"});
    for (const char* name : {"max_depth.tif.aux.xml", "extent.gpkg-shm", "result.qgz~", "extent.gpkg-wal"})
        EXPECT_FALSE(exists("old/" + std::string(name))) << name;
}

// Drawing and comparing again replace their own files, and none that the user changed.
TEST_F(Overwrite, RedrawingIsRefusedForChangedFiles) {
    run(k_voellmy + k_numbers_only, "old");
    const std::vector<std::string> compare{"compare", "old", "--scar", "scar.geojson", "--size", "640x480"},
        draw{"render", "old", "--map", "max_depth", "--map", "final_depth", "--size", "640x480"};
    for (int time = 0; time < 2; ++time) {
        succeeded(frana(draw));
        succeeded(frana(compare));
        open_as_a_gis(path("old/comparison.gpkg"), "SELECT count(*) FROM gpkg_contents");  // shown, not changed
    }
    write("old/maps/max_depth.png", "my arrows");
    write("old/comparison.qml", "my style");
    for (const auto& [words, name] : {std::pair(draw, "maps/max_depth.png"), std::pair(compare, "comparison.qml")}) {
        const auto before = bytes_below(path("old"));
        refusal_of(frana(words), {"was changed since frana wrote it, or is the user's", name});
        EXPECT_TRUE(bytes_below(path("old")) == before);
    }
}

TEST_F(Overwrite, AnotherProgramsFolderIsNoResult) {
    run(k_voellmy + k_numbers_only, "old");
    fs::create_directory(path("foreign"));
    write("foreign/scene.ini", "[cars]\n");
    write("foreign/summary.json", "{\"program\": \"another\"}");
    write("foreign/manifest.json", "{\"program\": \"another\", \"format\": 1, \"files\": []}");
    expect_refused_by_the_program("not a result; it is never overwritten", "foreign");
}

TEST_F(Overwrite, AResultWithoutItsManifestIsRefused) {
    run(k_voellmy + k_numbers_only, "old");
    fs::remove(path("old/manifest.json"));
    expect_refused("not a result; it is never overwritten");
}

// A manifest is only text: it must not lead out of the folder.
TEST_F(Overwrite, AManifestAffectsNoFileElsewhere) {
    run(k_voellmy + k_numbers_only, "old");
    fs::create_directory(path("photos"));
    write("photos/one.jpg", "a photograph");
    auto manifest = app::read_manifest(path("old"));
    ASSERT_TRUE(manifest);
    for (const std::string name : {"../photos/one.jpg", "album/one.jpg"})
        manifest->files[name] = fs::file_size(path("photos/one.jpg"));
    app::write_manifest(path("old"), *manifest);
    run(k_voellmy + k_numbers_only, "old", {"--overwrite"});
    EXPECT_EQ(read_text(path("photos/one.jpg")), "a photograph");
    manifest = app::read_manifest(path("old"));
    manifest->files["album/one.jpg"] = fs::file_size(path("photos/one.jpg"));
    app::write_manifest(path("old"), *manifest);
    fs::create_directory_symlink("../photos", path("old/album"));
    expect_refused("album");
}

// Only the partial folder with a note that has its own name is frana's.
TEST_F(Overwrite, FoldersBesideTheResultAreKept) {
    run(k_voellmy + k_numbers_only, "old");
    copy("old", "old.partial-backup");
    copy("old", "old.old");
    run(k_voellmy + k_numbers_only, "old", {"--overwrite"});
    EXPECT_TRUE(exists("old.partial-backup/summary.json"));
    EXPECT_TRUE(exists("old.old/summary.json"));
    fs::rename(path("old.old"), path("old.partial"));
    expect_refused("old.partial: was not made by frana");
    app::note_building(path("old.partial-backup"));
    write("old.partial/being_built.json", read_text(path("old.partial-backup/being_built.json")));
    expect_refused("old.partial: was not made by frana");
}

// A run killed after the results were exchanged, and before the older one was removed.
TEST_F(Overwrite, TheNextRunCompletesWhatAKilledOneLeft) {
    const std::string older = k_voellmy + k_entrainment + k_numbers_only;
    run(k_voellmy + k_numbers_only, "fresh");
    for (const std::string option : {"--overwrite", "--resume"}) {
        SCOPED_TRACE(option);
        run(older, "result");
        copy("fresh", "result.partial");
        app::note_building(path("result.partial"));
        app::note_replaced(path("result"));
        fs::rename(path("result"), path("waiting"));
        fs::rename(path("result.partial"), path("result"));
        fs::rename(path("waiting"), path("result.partial"));
        write("result.partial/notes.txt", "mine");
        expect_refused("result.partial: was left by a run that was killed and contains a file", "result");
        fs::remove(path("result.partial/notes.txt"));
        run(k_voellmy + k_numbers_only, "result", {option});
        EXPECT_FALSE(exists("result.partial"));
        expect_same_files(path("fresh"), path("result"));
        EXPECT_EQ(files_below(path("result")).size(), files_below(path("fresh")).size());
        fs::remove_all(path("result"));
    }
}

// Files that come into the older result, or to the result's place, while the new one is computed.
TEST_F(Overwrite, AResultWhosePlaceIsNoLongerFreeIsKeptBesideIt) {
    const std::string scene =
        "[terrain]\ndtm = dtm.asc\n[release]\nperimeter = perimeter.geojson\nthickness = 2\n[time]\n"
        "end = 60\nstop-when-still = off\n" +
        k_voellmy + k_numbers_only;
    for (const bool has_older : {false, true}) {
        SCOPED_TRACE(has_older);
        if (has_older) run(k_voellmy + k_numbers_only, "result");
        write("scene.ini", scene);
        std::vector<std::string> arguments{"run", "scene.ini", "--out", "result", "--quiet"};
        if (has_older) arguments.emplace_back("--overwrite");
        StartedProgram program(folder_.string(), arguments);
        ASSERT_TRUE(program.wait_until([&] { return exists("result.partial/extent.gpkg"); }));
        fs::create_directories(path("result"));
        write("result/notes.txt", "mine");
        const auto before = bytes_below(path("result"));
        const Outcome outcome = program.wait();
        EXPECT_EQ(outcome.exit_code, 4) << outcome.err;
        expect_words(outcome.err, {"the new result is complete in " + path("result.partial"),
                                   "elsewhere and publish it by the same command with --resume"});
        EXPECT_EQ(outcome.err.find("MB free"), std::string::npos) << "it is not the disk";
        EXPECT_TRUE(bytes_below(path("result")) == before);
        EXPECT_TRUE(exists("result.partial/manifest.json"));
        fs::remove(path("result/notes.txt"));
        arguments.emplace_back("--resume");
        succeeded(frana(arguments));
        EXPECT_FALSE(exists("result.partial"));
        fs::remove_all(path("result"));
    }
}

// With every output, of either model.
TEST_F(Overwrite, AResumedRunWritesTheFilesOfAFreshOne) {
    const std::map<std::string, std::string> models{{"first", k_voellmy + k_stress + k_entrainment},
                                                    {"second", k_structured}};
    for (const auto& [name, text] : models) {
        SCOPED_TRACE(name);
        const std::string whole = name + "_whole", result = name + "_resumed";
        const std::vector<std::string> longer{
            "--set", "time.end=8",           "--set", "terrain.cell-size=2.5", "--set", "time.frame-interval=1",
            "--set", "output.maps=max_depth"};
        run(text + k_every_output, whole, longer);
        std::vector<std::string> arguments = with_more({"run", "scene.ini", "--out", result, "--quiet"}, longer);
        StartedProgram program(folder_.string(), arguments);
        ASSERT_TRUE(program.wait_until([&] { return exists(result + ".partial/frames/depth_0001.tif"); }));
        program.send(SIGINT);
        ASSERT_EQ(program.wait().exit_code, 130);
        arguments.push_back("--resume");
        succeeded(frana(arguments));
        EXPECT_GT(expect_same_files(path(whole), path(result)), 80U);
    }
}

class LeftBehind : public Resuming {};

TEST_F(LeftBehind, AUsersFileInTheFolderOfAKilledRunIsInTheWay) {
    interrupt("result");
    write("result.partial/notes.txt", "mine");
    const std::vector<std::string> killed = files_below(path("result.partial"));
    for (const char* option : {"--overwrite", "--resume"}) {
        refusal_of(frana(run("result", {option})),
                   {"result.partial: was left by a run that was killed and contains a file that frana did "
                    "not write, or that was changed since: notes.txt"});
        EXPECT_EQ(files_below(path("result.partial")), killed);
    }
    fs::remove(path("result.partial/notes.txt"));
    succeeded(frana(run("result", {"--overwrite"})));
    EXPECT_FALSE(fs::exists(path("result.partial")));
}

}  // namespace
}  // namespace frana::test
