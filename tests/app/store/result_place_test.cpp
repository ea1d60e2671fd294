// SPDX-License-Identifier: Apache-2.0
// Places of a result: links, other disks and folders without permission.
#include <sys/mount.h>
#include <sys/stat.h>
#include <unistd.h>

#include "app/input/share_directory.h"
#include "app/store/manifest.h"
#include "app/store/own_files.h"
#include "app/store/result_directory.h"
#include "params/scene/read_scene.h"
#include "same_result.h"
#include "support/tiny_scene.h"

namespace frana::test {
namespace {

namespace fs = std::filesystem;

class Place : public TinyScene {
  protected:
    Place() { write_scene(k_numbers_only); }
    [[nodiscard]] Outcome run(const std::string& out, const std::vector<std::string>& more = {}) const {
        return frana(with_more({"run", "scene.ini", "--quiet", "--set", "time.end=0.5", "--out", out}, more));
    }
    /// `run` and `check` report the same.
    void expect_refused(const std::string& out, const std::string& what, const std::string& remedy) const {
        for (const app::Older older : {app::Older::replaced, app::Older::unknown}) {
            Problems problems;
            EXPECT_FALSE(app::check_result_directory(path(out), older, {}, "--out", problems));
            ASSERT_EQ(problems.list().size(), 1U) << out;
            EXPECT_EQ(problems.list().front().what, what) << out;
            EXPECT_EQ(problems.list().front().remedy, remedy) << out;
        }
    }
    [[nodiscard]] bool is_result(const std::string& name) const { return fs::exists(path(name + "/summary.json")); }
};

/// A mounted file system during its lifetime.
class Mounted {
  public:
    explicit Mounted(std::string place) : place_(std::move(place)) {
        is_there_ = ::mount("tmpfs", place_.c_str(), "tmpfs", 0, "size=16m") == 0;
    }
    ~Mounted() {
        if (is_there_) ::umount2(place_.c_str(), MNT_DETACH);
    }
    Mounted(const Mounted&) = delete;
    Mounted& operator=(const Mounted&) = delete;
    [[nodiscard]] bool is_there() const { return is_there_; }

  private:
    std::string place_;
    bool is_there_;
};

TEST_F(Place, ALinkIsRefusedWithItsRemedy) {
    fs::create_directories(path("disk/empty"));
    fs::create_directory_symlink("disk/empty", path("to_empty"));
    fs::create_directory_symlink("no_disk/result", path("dangling"));
    fs::create_directory_symlink("circle", path("circle"));
    fs::create_directory_symlink("disk", path("to_disk"));
    const std::string replaced = "is a symbolic link, which a result would replace";
    for (const std::string link : {"to_empty/", "dangling", "circle"})
        expect_refused(link, replaced, "Name the folder that it leads to");
    refusal_of(run("dangling", {"--overwrite"}), {replaced});
    succeeded(run("to_disk/result"));
    EXPECT_TRUE(is_result("disk/result"));
    fs::create_directory(path("elsewhere"));
    fs::create_directory_symlink("elsewhere", path("result.partial"));
    expect_refused("result", "is a symbolic link: the result would be built elsewhere",
                   "Remove it, or choose another folder with --out");
}

// It cannot be renamed: what was computed stays beside it.
TEST_F(Place, AResultThatCannotTakeItsNameIsKeptBesideIt) {
    fs::create_directories(path("disk"));
    const Mounted disk(path("disk"));
    if (!disk.is_there()) GTEST_SKIP() << "nothing may be mounted here";
    const Outcome outcome = run("disk");
    EXPECT_EQ(outcome.exit_code, 4) << outcome.err;
    EXPECT_NE(outcome.err.find("the new result is complete in " + path("disk.partial")), std::string::npos)
        << outcome.err;
    EXPECT_TRUE(is_result("disk.partial"));
    succeeded(run("disk/result"));
}

/// Runs as a user without permissions during its lifetime.
class AsNobody {
  public:
    AsNobody() { is_ = ::geteuid() == 0 && ::setegid(65534) == 0 && ::seteuid(65534) == 0; }
    ~AsNobody() {
        if (is_ && (::seteuid(0) != 0 || ::setegid(0) != 0)) std::abort();
    }
    AsNobody(const AsNobody&) = delete;
    AsNobody& operator=(const AsNobody&) = delete;
    [[nodiscard]] bool is() const { return is_; }

  private:
    bool is_;
};

TEST_F(Place, WithoutPermissionIsRefused) {
    for (const char* name : {"closed", "open", "open/closed"}) fs::create_directories(path(name));
    ASSERT_EQ(::chmod(path("open").c_str(), 0777), 0);
    ASSERT_EQ(::chmod(path("open/closed").c_str(), 0555), 0);
    ASSERT_EQ(::chmod(path("").c_str(), 0755), 0);
    const auto refusal = [&](const std::string& directory) -> std::string {
        Problems problems;
        const auto problem = app::check_result_directory(path(directory), app::Older::replaced, {}, "--out", problems);
        EXPECT_TRUE(problems.empty());
        return problem ? describe(*problem) : "";
    };
    const AsNobody nobody;
    if (!nobody.is()) GTEST_SKIP() << "only root can change the user";
    // access(2) checks the real user, which is still root: the effective one must be checked.
    EXPECT_NE(refusal("closed/result").find("cannot be written"), std::string::npos) << refusal("closed/result");
    EXPECT_NE(refusal("closed").find("cannot be written"), std::string::npos);
    EXPECT_NE(refusal("open/closed").find("may not be changed"), std::string::npos) << refusal("open/closed");
    EXPECT_EQ(refusal("open/result"), "");
}

// A colleague's folder, a disk mounted read-only: all problems at once, with a remedy also by check.
TEST_F(Place, ThatCannotBeWrittenIsReportedWithTheScenesProblems) {
    fs::create_directories(path("disk"));
    const Mounted disk(path("disk"));
    if (!disk.is_there() || ::mount("tmpfs", path("disk").c_str(), "tmpfs", MS_REMOUNT | MS_RDONLY, "size=16m") != 0)
        GTEST_SKIP() << "nothing may be mounted here";
    write_scene(k_numbers_only + "directory = disk/result\n");
    for (const std::string command : {"check", "run"}) {
        const Outcome alone = frana({command, "scene.ini"});
        EXPECT_EQ(alone.exit_code, 4) << alone.err;
        EXPECT_NE(alone.err.find("Choose another result directory with --out"), std::string::npos) << alone.err;
        refusal_of(frana({command, "scene.ini", "--set", "terrain.dtm=nosuch.tif"}),
                   {"nosuch.tif", "cannot be written"});
    }
    const Outcome elsewhere = succeeded(frana({"check", "scene.ini", "--out", "elsewhere"}));
    EXPECT_NE(elsewhere.out.find(path("elsewhere")), std::string::npos) << elsewhere.out;
    EXPECT_FALSE(fs::exists(path("elsewhere")));
}

TEST_F(Place, WhoseNameIsTooLongIsRefusedBeforeAFolderIsMade) {
    expect_refused("above/" + std::string(249, 'a'), "has a name that is too long", "Choose a shorter one with --out");
    EXPECT_FALSE(fs::exists(path("above")));
}

// Whatever the name of a file of the replaced result: by a link, by a layer in it, in GDAL's syntax.
// SQLite opens no longer path; the run was computed to its end, and the disk blamed.
TEST_F(Place, WhosePathIsTooLongForAGeoPackageIsRefusedAtOnce) {
    write_scene(
        "[output]\nmaps = off\nanimation = off\nreport = off\nframes = on\ncharts = off\nformats = particles-gpkg\n");
    const auto of_length = [&](std::size_t bytes) {
        std::string place = path(std::string(150, 'a') + "/" + std::string(80, 'b') + "/");
        return place + std::string(bytes - place.size(), 'c');
    };
    const std::string far = std::string(200, 'a') + "/" + std::string(200, 'b') + "/" + std::string(200, 'c');
    for (const std::string& place : {path(far), of_length(401)})
        expect_refused(place, "has a path that is too long: GeoPackages in it could not be written",
                       "Choose a folder nearer to the root with --out");
    EXPECT_FALSE(fs::exists(path(std::string(150, 'a'))));
    succeeded(run(of_length(400)));
    EXPECT_TRUE(fs::exists(of_length(400) + "/extent.gpkg"));
    EXPECT_TRUE(fs::exists(of_length(400) + "/frames/particles_0000.gpkg"));
}

TEST_F(Place, InputsThatTheResultWouldReplaceAreRefusedUnderAnyName) {
    succeeded(run("result"));
    fs::create_symlink(path("result/dtm.tif"), path("linked.tif"));
    fs::create_directory_symlink(path("result"), path("alias"));
    for (const std::string& input : std::vector<std::string>{
             "terrain.dtm=linked.tif", "terrain.dtm=alias/dtm.tif",
             "release.perimeter=result/extent.gpkg|layer=release", "release.perimeter=alias/extent.gpkg|layer=release",
             "release.thickness=raster:linked.tif", "terrain.dtm=GTIFF_RAW:" + path("result/dtm.tif")}) {
        SCOPED_TRACE(input);
        const SceneReading reading = read_scene(path("scene.ini"), {input}, app::share_directory());
        Problems problems;
        EXPECT_FALSE(app::check_result_directory(path("result"), app::Older::replaced, input_files(reading.scene),
                                                 "--out", problems));
        ASSERT_EQ(problems.list().size(), 1U);
        EXPECT_EQ(problems.list().front().what, "is an input and would be replaced by the result");
    }
}

// A second name of a result's file is read and still exists.
TEST_F(Place, InputsThatTheResultDoesNotReplaceAreReadAndKept) {
    succeeded(run("result"));
    const std::string ground = read_text(path("result/dtm.tif"));
    fs::create_hard_link(path("result/dtm.tif"), path("second.tif"));
    succeeded(run("result", {"--overwrite", "--set", "terrain.dtm=second.tif"}));
    EXPECT_TRUE(read_text(path("second.tif")) == ground);
    succeeded(run("result", {"--overwrite"}));
}

// What could not be read or removed is reported, and still exists.
TEST_F(Place, AnOlderResultThatCannotBeRemovedIsReported) {
    for (const char* name : {"result", "result.partial", "result.partial/frames"}) {
        fs::create_directories(path(name));
        ASSERT_EQ(::chmod(path(name).c_str(), 0777), 0);
    }
    ASSERT_EQ(::chmod(path("").c_str(), 0777), 0);
    app::Manifest manifest;
    for (const std::string name : {"max_depth.tif", "frames/depth_0000.tif"}) {
        write("result.partial/" + name, "raster");
        manifest.files[name] = app::size_on_disk(path("result.partial/" + name));
    }
    app::write_manifest(path("result.partial"), manifest);
    app::note_replaced(path("result"));
    fs::rename(path("result/being_replaced.json"), path("result.partial/being_replaced.json"));
    ASSERT_EQ(::chmod(path("result.partial/frames").c_str(), 0755), 0);
    app::RunLog log(true);
    Warnings warnings;
    {
        const AsNobody nobody;
        if (!nobody.is()) GTEST_SKIP() << "only root can change the user";
        app::remove_partial(path("result"), {log, warnings});
    }
    const std::vector<std::string> told = texts_of(warnings);
    ASSERT_EQ(told.size(), 1U);
    EXPECT_NE(told[0].find("the rest is in " + path("result.partial")), std::string::npos) << told[0];
    for (const char* name : {"frames/depth_0000.tif", "manifest.json", "being_replaced.json"})
        EXPECT_TRUE(fs::exists(path(std::string("result.partial/") + name))) << name;
    app::remove_partial(path("result"), {log, warnings});
    EXPECT_FALSE(fs::exists(path("result.partial")));
}

}  // namespace
}  // namespace frana::test
