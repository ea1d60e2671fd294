// SPDX-License-Identifier: Apache-2.0
// Disks of every size: nothing fits, the frames do not fit, all but the last picture fits. Afterwards there is space
// again.
#include <sys/mount.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "trial_ground.h"
#include "trials.h"

namespace frana::test {
namespace {

namespace fs = std::filesystem;

/// A separate disk mounted under a folder during its lifetime.
class Disk {
  public:
    explicit Disk(std::string folder) : folder_(std::move(folder)) {}
    ~Disk() {
        if (mounted_) ::umount2(folder_.c_str(), MNT_DETACH);
    }
    Disk(const Disk&) = delete;
    Disk& operator=(const Disk&) = delete;

    bool mount(std::size_t kilobytes) {
        mounted_ = ::mount("tmpfs", folder_.c_str(), "tmpfs", 0, size(kilobytes).c_str()) == 0;
        return mounted_;
    }
    [[nodiscard]] bool grow(std::size_t kilobytes) const {
        return ::mount("tmpfs", folder_.c_str(), "tmpfs", MS_REMOUNT, size(kilobytes).c_str()) == 0;
    }

  private:
    static std::string size(std::size_t kilobytes) { return "size=" + std::to_string(kilobytes) + "k"; }

    std::string folder_;
    bool mounted_ = false;
};

class FullDisk : public TrialGround {
  protected:
    // Moves the content of out/ to a separate disk.
    [[nodiscard]] bool move_out_onto(Disk& disk, std::size_t kilobytes) const {
        fs::rename(at("out"), path("moved"));
        fs::create_directory(at("out"));
        const bool mounted = disk.mount(kilobytes);
        if (mounted) fs::copy(path("moved"), at("out"), fs::copy_options::recursive);
        fs::remove_all(path("moved"));
        return mounted;
    }
    static std::size_t kilobytes(const FolderState& state) {
        std::size_t pages = state.size();
        for (const auto& [path, content] : state) pages += content.size() / 4096 + 1;
        return 4 * pages;
    }
};

TEST_F(FullDisk, OfAnySizeLosesNothing) {
    {
        Disk disk(at("out"));
        if (!disk.mount(64)) GTEST_SKIP() << "a small disk can be mounted by root only: " << std::strerror(errno);
    }
    std::vector<TriedCommand> tried = commands();
    std::erase_if(tried, [](const TriedCommand& command) { return command.name == "check"; });
    RandomNumbers random(trial_seed(), 6);
    Trials trials;
    for (int k = 0; k < trial_count(2); ++k) {
        trials.begin("disks that fill");
        TriedCommand& command = tried[static_cast<std::size_t>(k) % tried.size()];
        measure(command);
        ASSERT_FALSE(HasFatalFailure());
        restore(command.begins_in);
        const std::size_t there = kilobytes(command.before), needed = kilobytes(command.after);
        const auto size =
            there + static_cast<std::size_t>(random.between(0, 0.7) * static_cast<double>(needed - there));
        SCOPED_TRACE("seed " + std::to_string(trial_seed()) + ", trial " + std::to_string(k) + ": " + command.name +
                     ", disk of " + std::to_string(size) + " kB, of which " + std::to_string(there) + " are taken");
        Disk disk(at("out"));
        ASSERT_TRUE(move_out_onto(disk, size));
        const Ending ending = run(Launch{command.arguments});
        expect_nothing_lost(command, ending);
        trials.ended(ending.exit_code);
        ASSERT_TRUE(disk.grow(256 << 10));
        if (ending.exit_code != 0) expect_repaired(command);
    }
}

}  // namespace
}  // namespace frana::test
