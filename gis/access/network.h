// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <string>

#include "core/error.h"

namespace frana::gis {

/// Limits the time of the libraries' calls on a file during its lifetime: if a single call takes longer (a query in a
/// database that never ends, a file that never arrives), `when_time_is_up` is called on another thread. No library can
/// be interrupted, so that function ends the program.
class TimeLimit {
  public:
    /// `where` names key and file.
    explicit TimeLimit(std::string where);
    ~TimeLimit();
    TimeLimit(const TimeLimit&) = delete;
    TimeLimit& operator=(const TimeLimit&) = delete;

    /// Called after a call returned: the next one has the whole limit again.
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

/// Sets the function called then, once, before files are read; without it there is no limit. `seconds` per call.
void when_time_is_up(double seconds, void (*end)(const Problem&));

/// Sets the function that reports a file on which the libraries have spent some seconds, every ten seconds: its `where`
/// and the duration. Must be set before the other.
void on_slow_reading(void (*warn)(const std::string& where, double seconds));

/// Returns whether GDAL may read over the network (URLs, /vsicurl/, databases, map services); see allow_network().
[[nodiscard]] bool network_allowed();

/// Returns the remedy for a path that is not on this machine; none if it is, or if the network is allowed.
[[nodiscard]] std::optional<std::string> network_remedy(const std::string& path);

/// Removes GDAL's network drivers and file systems; GdalSession calls it once unless the network was allowed.
void disable_network();

}  // namespace frana::gis
