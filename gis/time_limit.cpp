// SPDX-License-Identifier: Apache-2.0
#include "gis/time_limit.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "core/json.h"

namespace frana::gis {
namespace {

std::int64_t now() {
    using namespace std::chrono;
    return duration_cast<milliseconds>(steady_clock::now().time_since_epoch()).count();
}

/// Lives until the process ends: its thread may wait longer than main.
struct Watch {
    std::mutex guard;
    std::condition_variable changed;
    std::vector<const TimeLimit*> limits;
    std::int64_t limit_ms = 0;
    void (*end)(const Problem&) = nullptr;
    bool watching = false;
};

Watch& watch() {
    static auto* const one = new Watch;
    return *one;
}

void watch_over() {
    Watch& w = watch();
    std::unique_lock lock(w.guard);
    for (;;) {
        w.changed.wait(lock, [&] { return !w.limits.empty(); });
        const auto next = *std::min_element(w.limits.begin(), w.limits.end(), [](const auto* a, const auto* b) {
            return a->deadline() < b->deadline();
        });
        const std::int64_t left = next->deadline() - now();
        if (left > 0) {
            w.changed.wait_for(lock, std::chrono::milliseconds(left));
            continue;
        }
        w.end({"reading takes longer than a file may", next->where(), "",
               shortest_text(static_cast<double>(w.limit_ms) / 1000) + " s without an answer of the library",
               "Look into the file (a view that never ends?), copy it to this machine, or allow more with "
               "FRANA_READ_SECONDS"});
        return;
    }
}

}  // namespace

TimeLimit::TimeLimit(std::string where) : where_(std::move(where)) {
    Watch& w = watch();
    const std::lock_guard lock(w.guard);
    again();
    if (w.end == nullptr) return;
    w.limits.push_back(this);
    if (!std::exchange(w.watching, true)) std::thread(watch_over).detach();
    w.changed.notify_one();
}

TimeLimit::~TimeLimit() {
    Watch& w = watch();
    const std::lock_guard lock(w.guard);
    std::erase(w.limits, this);
    w.changed.notify_one();
}

void TimeLimit::again() noexcept {
    deadline_ = now() + watch().limit_ms;
}

void when_time_is_up(double seconds, void (*end)(const Problem&)) {
    Watch& w = watch();
    const std::lock_guard lock(w.guard);
    w.limit_ms = static_cast<std::int64_t>(1000 * seconds);
    w.end = end;
}

}  // namespace frana::gis
