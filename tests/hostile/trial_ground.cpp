// SPDX-License-Identifier: Apache-2.0
#include "trial_ground.h"

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <regex>

namespace frana::test {
namespace {

namespace fs = std::filesystem;

// Beside a result, in it and in its folders, and with names similar to those of frana.
const std::vector<std::string> k_beside{"out/beside.txt", "out/r.partial-copy/summary.json", "out/r.old/max_depth.tif"},
    k_within{"out/r/notes.txt", "out/r/my maps/valley.qgz", "out/r/maps/mine.png", "out/r/frames/mine.csv",
             "out/r/max_depth.txt"};

std::vector<std::string> users_files() {
    std::vector<std::string> all = k_beside;
    all.insert(all.end(), k_within.begin(), k_within.end());
    return all;
}

// Pictures that could not be drawn do not fail the run: all else is written, and the summary names them.
bool is_picture(const std::string& path) {
    return path.ends_with(".png") || path.ends_with(".mp4") || path.ends_with("/map.html") || path.ends_with("/");
}

// Removes from the differences those pictures and the files that tell of them.
void forgive_told_pictures(std::vector<std::string>& wrong, const FolderState& now) {
    const std::string missing = "missing: out/r/";
    const auto summary = now.find("out/r/summary.json");
    if (summary == now.end()) return;
    const auto told = [&](const std::string& what) {
        return std::regex_search(summary->second, std::regex(R"(could not be drawn: \{2\}",\s*")" + what + '"'));
    };
    const auto is_told = [&](const std::string& text) {
        if (text.rfind(missing, 0) != 0 || !is_picture(text)) return false;
        const std::string picture = text.substr(missing.size());
        return told("the pictures") || told(picture) || told(picture.substr(0, picture.rfind('.')));
    };
    if (std::erase_if(wrong, is_told) == 0) return;
    std::erase_if(wrong, [](const auto& text) {
        return text.rfind("changed: out/r/summary.json", 0) == 0 || text.rfind("changed: out/r/manifest.json", 0) == 0;
    });
}

bool is_result(const std::string& path) {
    return path.rfind("out/r/", 0) == 0 && !is_users(path) && path.find("partial") == std::string::npos &&
           path.find("/checkpoint/") == std::string::npos &&
           path.find("/records/") == std::string::npos &&  // working files
           !path.ends_with("/manifest.json") &&            // it lists checkpoints
           !path.ends_with("/being_built.json");           // removed when the result has its name
}

}  // namespace

bool is_users(const std::string& path) {
    static const std::vector<std::string> k_files = users_files();
    return path.rfind("in/", 0) == 0 || std::any_of(k_files.begin(), k_files.end(), [&](const auto& file) {
               return file == path || (path.ends_with("/") && path != "out/" && path != "out/r/" &&
                                       path != "out/r/maps/" && path != "out/r/frames/" && file.rfind(path, 0) == 0);
           });
}

SystemCall random_call(const std::vector<SystemCall>& calls, RandomNumbers& random) {
    std::map<std::pair<std::string, std::string>, int> counts;
    for (const SystemCall& call : calls) ++counts[{call.name, call.path}];
    auto chosen = counts.begin();
    std::advance(chosen, static_cast<std::ptrdiff_t>(random.below(counts.size())));
    const auto& [which, count] = *chosen;
    return {which.first, which.second, static_cast<int>(random.below(static_cast<std::size_t>(count)))};
}

TrialGround::TrialGround(const std::string& maps, const std::string& report) {
    write_dtm([](int, int column) { return 300 - 0.5 * std::min((column + 0.5) * k_cell, 200.0); });
    write_scene(
        "stop-when-still = off\nframe-interval = 1\n[output]\nmap-size = 640x480\ncharts = off\nanimation = off\n"
        "checkpoint-interval = 0.02\n" +
        k_one_day + "maps = " + maps + "\nreport = " + report + "\n");
    write("region.ini", "[region]\nscene = scene.ini\n");
    write("study.ini",
          "[study]\nscene = scene.ini\nsamples = 6\n[set]\ntime.end = 2\noutput.depth-thresholds = 0.5\n"
          "output.velocity-thresholds = 1\n[vary]\nmaterial.friction-coefficient = uniform(0.1, 0.3)\n");
    write_polygon("scar", {{20, 40}, {180, 40}, {180, 110}, {20, 110}});
    fs::create_directories(at("in"));
    fs::create_directories(at("out"));
    for (const char* name :
         {"dtm.asc", "dtm.prj", "perimeter.geojson", "scar.geojson", "scene.ini", "study.ini", "region.ini"})
        fs::rename(path(name), at("in/" + std::string(name)));
    std::ofstream(at("out/beside.txt")) << "the user's\n";
    keep("inputs");
}

void TrialGround::keep(const std::string& name) const {
    fs::remove_all(path("kept_" + name));
    fs::copy(place(), path("kept_" + name), fs::copy_options::recursive | fs::copy_options::copy_symlinks);
}

void TrialGround::restore(const std::string& name) const {
    if (!fs::exists(path("kept_" + name))) name == "killed" ? keep_killed_run() : keep_older_result();
    fs::remove_all(place());
    fs::copy(path("kept_" + name), place(), fs::copy_options::recursive | fs::copy_options::copy_symlinks);
}

Ending TrialGround::run(const Launch& launch, const Watch& watch, const Judge& judge) const {
    Launch with_date = launch;
    with_date.environment.emplace_back("XDG_DATA_HOME=" + at("out/home"));
    with_date.environment.emplace_back("OGR_CURRENT_DATE=2020-01-01T00:00:00.000Z");  // GeoPackages contain the date
    return run_supervised(place(), with_date, watch, judge);
}

void TrialGround::keep_older_result() const {
    restore("inputs");
    const Ending ending =
        run({"run", "in/scene.ini", "--out", "out/r", "--set", "time.end=2", "--set", "release.thickness=3"});
    ASSERT_EQ(ending.exit_code, 0) << ending.err;
    // An overwrite is refused while users' files are in the result.
    for (const auto& [names, state] : {std::pair{k_beside, "older alone"}, {k_within, "older"}}) {
        for (const std::string& name : names) {
            fs::create_directories(fs::path(at(name)).parent_path());
            std::ofstream(at(name)) << "the user's " << name << "\n";
        }
        keep(state);
    }
}

// With a checkpoint on disk: killed before the next is complete, or else before the last file.
void TrialGround::keep_killed_run() const {
    restore("inputs");
    const Ending ending = run({{"run", "in/scene.ini", "--out", "out/r"}}, {}, [](const SystemCall& call) {
        const bool next = call.name == "fsync" && call.path.ends_with("/checkpoint") && call.again > 0;
        const bool last = call.name.rfind("link", 0) == 0 && call.path.ends_with("/summary.json");
        return next || last ? Answer{Answer::Kind::signal, SIGKILL} : Answer{};
    });
    ASSERT_EQ(ending.exit_code, -SIGKILL) << ending.err;
    keep("killed");
}

void TrialGround::measure(TriedCommand& command, const Watch& watch) const {
    if (!command.after.empty()) return;
    restore(command.begins_in);
    command.before = state();
    const Ending ending = run({command.arguments}, watch, [](const SystemCall&) { return Answer{}; });
    ASSERT_EQ(ending.exit_code, 0) << command.name << ": " << ending.err;
    command.after = state();
    command.calls = ending.calls;
    EXPECT_EQ(broken_rasters(place()).size(),
              command.begins_in.starts_with("older") ? 1U : 0U);  // the user's file is no raster
}

std::vector<TriedCommand> TrialGround::commands() {
    const std::vector<std::string> run_it{"run", "in/scene.ini", "--out", "out/r", "--quiet"};
    const auto with = [&](std::vector<std::string> more) {
        more.insert(more.begin(), run_it.begin(), run_it.end());
        return more;
    };
    const std::vector<std::string> render{"render", "out/r",       "--map",  "max_velocity",
                                          "--map",  "final_depth", "--size", "640x480"};
    const std::vector<std::string> compare{"compare", "out/r", "--scar", "in/scar.geojson", "--size", "640x480"};
    const std::vector<std::string> converge{"converge", "in/scene.ini", "--out",     "out/study",
                                            "--quiet",  "--set",        "time.end=1"};
    std::vector<std::string> converge_again = converge;
    converge_again.emplace_back("--overwrite");
    const std::vector<std::string> new_scene{
        "new", "in/dtm.asc", "in/perimeter.geojson", "--out", "out/mine.ini", "--thickness", "2"};
    std::vector<std::string> new_again = new_scene;
    new_again.emplace_back("--overwrite");
    const std::vector<std::string> ensemble{"ensemble", "in/study.ini", "--out", "out/r", "--quiet"};
    const auto ensemble_with = [&](std::vector<std::string> more) {
        more.insert(more.begin(), ensemble.begin(), ensemble.end());
        return more;
    };
    const std::vector<std::string> batch{"batch", "in/region.ini", "--out", "out/r", "--quiet"};
    std::vector<std::string> batch_again = batch;
    batch_again.emplace_back("--resume");
    const std::vector<std::string> plugin{"qgis-plugin", "--install"};
    return {
        {"run", "inputs", run_it, with({"--resume"})},
        {"run --overwrite", "older alone", with({"--overwrite"}), with({"--overwrite", "--resume"})},
        {"run --resume", "killed", with({"--resume"}), with({"--resume"})},
        {"render", "older", render, render, false},
        {"compare", "older", compare, compare, false},
        {"converge", "inputs", converge, converge_again, false},
        {"ensemble", "inputs", ensemble, ensemble_with({"--resume"})},
        {"ensemble --overwrite", "older alone", ensemble_with({"--overwrite"}),
         ensemble_with({"--overwrite", "--resume"})},
        {"batch", "inputs", batch, batch_again},
        {"new", "inputs", new_scene, new_again, false},
        {"qgis-plugin", "inputs", plugin, plugin},
        {"check", "older", {"check", "in/scene.ini"}, {"check", "in/scene.ini"}},
    };
}

void expect_decent_end(const Ending& ending, Disturbance by) {
    if (by == Disturbance::memory && ending.exit_code < 0) return;
    if (by == Disturbance::kill && ending.exit_code == -SIGKILL) return;
    EXPECT_FALSE(ending.hung && by != Disturbance::kill) << ending.err;
    const bool known = ending.exit_code == 0 || ending.exit_code == -SIGTERM ||  // the shell returns 143 for both
                       (ending.exit_code >= 2 && ending.exit_code <= 4) || ending.exit_code == 128 + SIGHUP ||
                       ending.exit_code == 128 + SIGINT || ending.exit_code == 128 + SIGTERM;
    EXPECT_TRUE(known) << "exit code " << ending.exit_code << ": " << ending.err;
    for (const char* word : {"Sanitizer", "runtime error:", "terminate called", "Assertion"})
        EXPECT_EQ(ending.err.find(word), std::string::npos) << ending.err;
    if (ending.exit_code < 2 || ending.exit_code > 4) return;
    // A file, a key, an option, or memory; warnings explain why not everything could be drawn.
    static const std::regex k_named(R"(frana: [^]*(/|\.[a-z]|[a-z]+\.[a-z-]+|--[a-z]+|memory|warning))");
    EXPECT_TRUE(std::regex_search(ending.err, k_named))
        << "exit code " << ending.exit_code << ": '" << ending.err << "'";
}

void TrialGround::expect_old_or_new(const TriedCommand& command, const Ending& ending, const FolderState& now) const {
    const FolderState before = part_of(command.before, is_result), after = part_of(command.after, is_result);
    const FolderState found = part_of(now, is_result);
    if (!command.whole) {
        for (const auto& [path, content] : found) {
            const bool old = before.contains(path) && before.at(path) == content;
            EXPECT_TRUE(old || (after.contains(path) && after.at(path) == content))
                << path << " is neither old nor new";
        }
        for (const auto& [path, content] : before) EXPECT_TRUE(found.contains(path)) << path << " is missing";
        return;
    }
    if (differences(before, found).empty()) return;
    if (ending.exit_code > 128) return;  // stopped: the files until then are published
    std::vector<std::string> wrong = differences(after, found);
    forgive_told_pictures(wrong, found);
    if (ending.exit_code == 4)
        std::erase_if(wrong, [](const auto& text) { return text.rfind("missing: ", 0) == 0 && is_picture(text); });
    EXPECT_TRUE(wrong.empty()) << "neither the older result nor the new one, which would differ so:\n"
                               << in_lines(wrong);
}

void TrialGround::expect_nothing_lost(const TriedCommand& command, const Ending& ending, Disturbance by) const {
    expect_decent_end(ending, by);
    const FolderState now = state();
    const FolderState users = part_of(command.before, is_users);
    const std::vector<std::string> touched = differences(users, part_of(now, is_users));
    EXPECT_TRUE(touched.empty()) << "files of the user's:\n" << in_lines(touched);
    expect_old_or_new(command, ending, now);
    if (ending.exit_code != 0) return;
    std::vector<std::string> wrong = differences(command.after, now);
    if (by == Disturbance::removal) {
        const auto is_new = [](const auto& text) { return text.rfind("new: ", 0) == 0; };
        // Files that remain in a result remain in its list too.
        const bool stays = std::any_of(wrong.begin(), wrong.end(), is_new);
        std::erase_if(wrong, [&](const auto& text) {
            return is_new(text) || (stays && text.rfind("changed: out/r/manifest.json", 0) == 0);
        });
    }
    forgive_told_pictures(wrong, now);
    EXPECT_TRUE(wrong.empty()) << "exit code 0, but not the result of a run undisturbed:\n"
                               << in_lines(wrong) << ending.err;
}

void TrialGround::expect_repaired(const TriedCommand& command) const {
    if (differences(command.after, state()).empty()) return;  // there is nothing to repair
    const Ending ending = run(command.again);
    EXPECT_EQ(ending.exit_code, 0) << "the same again: " << ending.err;
    std::vector<std::string> wrong = differences(command.after, state());
    forgive_told_pictures(wrong, state());  // a complete study is not drawn again; `frana render` does
    EXPECT_TRUE(wrong.empty()) << "the same again does not end in the same:\n" << in_lines(wrong) << ending.err;
}

}  // namespace frana::test
