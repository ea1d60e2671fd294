// SPDX-License-Identifier: Apache-2.0
// A disk that fails once, at any write: the raster is refused, or it is right. A process that is traced writes it,
// and one of its writes is answered with "no space left".
#include <gtest/gtest.h>
#include <sys/ptrace.h>
#include <sys/syscall.h>
#include <sys/user.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <functional>

#include "core/error.h"
#include "files.h"
#include "gis/raster_in.h"
#include "gis/raster_out.h"

namespace frana::gis {
namespace {

enum class End { written, refused, untouched, not_traced };

#if defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
// Lets another process work whose `failing`-th write fails; untouched: it made fewer.
End work_with_fault(int failing, const std::function<void()>& work) {
    const pid_t child = ::fork();
    if (child == 0) {
        if (::ptrace(PTRACE_TRACEME, 0, nullptr, nullptr) != 0) ::_exit(3);
        ::raise(SIGSTOP);
        try {
            work();
        } catch (const Error&) {
            ::_exit(1);
        }
        ::_exit(0);
    }
    int status = 0, seen = 0;
    bool entering = true, struck = false;
    for (::waitpid(child, &status, 0); !WIFEXITED(status) && !WIFSIGNALED(status); ::waitpid(child, &status, 0)) {
        if (WSTOPSIG(status) == SIGTRAP) {
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
End work_with_fault(int, const std::function<void()>&) {
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

TEST(ARaster, OfWhichOneWriteFailsIsRefusedOrRight) {
    const test::Folder folder;
    const std::string path = folder.file("a.tif");
    const Raster raster = waves();
    int refused = 0;
    for (int failing = 1; failing < 100; ++failing) {
        std::filesystem::remove(path);
        const End end = work_with_fault(failing, [&] { write_geotiff(path, raster, {"depth", "Depth", "m", {}}); });
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
