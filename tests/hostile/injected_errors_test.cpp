// SPDX-License-Identifier: Apache-2.0
// System calls that fail: the disk is full, broken or read-only at the n-th write, rename or fsync, a file cannot be
// opened or read, a write stores only half.
#include <cerrno>
#include <cstring>

#include "trial_ground.h"
#include "trials.h"

namespace frana::test {
namespace {

struct ErrorToInject {
    Answer answer;
    bool lasting = false;  ///< every later call of the name fails too

    [[nodiscard]] std::string text() const {
        const std::string what = answer.kind == Answer::Kind::shorten ? "half of it" : std::strerror(answer.number);
        return what + (lasting ? ", from then on" : ", once");
    }
};

std::vector<int> errors_of(const std::string& name) {
    if (name == "openat") return {EACCES, EIO, EMFILE, ENOSPC};
    if (name == "read" || name == "pread64" || name == "getdents64") return {EIO, EINTR};
    if (name == "write" || name == "pwrite64" || name == "writev") return {ENOSPC, EIO, EINTR};
    if (name.rfind("rename", 0) == 0) return {EIO, EACCES, ENOSPC, EXDEV, EINVAL};
    if (name.rfind("link", 0) == 0) return {EPERM, EMLINK, EIO};
    if (name.rfind("mkdir", 0) == 0) return {ENOSPC, EACCES};
    if (name == "mmap") return {ENOMEM};
    if (name == "fallocate") return {ENOSPC, EOPNOTSUPP};
    return {EIO, EACCES};
}

class InjectedError : public TrialGround {
  protected:
    void SetUp() override {
        if (!can_watch_calls()) GTEST_SKIP() << "this system does not let a program's calls be watched (seccomp)";
    }

    [[nodiscard]] ErrorToInject error_for(const SystemCall& call) {
        const std::vector<int> errors = errors_of(call.name);
        const bool write = call.name == "write" || call.name == "pwrite64";
        if (write && random_.once_in(4)) return {{Answer::Kind::shorten}, false};
        const int error = errors[random_.below(errors.size())];
        return {{Answer::Kind::fail, error}, error != EINTR && random_.once_in(2)};  // interruptions are temporary
    }

    /// Returns a call that changes the disk, reads it, or allocates memory, in turn.
    [[nodiscard]] SystemCall call_of(const TriedCommand& command, int turn) {
        std::vector<SystemCall> calls;
        for (const SystemCall& call : command.calls)
            if (group_of(call) == turn % 3) calls.push_back(call);
        return random_call(calls.empty() ? command.calls : calls, random_);
    }
    /// 0 to 2: changes, reads, memory. Most files are opened for reading.
    static int group_of(const SystemCall& call) {
        if (call.name == "mmap") return 2;
        return call.name.find("read") != std::string::npos || call.name == "getdents64" || call.name == "openat";
    }

    void attempt(const TriedCommand& command, const SystemCall& where, const ErrorToInject& injected, Trials& trials) {
        restore(command.begins_in);
        bool met = false;
        // GDAL reads an ASCII grid without end if the disk fails permanently: frana's own limit ends that.
        Launch launch{command.arguments, {"FRANA_READ_SECONDS=30"}};
        const bool memory = where.name == "mmap";
        if (memory) launch.patience_seconds = 20;
        const Ending ending = run(launch, k_watch, [&](const SystemCall& call) {
            const bool here = call == where;
            met = met || here;
            return here || (injected.lasting && met && call.name == where.name) ? injected.answer : Answer{};
        });
        if (ending.err.find("error while loading shared libraries") != std::string::npos)
            return;  // frana has not begun
        // A folder that cannot be listed cannot be removed either.
        const bool removal = where.name.rfind("unlink", 0) == 0 || where.name == "rmdir" || where.name == "getdents64";
        trials.ended(ending.exit_code);
        expect_nothing_lost(command, ending,
                            memory    ? Disturbance::memory
                            : removal ? Disturbance::removal
                                      : Disturbance::error);
        if (ending.exit_code != 0 || removal || random_.once_in(4)) expect_repaired(command);
    }

    static constexpr Watch k_watch{true, true, true};
    RandomNumbers random_{trial_seed(), 1};
};

TEST_F(InjectedError, LosesNothingAndChangesNoResult) {
    std::vector<TriedCommand> tried = commands();
    Trials trials;
    for (int k = 0; k < trial_count(8); ++k) {
        TriedCommand& command = tried[random_.below(tried.size())];
        measure(command, k_watch);
        if (HasFatalFailure()) return;
        const SystemCall call = call_of(command, k);
        const ErrorToInject injected = error_for(call);
        static constexpr const char* k_kinds[] = {"errors while writing", "errors while reading", "memory refused"};
        trials.begin(k_kinds[group_of(call)]);
        SCOPED_TRACE("seed " + std::to_string(trial_seed()) + ", trial " + std::to_string(k) + ": " + command.name +
                     ", " + call.text() + ": " + injected.text());
        attempt(command, call, injected, trials);
    }
}

}  // namespace
}  // namespace frana::test
