// SPDX-License-Identifier: Apache-2.0
// What a scene must not make frana do: exhaust the machine's memory, or write a result that another run is writing.
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "support/tiny_scene.h"

namespace frana::test {
namespace {

namespace fs = std::filesystem;

using Guard = TinyScene;

TEST_F(Guard, AbsurdValuesAreRefusedInOnePass) {
    const std::vector<std::string> values{"terrain.cell-size=1e-6",
                                          "terrain.bounds=nan 0 1 1",
                                          "release.thickness=nan",
                                          "release.volume=1e300",
                                          "release.velocity=inf",
                                          "material.density=-1e308",
                                          "material.turbulence=nan",
                                          "material.viscosity=1e308",
                                          "material.friction-angle=-inf",
                                          "numerics.cfl=inf",
                                          "numerics.particles-per-cell=99999999999999999999",
                                          "numerics.minimum-depth=1e-320",
                                          "time.end=1e308",
                                          "time.frame-interval=",
                                          "output.map-size=4000000000x4000000000"};
    const std::vector<std::string> arguments = with_sets({"run", "scene.ini"}, values);
    const std::vector<std::string> before = files();
    const Outcome outcome = refusal_of(frana(arguments));
    for (const std::string& value : values) {
        const std::string key = value.substr(0, value.find('='));
        EXPECT_NE(outcome.err.find("--set " + key + ": "), std::string::npos) << key << " in " << outcome.err;
    }
    // No allocation of that size was tried: the memory is that of the program with its libraries.
    if (!k_sanitized) {
        EXPECT_LT(outcome.peak_memory_bytes, 300e6);
    }
    EXPECT_EQ(files(), before);
}

/// Tries to lock the folder in which a run works.
bool locked(const fs::path& folder, int& descriptor) {
    descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY);
    return ::flock(descriptor, LOCK_EX | LOCK_NB) != 0;
}

TEST_F(Guard, TwoRunsDoNotWriteOneResult) {
    write_scene(k_numbers_only);
    const std::vector<std::string> run{"run", "scene.ini", "--out", "result", "--quiet", "--set", "time.end=0.1"};
    const fs::path aside = folder_ / "result.partial";
    fs::create_directory(aside);
    int descriptor = -1;
    ASSERT_FALSE(locked(aside, descriptor));
    const std::vector<std::string> before = files();
    refusal_of(frana(run), {"another run is writing this result now"});
    EXPECT_EQ(files(), before);
    // A killed run leaves its folder, not its lock.
    ::close(descriptor);
    succeeded(frana(run));
    EXPECT_TRUE(fs::exists(folder_ / "result" / "summary.json"));
}

TEST_F(Guard, ARunKeepsItsLockWhileItComputes) {
    write_scene("stop-when-still = off\nstop-change = 0\n[numerics]\nparticles-per-cell = 16\n" + k_numbers_only);
    Outcome outcome{};
    std::atomic<bool> ended = false;
    std::thread running([&] {
        outcome = frana({"run", "scene.ini", "--out", "result", "--quiet", "--set", "terrain.cell-size=2"});
        ended = true;
    });
    bool held = false;
    while (!held && !ended) {
        int descriptor = -1;
        held = fs::exists(path("result.partial")) && locked(path("result.partial"), descriptor) && descriptor >= 0;
        ::close(descriptor);
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    running.join();
    EXPECT_TRUE(held);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
}

}  // namespace
}  // namespace frana::test
