// SPDX-License-Identifier: Apache-2.0
#include "watched_calls.h"

#include <fcntl.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cstddef>
#include <vector>

namespace frana::test {
namespace {

enum class Group { changes, reads, memory };
using Kind = CallPlace::Kind;

struct Row {
    int number;
    const char* name;
    Group group;
    CallPlace place;
};

// openat counts as a change if it may create or write: see the filter.
constexpr Row k_calls[] = {
    {SYS_openat, "openat", Group::changes, {Kind::path, 1, 0}},
    {SYS_write, "write", Group::changes, {Kind::descriptor, 0}},
    {SYS_pwrite64, "pwrite64", Group::changes, {Kind::descriptor, 0}},
    {SYS_writev, "writev", Group::changes, {Kind::descriptor, 0}},
    {SYS_renameat2, "renameat2", Group::changes, {Kind::path, 3, 2}},
    {SYS_linkat, "linkat", Group::changes, {Kind::path, 3, 2}},
    {SYS_symlinkat, "symlinkat", Group::changes, {Kind::path, 2, 1}},
    {SYS_unlinkat, "unlinkat", Group::changes, {Kind::path, 1, 0}},
    {SYS_mkdirat, "mkdirat", Group::changes, {Kind::path, 1, 0}},
    {SYS_fchmodat, "fchmodat", Group::changes, {Kind::path, 1, 0}},
    {SYS_fsync, "fsync", Group::changes, {Kind::descriptor, 0}},
    {SYS_fdatasync, "fdatasync", Group::changes, {Kind::descriptor, 0}},
    {SYS_ftruncate, "ftruncate", Group::changes, {Kind::descriptor, 0}},
    {SYS_fallocate, "fallocate", Group::changes, {Kind::descriptor, 0}},
    {SYS_copy_file_range, "copy_file_range", Group::changes, {Kind::descriptor, 2}},
    {SYS_sendfile, "sendfile", Group::changes, {Kind::descriptor, 0}},
#ifdef SYS_open  // newer machines have only the calls relative to a folder
    {SYS_rename, "rename", Group::changes, {Kind::path, 1}},
    {SYS_link, "link", Group::changes, {Kind::path, 1}},
    {SYS_symlink, "symlink", Group::changes, {Kind::path, 1}},
    {SYS_unlink, "unlink", Group::changes, {Kind::path, 0}},
    {SYS_rmdir, "rmdir", Group::changes, {Kind::path, 0}},
    {SYS_mkdir, "mkdir", Group::changes, {Kind::path, 0}},
    {SYS_chmod, "chmod", Group::changes, {Kind::path, 0}},
#endif
#ifdef SYS_renameat
    {SYS_renameat, "renameat", Group::changes, {Kind::path, 3, 2}},
#endif
    {SYS_read, "read", Group::reads, {Kind::descriptor, 0}},
    {SYS_pread64, "pread64", Group::reads, {Kind::descriptor, 0}},
    {SYS_getdents64, "getdents64", Group::reads, {Kind::descriptor, 0}},
    {SYS_mmap, "mmap", Group::memory, {Kind::memory}},
};

constexpr std::uint32_t k_large = 128 << 10;

constexpr std::uint32_t argument(int index) {
    return static_cast<std::uint32_t>(offsetof(seccomp_data, args)) + 8 * static_cast<std::uint32_t>(index);
}

class Filter {
  public:
    explicit Filter(const Watch& watch) {
        load(offsetof(seccomp_data, nr));
        for (const Row& row : k_calls) {
            if (row.number == SYS_openat) {
                add_open(watch);
            } else if (row.group == Group::memory && watch.memory) {
                add_map();
            } else if ((row.group == Group::changes && watch.changes) || (row.group == Group::reads && watch.reads)) {
                code_.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, static_cast<std::uint32_t>(row.number), 0, 1));
                end(SECCOMP_RET_USER_NOTIF);
            }
        }
        end(SECCOMP_RET_ALLOW);
    }
    [[nodiscard]] sock_fprog program() { return {static_cast<unsigned short>(code_.size()), code_.data()}; }

  private:
    void load(std::size_t place) {
        code_.push_back(BPF_STMT(BPF_LD | BPF_W | BPF_ABS, static_cast<std::uint32_t>(place)));
    }
    void end(std::uint32_t action) { code_.push_back(BPF_STMT(BPF_RET | BPF_K, action)); }

    // Opening for reading is a read, else a change.
    void add_open(const Watch& watch) {
        const std::uint32_t writes = O_WRONLY | O_RDWR | O_CREAT | O_TRUNC;
        code_.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_openat, 0, 4));
        load(argument(2));
        code_.push_back(BPF_JUMP(BPF_JMP | BPF_JSET | BPF_K, writes, 0, 1));
        end(watch.changes ? SECCOMP_RET_USER_NOTIF : SECCOMP_RET_ALLOW);
        end(watch.reads ? SECCOMP_RET_USER_NOTIF : SECCOMP_RET_ALLOW);
    }
    // Programs and libraries are mapped as files; threads' stacks count.
    void add_map() {
        code_.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_mmap, 0, 6));
        load(argument(3));
        code_.push_back(BPF_JUMP(BPF_JMP | BPF_JSET | BPF_K, MAP_ANONYMOUS, 0, 3));
        load(argument(1));
        code_.push_back(BPF_JUMP(BPF_JMP | BPF_JGE | BPF_K, k_large, 0, 1));
        end(SECCOMP_RET_USER_NOTIF);
        end(SECCOMP_RET_ALLOW);
    }

    std::vector<sock_filter> code_;
};

const Row* row_of(int number) {
    for (const Row& row : k_calls)
        if (row.number == number) return &row;
    return nullptr;
}

}  // namespace

int watch_own_calls(const Watch& watch) {
    if (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) return -1;
    Filter filter(watch);
    sock_fprog program = filter.program();
    return static_cast<int>(
        ::syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, SECCOMP_FILTER_FLAG_NEW_LISTENER, &program));
}

std::string call_name(int number) {
    const Row* row = row_of(number);
    return row == nullptr ? "" : row->name;
}

CallPlace call_place(int number) {
    const Row* row = row_of(number);
    return row == nullptr ? CallPlace{} : row->place;
}

}  // namespace frana::test
