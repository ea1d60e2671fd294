// SPDX-License-Identifier: Apache-2.0
// A disk with one error, at any write: the raster is refused, or it is right. It is written by a traced process, one of
// whose writes fails with "no space left".
#include <gtest/gtest.h>
#include <sys/ptrace.h>
#include <sys/syscall.h>
#include <sys/user.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "core/error.h"
#include "gis/raster/raster_in.h"
#include "gis/raster/raster_out.h"
#include "support/files.h"

namespace frana::gis {
namespace {

constexpr const char* k_asked = "FRANA_TEST_RASTER";  // path for the other process

enum class End { written, refused, untouched, not_traced };

#if defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
// Runs another process that writes the raster, of which the `failing`-th write fails; untouched: it made fewer. It is
// started anew: GDAL's threads do not survive a fork.
End write_with_error(int failing, const std::string& path) {
    const pid_t child = ::fork();
    if (child == 0) {
        ::setenv(k_asked, path.c_str(), 1);
        if (::ptrace(PTRACE_TRACEME, 0, nullptr, nullptr) != 0) ::_exit(3);
        ::raise(SIGSTOP);
        ::execl("/proc/self/exe", "gis_tests", "--gtest_filter=ARaster.IsWrittenToTheGivenPath", nullptr);
        ::_exit(3);
    }
    int status = 0, seen = 0;
    bool entering = true, struck = false;
    ::waitpid(child, &status, 0);
    if (WIFSTOPPED(status)) ::ptrace(PTRACE_SETOPTIONS, child, nullptr, PTRACE_O_TRACESYSGOOD | PTRACE_O_TRACEEXEC);
    for (; !WIFEXITED(status) && !WIFSIGNALED(status); ::waitpid(child, &status, 0)) {
        if (WSTOPSIG(status) == (SIGTRAP | 0x80)) {
            user_regs_struct registers{};
            ::ptrace(PTRACE_GETREGS, child, nullptr, &registers);
            const auto call = registers.orig_rax;
            if (entering && (call == SYS_write || call == SYS_pwrite64 || call == SYS_writev) && registers.rdi > 2 &&
                ++seen == failing) {
                registers.orig_rax = ~0ULL;  // no such call
                ::ptrace(PTRACE_SETREGS, child, nullptr, &registers);
                struck = true;
            } else if (!entering && struck && seen == failing) {
                ++seen;
                registers.rax = static_cast<unsigned long long>(-ENOSPC);
                ::ptrace(PTRACE_SETREGS, child, nullptr, &registers);
            }
            entering = !entering;
        }
        ::ptrace(PTRACE_SYSCALL, child, nullptr, nullptr);
    }
    if (!WIFEXITED(status) || WEXITSTATUS(status) == 3) return End::not_traced;
    if (WEXITSTATUS(status) == 1) return End::refused;
    return struck ? End::written : End::untouched;
}
#else
End write_with_error(int, const std::string&) {
    return End::not_traced;
}
#endif

Raster waves() {
    Raster raster(GridSpec{1000, 2000, 5, 300, 300, ""}, 0);
    for (std::int64_t row = 0; row < raster.grid.rows; ++row)
        for (std::int64_t column = 0; column < raster.grid.columns; ++column)
            raster.at(row, column) = 1 + std::sin(0.01 * static_cast<double>(row * column % 977));
    return raster;
}

TEST(ARaster, IsWrittenToTheGivenPath) {
    const test::Folder folder;
    const char* asked = std::getenv(k_asked);
    const std::string path = asked != nullptr ? asked : folder.file("a.tif");
    try {
        write_geotiff(path, waves(), {"depth", "Depth", "m", {}});
    } catch (const Error&) {
        if (asked == nullptr) throw;
        std::_Exit(1);
    }
    if (asked != nullptr) std::_Exit(0);
    EXPECT_EQ(read_result_raster(path).values.size(), waves().values.size());
}

TEST(ARaster, OfWhichOneWriteFailsIsRefusedOrRight) {
    const test::Folder folder;
    const std::string path = folder.file("a.tif");
    const Raster raster = waves();
    int refused = 0;
    for (int failing = 1; failing < 100; ++failing) {
        std::filesystem::remove(path);
        const End end = write_with_error(failing, path);
        if (end == End::not_traced) GTEST_SKIP() << "no process can be traced here";
        if (end == End::refused) {
            ++refused;
            EXPECT_FALSE(std::filesystem::exists(path)) << failing;
            continue;
        }
        ASSERT_NO_THROW(read_result_raster(path)) << "write " << failing;
        const Raster back = read_result_raster(path);
        std::size_t wrong = 0;
        for (std::size_t i = 0; i < raster.values.size(); ++i)
            if (static_cast<float>(back.values[i]) != static_cast<float>(raster.values[i])) ++wrong;
        EXPECT_EQ(wrong, 0U) << "write " << failing;
        if (end == End::untouched) break;
    }
    EXPECT_GT(refused, 0) << "no write failed: the test tests nothing";
}

}  // namespace
}  // namespace frana::gis
