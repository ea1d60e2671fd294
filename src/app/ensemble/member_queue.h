// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace frana::app {

/// The members that have no record yet, in order.
class MemberQueue {
  public:
    /// @param folder in which the result is being built
    explicit MemberQueue(std::string folder);

    /// From now on members below `end` are given out too.
    void extend_to(std::size_t end);
    /// Returns the next member whose record is missing or damaged; none: all have been given out.
    [[nodiscard]] std::optional<std::size_t> take();

  private:
    std::string folder_;
    std::size_t next_ = 0, end_ = 0;
};

}  // namespace frana::app
