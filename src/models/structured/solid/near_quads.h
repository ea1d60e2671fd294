// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/thread_pool.h"
#include "particles/cell_order.h"

namespace frana::structured {

/// Lists of neighbours in groups of four, as the sums read them: for each particle, the quads of the order's runs with
/// a particle within the kernel's radius plus the slack of the order. The lists are complete until two particles have
/// approached by that slack, after which the order is renewed too.
class NearQuads {
  public:
    /// Part of a row's list for one particle.
    struct Range {
        std::uint32_t begin = 0, end = 0;
    };

    /// @param x, y of the particles in their order; three values beyond the last can be read
    void find(const CellOrder& order, const double* x, const double* y, std::size_t size, ThreadPool& pool);
    /// Whether there are lists for this number of particles; there are none after reading a state.
    [[nodiscard]] bool of(std::size_t size) const noexcept { return ranges_.size() == size; }

    [[nodiscard]] const std::uint32_t* row(std::int64_t row) const noexcept {
        return rows_[static_cast<std::size_t>(row)].data();
    }
    [[nodiscard]] const Range& range(std::size_t particle) const noexcept { return ranges_[particle]; }

    /// A quad (of at most 2^30 particles): its first particle, and how many of the four belong to the run.
    [[nodiscard]] static std::size_t first(std::uint32_t quad) noexcept { return quad >> 2; }
    [[nodiscard]] static std::size_t count(std::uint32_t quad) noexcept { return (quad & 3) + 1; }

  private:
    std::vector<std::vector<std::uint32_t>> rows_;
    std::vector<Range> ranges_;
};

}  // namespace frana::structured
