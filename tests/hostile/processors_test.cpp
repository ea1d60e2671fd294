// SPDX-License-Identifier: Apache-2.0
// The same bytes on one processor and on several, with any number of threads, whatever thread settings libraries get,
// and on a busy machine.
#include <atomic>
#include <thread>

#include "trial_ground.h"
#include "trials.h"

namespace frana::test {
namespace {

/// Keeps processors busy during its lifetime.
class BusyMachine {
  public:
    explicit BusyMachine(int threads) {
        for (int k = 0; k < threads; ++k)
            threads_.emplace_back([this] {
                while (!enough_) ++work_;
            });
    }
    ~BusyMachine() {
        enough_ = true;
        for (std::thread& thread : threads_) thread.join();
    }
    BusyMachine(const BusyMachine&) = delete;
    BusyMachine& operator=(const BusyMachine&) = delete;

  private:
    std::atomic<bool> enough_ = false;
    std::atomic<long> work_ = 0;
    std::vector<std::thread> threads_;
};

class Processors : public TrialGround {};

TEST_F(Processors, DoNotChangeAByteOfAnyFile) {
    const std::vector<std::string> command{
        "run",   "in/scene.ini",    "--out", "out/r", "--quiet", "--set", "output.map-formats=png,pdf,svg",
        "--set", "output.charts=on"};
    succeeded(run(Launch{command}));
    const FolderState expected = state();
    RandomNumbers random(trial_seed(), 5);
    Trials trials;
    for (int k = 0; k < trial_count(2); ++k) {
        trials.begin("other processors and threads");
        restore("inputs");
        static constexpr const char* k_threads[] = {"1", "2", "3", "7"};
        Launch launch{command};
        const std::string threads = k_threads[random.below(std::size(k_threads))];
        launch.arguments.insert(launch.arguments.end(), {"--threads", threads});
        launch.processors = random.once_in(2) ? 1 : 0;
        const std::string other = random.once_in(2) ? "1" : "5";
        for (const char* name : {"OMP_NUM_THREADS=", "GDAL_NUM_THREADS=", "VTK_SMP_MAX_THREADS="})
            if (random.once_in(2)) launch.environment.push_back(name + other);
        const int load = random.once_in(2) ? 4 : 0;
        std::string what = "--threads " + threads + ", processors " + std::to_string(launch.processors) + ", load " +
                           std::to_string(load);
        for (const std::string& variable : launch.environment) what += ", " + variable;
        SCOPED_TRACE("seed " + std::to_string(trial_seed()) + ", trial " + std::to_string(k) + ": " + what);
        const BusyMachine busy(load);
        const Ending ending = run(launch);
        trials.ended(ending.exit_code);
        EXPECT_EQ(ending.exit_code, 0) << ending.err;
        EXPECT_EQ(in_lines(differences(expected, state())), "");
    }
}

}  // namespace
}  // namespace frana::test
