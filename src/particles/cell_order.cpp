// SPDX-License-Identifier: Apache-2.0
#include "particles/cell_order.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace frana {
namespace {

// Numbers the rows (or columns) of cells that contain particles, and of the empty ones between them at most so many.
std::int64_t number(std::vector<std::int32_t>& numbers) {
    std::int64_t next = 0, empty = 0;
    for (std::int32_t& used : numbers) {
        empty = used != 0 ? 0 : empty + 1;
        if (empty <= CellOrder::k_most_empty) ++next;
        used = static_cast<std::int32_t>(next - 1);
    }
    return next;
}

}  // namespace

void CellOrder::sort(ParticleSet& particles, const std::vector<std::uint8_t>& keep, ThreadPool& pool) {
    constexpr std::size_t k_block = 16384;
    constexpr std::uint32_t k_dropped = std::numeric_limits<std::uint32_t>::max();
    const std::size_t n = particles.size();
    const double* x = particles[Field::x];
    const double* y = particles[Field::y];
    bool any = false;
    for (std::size_t p = 0; p < n; ++p) {
        if (!keep.empty() && !keep[p]) continue;
        west_ = any ? std::min(west_, x[p]) : x[p];
        east_ = any ? std::max(east_, x[p]) : x[p];
        south_ = any ? std::min(south_, y[p]) : y[p];
        north_ = any ? std::max(north_, y[p]) : y[p];
        any = true;
    }
    const auto steps = [this](double from, double to) { return static_cast<std::size_t>((to - from) / side_); };
    column_of_.assign(any ? steps(west_, east_) + 1 : 0, 0);
    row_of_.assign(any ? steps(south_, north_) + 1 : 0, 0);
    for (std::size_t p = 0; p < n; ++p) {
        if (!keep.empty() && !keep[p]) continue;
        column_of_[steps(west_, x[p])] = row_of_[steps(south_, y[p])] = 1;
    }
    columns_ = number(column_of_);
    rows_ = number(row_of_);

    // A stable counting sort. Keys and moves are computed in parallel; counting alone is too short to benefit.
    keys_.resize(n);
    pool.for_blocks(n, k_block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t p = begin; p < end; ++p) {
            const bool kept = keep.empty() || keep[p];
            keys_[p] =
                !kept ? k_dropped
                      : static_cast<std::uint32_t>(place(row_of_[steps(south_, y[p])], column_of_[steps(west_, x[p])]));
        }
    });
    starts_.assign(static_cast<std::size_t>((rows_ + 2 * k_near) * (columns_ + 2 * k_near)) + 1, 0);
    for (const std::uint32_t key : keys_) {
        if (key != k_dropped) ++starts_[key + 1];
    }
    for (std::size_t c = 1; c < starts_.size(); ++c) starts_[c] += starts_[c - 1];
    source_.resize(n);
    bool in_order = true;
    for (std::size_t p = 0; p < n; ++p) {
        if (keys_[p] == k_dropped) continue;
        const std::uint32_t to = starts_[keys_[p]]++;
        source_[to] = static_cast<std::uint32_t>(p);
        in_order = in_order && to == p;
    }
    for (std::size_t c = starts_.size() - 1; c > 0; --c) starts_[c] = starts_[c - 1];
    starts_[0] = 0;

    const std::size_t kept = starts_.back();
    if (kept == n && in_order) return;
    particles.rebuild(
        kept, (kept + k_block - 1) / k_block,
        [&](Field, const double* from, double* to, std::size_t part) {
            const std::size_t end = std::min(kept, (part + 1) * k_block);
            for (std::size_t i = part * k_block; i < end; ++i) to[i] = from[source_[i]];
        },
        pool);
}

bool CellOrder::orders(std::size_t count) const {
    const auto cells = static_cast<std::int64_t>(starts_.size());
    if (cells == 0) return count == 0 && rows_ == 0 && columns_ == 0;
    return rows_ >= 0 && rows_ < cells && columns_ >= 0 && columns_ < cells &&
           (cells - 1) % (columns_ + 2 * k_near) == 0 && (cells - 1) / (columns_ + 2 * k_near) == rows_ + 2 * k_near &&
           starts_.front() == 0 && starts_.back() == count && std::is_sorted(starts_.begin(), starts_.end()) &&
           std::isfinite(west_ + south_ + east_ + north_);
}

}  // namespace frana
