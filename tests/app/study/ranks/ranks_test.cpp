// SPDX-License-Identifier: Apache-2.0
// Studies under mpirun. As root, and with more ranks than processors, Open MPI must be told that this is meant.
#include <sys/mount.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>

#include "study/tiny_study.h"

namespace frana::test {
namespace {

namespace fs = std::filesystem;

bool in_path(const std::string& program) {
    return std::system(("command -v " + program + " >/dev/null 2>&1").c_str()) == 0;
}

class Ranks : public Ensemble {
  protected:
    void SetUp() override {
        if (!in_path("mpirun")) GTEST_SKIP() << "mpirun is not installed (openmpi-bin)";
        for (const char* name : {"OMPI_ALLOW_RUN_AS_ROOT", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM",
                                 "OMPI_MCA_rmaps_base_oversubscribe", "PRTE_MCA_rmaps_default_mapping_policy"})
            ::setenv(name, name[0] == 'P' ? ":oversubscribe" : "1", 1);
        ::setenv("OMPI_MCA_btl_vader_single_copy_mechanism", "none", 1);  // containers forbid it
        ::setenv("OMPI_MCA_hwloc_base_binding_policy", "none", 1);
    }
    [[nodiscard]] static std::vector<std::string> under_mpirun(int ranks, const std::vector<std::string>& arguments) {
        return with_more({"-n", std::to_string(ranks), FRANA_PROGRAM}, arguments);
    }
    [[nodiscard]] Outcome mpirun(int ranks, const std::vector<std::string>& arguments) const {
        StartedProgram program(folder_.string(), under_mpirun(ranks, arguments), "mpirun");
        return program.wait();
    }
    /// Processes of the program that work in this test's folder, by rank.
    [[nodiscard]] std::map<int, pid_t> ranks_here() const {
        std::map<int, pid_t> found;
        for (const fs::directory_entry& entry : fs::directory_iterator("/proc")) {
            std::error_code error;
            const fs::path cwd = fs::read_symlink(entry.path() / "cwd", error);
            if (error || cwd != fs::canonical(folder_)) continue;
            const std::string environment = read_text((entry.path() / "environ").string());
            const std::string name = std::string("\0", 1) + "OMPI_COMM_WORLD_RANK=";
            const auto at = environment.find(name);
            if (at == std::string::npos) continue;
            found[std::atoi(environment.c_str() + at + name.size())] = std::atoi(entry.path().filename().c_str());
        }
        return found;
    }
};

// A region's slopes are given to ranks like members.
TEST_F(Ranks, RegionsHaveTheSameBitsToo) {
    std::vector<TestFeature> slopes;
    for (const int south : {20, 60, 100}) slopes.push_back({"Polygon", box(20, south, 45, south + 25)});
    write_features("perimeter", slopes);
    write("region.ini", "[region]\nscene = scene.ini\nscheme = finite-volume\n");
    succeeded(frana({"batch", "region.ini", "--out", "alone", "--threads", "1", "--quiet"}));
    succeeded(mpirun(2, {"batch", "region.ini", "--out", "ranks", "--quiet"}));
    EXPECT_EQ(members("ranks").size(), 3U);
    for (const std::string name : {"union_max_depth.tif", "union_max_pressure.tif", "worst_source.tif"})
        EXPECT_TRUE(read_text(path("alone/" + name)) == read_text(path("ranks/" + name))) << name;
    const auto check = [&](const std::string& of) {
        return parse_json(read_text(path(of + "/summary.json")))["scheme_check"];
    };
    EXPECT_FALSE(check("alone")["members"].empty()) << check("alone");
    EXPECT_EQ(check("alone"), check("ranks"));
}

// The sample's slopes and draws on large cells, also after the death of a rank.
TEST_F(Ranks, AFrequencyOfARegionHasTheSameBitsToo) {
    std::string text = read_text(FRANA_SOURCE_DIR "/sample_data/fan/frequency.ini");
    const auto replace = [&](const std::string& old, const std::string& by) {
        ASSERT_NE(text.find(old), std::string::npos) << old;
        text.replace(text.find(old), old.size(), by);
    };
    replace("scene.ini", FRANA_SOURCE_DIR "/sample_data/fan/scene.ini");
    replace("samples = 64", "samples = 16");
    replace("cell-size = 10", "cell-size = 30\ntime.end = 60\noutput.maps = off");
    write("fan.ini", text);
    const std::vector<std::string> command{"batch", "fan.ini", "--quiet", "--out"};
    const auto with = [&](const std::vector<std::string>& more) { return with_more(command, more); };
    for (const std::string threads : {"1", "2"}) {
        succeeded(frana(with({"alone" + threads, "--threads", threads})));
    }
    {
        // The job waits for rank 1 at its end: while that is stopped, rank 0 can be killed however fast the machine is.
        StartedProgram job(folder_.string(), under_mpirun(2, with({"out"})), "mpirun");
        ASSERT_TRUE(job.wait_until([&] { return fs::exists(path("out.partial")); }));
        const auto ranks = ranks_here();
        ASSERT_EQ(ranks.size(), 2U);
        ASSERT_EQ(::kill(ranks.at(1), SIGSTOP), 0);
        ASSERT_TRUE(job.wait_until([&] { return records().size() >= 8; }));
        ASSERT_EQ(::kill(ranks.at(0), SIGKILL), 0);
        ::kill(ranks.at(1), SIGCONT);
        EXPECT_NE(job.wait().exit_code, 0);
    }
    succeeded(mpirun(2, with({"out", "--resume"})));
    EXPECT_EQ(members("out").size(), 32U);
    for (const std::string other : {"alone2", "out"})
        for (const std::string name : {"annual_rate_depth_0.5.tif", "max_depth_T100.tif", "hazard_curves.csv",
                                       "disaggregation.csv", "exposure.csv"})
            EXPECT_TRUE(read_text(path("alone1/" + name)) == read_text(path(other + "/" + name)))
                << other << "/" << name;
}

TEST_F(Ranks, SameBitsForAnyNumberOfRanks) {
    write_study("samples = 12\nkeep = all\n", k_two_keys);
    succeeded(frana({"ensemble", "study.ini", "--out", "alone", "--threads", "1", "--quiet"}));
    for (const int ranks : {1, 3}) {
        succeeded(mpirun(ranks, {"ensemble", "study.ini", "--out", "out" + std::to_string(ranks), "--threads", "2"}));
        expect_same("alone", "out" + std::to_string(ranks));
        EXPECT_EQ(json_number(read_text(path("out" + std::to_string(ranks) + "/summary.json")), "threads"), 2 * ranks);
    }
}

TEST_F(Ranks, UntilStopsAtTheSameMember) {
    write_study("samples = 400\nuntil = 0.07\n", k_two_keys);
    succeeded(mpirun(3, {"ensemble", "study.ini", "--out", "out", "--quiet"}));
    EXPECT_EQ(members().size(), 64U);
}

// N programs fought for one lock.
TEST_F(Ranks, ACalibrationSharesItsRuns) {
    ran("truth", {"time.end=12"});
    write("slope.ini", read_text(path("scene.ini")) + "[observed]\nperimeter = truth/extent.gpkg|layer=trace\n");
    write("study.ini", "[study]\nscene = slope.ini\nsamples = 16\n[set]\ntime.end = 12\n" +
                           std::string("[objective]\njaccard = 1\n") + k_two_keys);
    succeeded(frana({"calibrate", "study.ini", "--out", "alone", "--threads", "1", "--quiet"}));
    succeeded(mpirun(3, {"calibrate", "study.ini", "--out", "ranks"}));
    EXPECT_EQ(json_number(read_text(path("ranks/summary.json")), "threads"), 3);
    EXPECT_EQ(read_text(path("ranks/calibration.json")), read_text(path("alone/calibration.json")));
    EXPECT_EQ(read_text(path("ranks/best.ini")), read_text(path("alone/best.ini")));
}

// The first alone goes on; each of the others says that it does nothing.
TEST_F(Ranks, ARunIsComputedByOneProcess) {
    const Outcome outcome = succeeded(mpirun(3, {"run", "scene.ini", "--out", "out", "--set", "time.end=3"}));
    EXPECT_TRUE(fs::exists(path("out/summary.json")));
    expect_words(outcome.err, {"rank 0 of 3 continues alone", "rank 1 of 3 does nothing", "rank 2 of 3 does nothing"});
}

// The death of any rank ends the job; nothing that was finished is lost.
TEST_F(Ranks, ResumesAfterTheDeathOfARank) {
    write_study("samples = 120\n", k_two_keys);
    succeeded(frana({"ensemble", "study.ini", "--out", "whole", "--quiet"}));
    std::size_t kept = 0;
    for (const int victim : {0, 2}) {  // rank 0 works on until it is told of the death of another
        StartedProgram job(folder_.string(),
                           under_mpirun(3, {"ensemble", "study.ini", "--out", "out", "--quiet", "--resume"}), "mpirun");
        ASSERT_TRUE(job.wait_until([&] { return records().size() >= kept + 4; }));
        const auto ranks = ranks_here();
        ASSERT_EQ(ranks.size(), 3U);
        ASSERT_EQ(::kill(ranks.at(victim), SIGKILL), 0);
        EXPECT_NE(job.wait().exit_code, 0);
        EXPECT_FALSE(fs::exists(path("out")));
        EXPECT_GE(records().size(), kept + 4);
        kept = records().size();
    }
    succeeded(mpirun(2, {"ensemble", "study.ini", "--out", "out", "--resume"}));
    expect_same("whole", "out");
}

// A disk that holds a third of the records: what was finished is kept, and is not computed again.
TEST_F(Ranks, ResumesAfterAFullDisk) {
    write_study("samples = 60\n", k_two_keys);
    // As deep as the other: study.ini names files as seen from the result.
    succeeded(frana({"ensemble", "study.ini", "--out", "folder/whole", "--quiet"}));
    const std::string disk = path("disk");
    fs::create_directory(disk);
    if (::mount("tmpfs", disk.c_str(), "tmpfs", 0, "size=160k") != 0)
        GTEST_SKIP() << "a small disk can be mounted by root only: " << std::strerror(errno);
    const std::vector<std::string> command{"ensemble", "study.ini", "--out", "disk/out", "--resume"};
    for (const int ranks : {1, 3}) {
        const Outcome full = ranks == 1 ? frana(command) : mpirun(ranks, command);
        EXPECT_EQ(full.exit_code, 4) << full.err;
        EXPECT_NE(full.err.find("No space left on device"), std::string::npos) << full.err;
        EXPECT_GE(records().size(), 5U);
        EXPECT_LT(records().size(), 60U);
    }
    const std::size_t kept = records().size();
    ASSERT_EQ(::mount("tmpfs", disk.c_str(), "tmpfs", MS_REMOUNT, "size=64m"), 0);
    const Outcome resumed = mpirun(3, command);
    EXPECT_EQ(resumed.exit_code, 0) << resumed.err;
    if (resumed.exit_code == 0) {
        expect_same("folder/whole", "disk/out");
        EXPECT_NE(read_text(path("disk/out/log.txt")).find("computed " + std::to_string(60 - kept) + " members"),
                  std::string::npos);
    }
    ::umount2(disk.c_str(), MNT_DETACH);
}

TEST_F(Ranks, ASignalStopsAllInOrder) {
    // More than are done before the signal comes, however busy the machine is.
    write_study("samples = 1000\n", k_two_keys);
    StartedProgram job(folder_.string(), under_mpirun(3, {"ensemble", "study.ini", "--out", "out"}), "mpirun");
    ASSERT_TRUE(job.wait_until([&] { return records().size() >= 3; }));
    const auto ranks = ranks_here();
    ASSERT_EQ(ranks.size(), 3U);
    ASSERT_EQ(::kill(ranks.at(1), SIGTERM), 0);
    const Outcome stopped = job.wait();
    EXPECT_EQ(stopped.exit_code, 128 + SIGTERM) << stopped.err;
    EXPECT_NE(stopped.err.find("--resume runs the others"), std::string::npos) << stopped.err;
}

TEST_F(Ranks, ProblemsAreReportedOnceByRank0) {
    write_study("samples = 0\n", k_two_keys);
    const Outcome outcome = refusal_of(mpirun(3, {"ensemble", "study.ini", "--out", "out"}));
    const auto first = outcome.err.find("study.samples");
    ASSERT_NE(first, std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.err.find("study.samples", first + 1), std::string::npos) << outcome.err;
    EXPECT_FALSE(fs::exists(path("out")));
}

// A file that one machine sees otherwise than another would mix two studies. Rank 1 starts in a folder of its own.
TEST_F(Ranks, AnotherStudyOnAnotherMachineIsRefused) {
    write_study("samples = 1000\n", k_two_keys);  // rank 0 alone must not be done before rank 1 has begun
    fs::create_directories(path("elsewhere"));
    for (const std::string name : {"scene.ini", "study.ini", "dtm.asc", "dtm.prj", "perimeter.geojson"})
        if (fs::exists(path(name))) fs::copy_file(path(name), path("elsewhere/" + name));
    write("elsewhere/study.ini", "[study]\nscene = scene.ini\nsamples = 1000\nseed = 2\n" + k_two_keys);
    const std::vector<std::string> command{FRANA_PROGRAM, "ensemble", "study.ini", "--out", path("out")};
    const std::vector<std::string> elsewhere =
        with_more({"-n", "1"}, with_more(command, {":", "-n", "1", "-wdir", path("elsewhere")}));
    StartedProgram job(folder_.string(), with_more(elsewhere, command), "mpirun");
    refusal_of(job.wait(), {"rank 1 on ", "other data than rank 0"});
}

// As after `srun -n 3` without --mpi: three programs would write the same result.
TEST_F(Ranks, ProcessesWithoutMessagesAreRefused) {
    write_study("samples = 4\n", k_two_keys);
    ::setenv("SLURM_STEP_NUM_TASKS", "3", 1);
    const Outcome outcome = run();
    ::unsetenv("SLURM_STEP_NUM_TASKS");
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_NE(outcome.err.find("--mpi=pmix"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace frana::test
