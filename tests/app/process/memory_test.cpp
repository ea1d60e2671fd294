// SPDX-License-Identifier: Apache-2.0
// The memory predicted by `frana check` is the peak memory of the run.
#include <sys/resource.h>

#include <filesystem>
#include <regex>

#include "app/process/machine_memory.h"
#include "support/tiny_scene.h"

namespace frana::test {
namespace {

// Numbers only, and all outputs.
const std::vector<std::string> k_numbers{"output.maps=off", "output.animation=off", "output.frames=off"},
    k_pictures{"output.maps=on", "output.animation=on", "time.frame-interval=0.5"};

struct MemoryCase {
    const char* name;
    bool structured;
    std::vector<std::string> output, keys;
};

class Memory : public TinyScene, public testing::WithParamInterface<MemoryCase> {
  protected:
    [[nodiscard]] std::vector<std::string> command(const std::string& name) const {
        std::vector<std::string> words{name, "scene.ini", "--threads", "2"};
        for (const auto* keys : {&GetParam().output, &GetParam().keys})
            for (const std::string& key : *keys) words.insert(words.end(), {"--set", key});
        return words;
    }
};

// "about 422 MB" [bytes]
double foreseen_bytes(const std::string& check) {
    std::smatch found;
    if (!std::regex_search(check, found, std::regex("memory of a run: about ([0-9.]+) (MB|GB)"))) return 0;
    return std::stod(found[1]) * (found[2] == "GB" ? 1e9 : 1e6);
}

TEST_P(Memory, IsPredictedAndRatherTooMuchThanTooLittle) {
    if (k_sanitized) GTEST_SKIP() << "a sanitizer takes memory of its own";
    if (GetParam().structured) {
        write("scene.ini",
              "[terrain]\ndtm = dtm.asc\n[release]\nperimeter = perimeter.geojson\nthickness = 2\n[material]\n"
              "model = structured\n[time]\nend = 0.1\n[numerics]\nparticles-per-cell = 9\n");
    }
    const Outcome check = succeeded(frana(command("check")));
    std::vector<std::string> run = command("run");
    run.insert(run.end(), {"--out", "result", "--quiet"});
    succeeded(frana(run));
    const double foreseen = foreseen_bytes(check.out),
                 taken = json_number(read_text(path("result/summary.json")), "peak_memory_bytes");
    RecordProperty("foreseen_MB", std::to_string(foreseen / 1e6));
    RecordProperty("taken_MB", std::to_string(taken / 1e6));
    // A twentieth: depends on versions of libraries and the system. A half: conditions that need not occur, a disk that
    // is slow to store frames, particles that all split.
    EXPECT_GE(foreseen, 0.95 * taken);
    EXPECT_LE(foreseen, 1.5 * taken);
}

INSTANTIATE_TEST_SUITE_P(
    , Memory,
    testing::Values(MemoryCase{"least", false, k_numbers, {}},
                    MemoryCase{"many_cells", false, k_numbers, {"terrain.cell-size=0.3", "time.end=0.1"}},
                    MemoryCase{"flow_on_a_small_part",
                               false,
                               k_numbers,
                               {"terrain.cell-size=0.15", "numerics.scheme=finite-volume", "time.end=0.1"}},
                    MemoryCase{"many_particles",
                               false,
                               k_numbers,
                               {"terrain.cell-size=0.4", "numerics.particles-per-cell=16", "time.end=0.05"}},
                    MemoryCase{"pictures", false, k_pictures, {"terrain.cell-size=1", "time.end=1"}},
                    MemoryCase{"large_map",
                               false,
                               {"output.maps=max_depth", "output.animation=off", "output.charts=off"},
                               {"output.map-size=4000x3500", "time.end=1"}},
                    MemoryCase{"large_maps_and_views",
                               false,
                               {"output.maps=max_depth, max_depth_3d", "output.animation=off"},
                               {"output.map-size=3000x2500", "time.end=1"}},
                    MemoryCase{
                        "many_steps",
                        false,
                        {"output.maps=max_depth", "output.animation=off", "output.frames=off"},
                        {"output.map-size=640x480", "numerics.cfl=0.02", "time.end=400", "time.stop-when-still=off"}},
                    MemoryCase{"frames_of_particles",
                               false,
                               {"output.maps=off", "output.animation=off"},
                               {"output.formats=particles-gpkg", "output.frames=on", "terrain.cell-size=0.5",
                                "numerics.particles-per-cell=16", "time.end=0.02", "time.frame-interval=0.01"}},
                    MemoryCase{"fluid", true, k_numbers, {"structured.phases=fluid", "terrain.cell-size=0.5"}},
                    MemoryCase{"solids",
                               true,
                               k_numbers,
                               {"structured.phases=solids-and-fluid", "structured.cohesion=2e3",
                                "structured.internal-friction-angle=28", "structured.bed-friction-angle=12",
                                "structured.young-modulus=1e6", "structured.bulk-modulus=1e6", "terrain.cell-size=1"}}),
    [](const auto& instance) { return std::string(instance.param.name); });

// The shell's limit replaces a machine of little memory: the program finds the limit itself, without --memory-limit.
class MemoryOfMachine : public TinyScene {
  protected:
    MemoryOfMachine() {
        ::getrlimit(RLIMIT_AS, &before_);
        const rlimit little{1'250'000'000, before_.rlim_max};
        ::setrlimit(RLIMIT_AS, &little);
    }
    ~MemoryOfMachine() override { ::setrlimit(RLIMIT_AS, &before_); }

  private:
    rlimit before_{};
};

TEST_F(MemoryOfMachine, RefusesTooLargeRunsBeforeAnythingIsComputed) {
    if (k_sanitized) GTEST_SKIP() << "a sanitizer reserves more addresses than that";
    write_scene(k_numbers_only);
    succeeded(frana({"run", "scene.ini", "--out", "result", "--set", "time.end=1"}));
    const auto before = files();
    const auto refused = [&](const std::vector<std::string>& words, const std::string& key) {
        refusal_of(frana(words), {std::string("of memory"), std::string("ulimit -v"), key});
    };
    for (const char* command : {"check", "run"}) {
        refused({command, "scene.ini", "--set", "output.maps=on", "--set", "output.map-size=8000x8000"},
                "output.map-size");
        refused({command, "scene.ini", "--set", "numerics.cfl=0.001", "--set", "terrain.cell-size=1", "--set",
                 "time.end=20000", "--set", "time.stop-when-still=off"},
                "terrain.cell-size");
    }
    refused({"render", "result", "--map", "max_depth", "--size", "8000x8000", "--out", "pictures"}, "--size");
    refused({"render", "result/max_depth.tif", "--size", "8000x8000", "--out", "pictures"}, "--size");
    refused({"compare", "result", "--scar", "perimeter.geojson", "--size", "8000x8000", "--out", "compared"}, "--size");
    EXPECT_EQ(files(), before);
    // More memory than available cannot be allowed.
    refused({"check", "scene.ini", "--set", "output.maps=on", "--set", "output.map-size=8000x8000", "--memory-limit",
             "9GB"},
            "--memory-limit 9GB is more than");
}

// Libraries wait for ever for a thread that the shell's limit does not allow. To be loaded they need 0.6 GB of
// addresses; with less the system's loader ends the program before it begins.
TEST_F(MemoryOfMachine, MayBeAlmostNone) {
    if (k_sanitized) GTEST_SKIP() << "a sanitizer reserves more addresses than that";
    write_scene();
    for (const rlim_t bytes : {700'000'000U, 1'000'000'000U}) {
        const rlimit least{bytes, RLIM_INFINITY};
        ASSERT_EQ(::setrlimit(RLIMIT_AS, &least), 0);
        const Outcome check = frana({"check", "scene.ini"});
        const Outcome run = frana({"run", "scene.ini", "--overwrite"});
        for (const Outcome* outcome : {&check, &run}) {
            EXPECT_TRUE(outcome->exit_code == 0 || outcome->err.find("ulimit -v") != std::string::npos)
                << bytes << ": " << outcome->exit_code << ": " << outcome->err;
        }
        EXPECT_TRUE(check.exit_code != 0 || run.exit_code == 0) << run.err;
    }
}

TEST_F(MemoryOfMachine, IsTheLeastOfFreeMemoryAndControlGroups) {
    write("proc/self/status", "Name:\tfrana\nVmSize:\t 900 kB\nVmRSS:\t 100 kB\n");
    write("proc/meminfo", "MemTotal: 9000000 kB\nMemAvailable:  1000000 kB\nSwapFree: 200000 kB\n");
    const auto bound = [&] { return app::machine_memory(folder_.string()); };
    EXPECT_EQ(bound().bytes, 1200100.0 * 1024);
    EXPECT_NE(bound().what.find("free"), std::string::npos);
    // Version 2: a group above this one limits it; files cached in memory are released.
    write("proc/self/cgroup", "0::/user/job\n");
    write("sys/fs/cgroup/user/memory.max", "700000000\n");
    write("sys/fs/cgroup/user/memory.current", "300000000\n");
    write("sys/fs/cgroup/user/memory.stat", "anon 1\ninactive_file 50000000\nactive_file 50000000\n");
    write("sys/fs/cgroup/user/job/memory.max", "max\n");
    EXPECT_EQ(bound().bytes, 500000000 + 102400);
    EXPECT_NE(bound().what.find("control group"), std::string::npos);
    // Version 1, in a container: the path is that of another, the root is its own.
    write("proc/self/cgroup", "5:cpu,memory:/docker/abc\n4:pids:/x\n");
    write("sys/fs/cgroup/memory/memory.limit_in_bytes", "400000000\n");
    write("sys/fs/cgroup/memory/memory.usage_in_bytes", "100000000\n");
    EXPECT_EQ(bound().bytes, 300000000 + 102400);
    write("sys/fs/cgroup/memory/memory.limit_in_bytes", "9223372036854771712\n");  // none
    EXPECT_EQ(bound().bytes, 1200100.0 * 1024);
}

}  // namespace
}  // namespace frana::test
