// SPDX-License-Identifier: Apache-2.0
// Modified checkpoints. First byte: f a file; h a file with size and checksum corrected, as if it had been written like
// that; v, p, s, w the state of a small run (see checkpoint_states.h), which is resumed from it. Then the changes, one
// after another: offset (4 bytes), number of bytes (1), the bytes; a number of 0 truncates at the offset.
#include <sys/mman.h>
#include <unistd.h>
#include <zlib.h>

#include <cstring>

#include "app/store/checkpoint_file.h"
#include "checkpoint_states.h"
#include "harness.h"
#include "simulation/simulation.h"

namespace {

using frana::fuzz::Bytes;

constexpr std::size_t k_before_size = 16, k_start = 24, k_sum = 4;

Bytes changed(Bytes bytes, frana::fuzz::Input changes) {
    while (changes.size >= 5 && !bytes.empty()) {
        std::uint32_t place = 0;
        std::memcpy(&place, changes.data, sizeof place);
        place %= static_cast<std::uint32_t>(bytes.size());
        std::size_t count = changes.data[4];
        changes.data += 5;
        changes.size -= 5;
        if (count == 0) {
            bytes.resize(place);
            continue;
        }
        count = std::min({count, changes.size, bytes.size() - place});
        if (count > 0) std::memcpy(bytes.data() + place, changes.data, count);
        changes.data += count;
        changes.size -= count;
    }
    return bytes;
}

void read_file(const Bytes& bytes) {
    static const int file = ::memfd_create("checkpoint", 0);
    if (::ftruncate(file, 0) != 0 ||
        ::pwrite(file, bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
        __builtin_trap();
    const frana::app::CheckpointFile checkpoint("/proc/self/fd/" + std::to_string(file));
}

void make_fit(Bytes& file) {
    if (file.size() < k_start + k_sum) return;
    const std::uint64_t size = file.size() - k_start - k_sum;
    const auto sum = static_cast<std::uint32_t>(::crc32_z(0, file.data() + k_start, size));
    std::memcpy(file.data() + k_before_size, &size, sizeof size);
    std::memcpy(file.data() + k_start + size, &sum, sizeof sum);
}

// An accepted state is computed with: some steps of it do no more harm than non-finite values.
void go_on(const frana::Scene& scene, const Bytes& state) {
    std::size_t place = 0;
    frana::StateReader reader(
        [&](void* to, std::size_t count) {
            if (count > 0) std::memcpy(to, state.data() + place, count);
            place += count;
        },
        state.size());
    int steps = 0;
    frana::RunOptions options;
    options.saved = &reader;
    options.on_progress = [&](const frana::Progress&) { ++steps; };
    options.stop_requested = [&] { return steps >= 3; };
    frana::run(scene, options);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace frana;
    const fuzz::Input input = fuzz::split(data, size);
    const bool unchanged = input.size < 5;
    bool done = false;
    fuzz::refused_or_done([&] {
        if (input.kind == 'f' || input.kind == 'h') {
            Bytes file = changed(fuzz::checkpoint_file(), input);
            if (input.kind == 'h') make_fit(file);
            read_file(file);
        } else if (const fuzz::SavedRun* const run = fuzz::saved_run(input.kind)) {
            go_on(run->scene, changed(run->state, input));
        }
        done = true;
    });
    if (unchanged && !done) __builtin_trap();
    return 0;
}
