// SPDX-License-Identifier: Apache-2.0
#include "gis/access/time_limit.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "core/shortest_text.h"

namespace frana::gis {
namespace {

constexpr std::int64_t k_first_report_ms = 3000, k_report_interval_ms = 10000;

std::int64_t now() {
    using namespace std::chrono;
    return duration_cast<milliseconds>(steady_clock::now().time_since_epoch()).count();
}

/// Exists until the process ends: its thread may wait longer than main.
struct Watch {
    std::mutex guard;
    std::condition_variable changed;
    std::vector<const TimeLimit*> limits;
    std::int64_t limit_ms = 0;
    void (*end)(const Problem&) = nullptr;
    void (*warn)(const std::string&, double) = nullptr;
    bool watching = false;
};

Watch& watch() {
    static auto* const one = new Watch;
    return *one;
}

void watch_over() {
    Watch& w = watch();
    std::unique_lock lock(w.guard);
    std::int64_t reported = 0, next_report = 0;
    for (;;) {
        w.changed.wait(lock, [&] { return !w.limits.empty(); });
        const auto next = *std::min_element(w.limits.begin(), w.limits.end(),
                                            [](const auto* a, const auto* b) { return a->deadline() < b->deadline(); });
        const std::int64_t time = now(), left = next->deadline() - time;
        std::int64_t wait = left;
        if (w.warn != nullptr) {
            // The outermost is the file named by the user.
            const TimeLimit& file = *w.limits.front();
            if (file.begun() != reported) next_report = file.begun() + k_first_report_ms;
            reported = file.begun();
            if (time >= next_report) {
                w.warn(file.where(), static_cast<double>(time - file.begun()) / 1000);
                next_report = time + k_report_interval_ms;
            }
            wait = std::min(left, next_report - time);
        }
        if (left > 0) {
            w.changed.wait_for(lock, std::chrono::milliseconds(wait));
            continue;
        }
        w.end({"reading takes too long", next->where(), "",
               shortest_text(static_cast<double>(w.limit_ms) / 1000) + " s without an answer from the library",
               "Check the file (an endless view?), copy it to this machine, or allow more with FRANA_READ_SECONDS"});
        return;
    }
}

}  // namespace

TimeLimit::TimeLimit(std::string where) : where_(std::move(where)), begun_(now()) {
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

void on_slow_reading(void (*warn)(const std::string& where, double seconds)) {
    Watch& w = watch();
    const std::lock_guard lock(w.guard);
    w.warn = warn;
}

}  // namespace frana::gis
