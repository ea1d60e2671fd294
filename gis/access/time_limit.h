// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>
#include <string>

#include "core/error.h"

namespace frana::gis {

/// While one lives, what the libraries do with a file has a limit: where a single call takes longer (a query
/// in a database that never ends, a file that never comes), `when_time_is_up` hears of it on another thread.
/// No library can be stopped in the middle, so what it does is to end the program.
class TimeLimit {
  public:
    /// `where` names key and file.
    explicit TimeLimit(std::string where);
    ~TimeLimit();
    TimeLimit(const TimeLimit&) = delete;
    TimeLimit& operator=(const TimeLimit&) = delete;

    /// A call came back: the next has the whole limit again.
    void again() noexcept;

    /// For the watching thread only.
    [[nodiscard]] std::int64_t begun() const noexcept { return begun_; }
    [[nodiscard]] std::int64_t deadline() const noexcept { return deadline_; }
    [[nodiscard]] const std::string& where() const noexcept { return where_; }

  private:
    std::string where_;
    std::int64_t begun_;                  ///< as the deadline
    std::atomic<std::int64_t> deadline_;  ///< [ms] of the steady clock
};

/// Sets what happens then, once, before files are read; without it there is no limit. `seconds` for a call.
void when_time_is_up(double seconds, void (*end)(const Problem&));

/// Sets what is told of a file over which the libraries have been for some seconds, every ten: its `where`
/// and how long. To be set before the other.
void on_slow_reading(void (*warn)(const std::string& where, double seconds));

}  // namespace frana::gis
