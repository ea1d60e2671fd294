// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "core/thread_pool.h"
#include "models/structured/solid/column_state.h"
#include "models/structured/solid/pair_work.h"
#include "models/structured/solid/solid_report.h"
#include "particles/cell_order.h"

namespace frana::structured {

/// Friction exceeds the forces on a particle at rest by this fraction, so that it stays for any length of the next
/// substep, rounding included.
inline constexpr double k_static_margin = 1e-9;
[[nodiscard]] inline bool friction_holds(double ax, double ay, double resistance) noexcept {
    const double limit = (1 - k_static_margin) * resistance;
    return ax * ax + ay * ay <= limit * limit;
}

/// Whether a substep with neighbours that are still too would change nothing of these particles, to the bit: none
/// moves, they flow freely, so that earth pressure, which is part of the push, is their only stress, and friction
/// resists the push of this step. SolidReport::rests says so; if so, the report is the one of such a substep.
///
/// @param mean reference of SolidReport::apart2 [m/s]
template <class Kind>
SolidReport still_report(ParticleRun run, const SolidLaws& laws, Point mean, const ParticleSet& particles) {
    SolidReport report;
    const auto is_zero = [&](Field field, std::size_t p) { return particles[field][p] == 0; };
    for (std::size_t p = run.begin; p < run.end && report.rests; ++p) {
        report.rests = is_zero(Field::u, p) && is_zero(Field::v, p);
        if (!report.rests) break;
        const ParticleLoad column = particle_load<Kind>(laws, particles, p);
        report.rests = flows_freely(laws, column) && is_zero(Field::t_xx, p) && is_zero(Field::t_yy, p) &&
                       is_zero(Field::t_xy, p) && is_zero(Field::t_zz, p) &&
                       (laws.earth_pressure != EarthPressure::passive || is_zero(Field::divergence, p));
        const double ax = particles[Field::push_x][p], ay = particles[Field::push_y][p];
        const double resistance = bed_resistance(laws, column, column.mass / particles[Field::area][p],
                                                 particles[Field::bed_friction][p], particles[Field::flatness][p]);
        report.rests = report.rests && friction_holds(ax, ay, resistance);
        report.apart2 = mean.x * mean.x + mean.y * mean.y;
        report.acceleration2 = std::max(report.acceleration2, ax * ax + ay * ay);
    }
    return report;
}

/// Cells in which a substep changes nothing: their sums, stresses and moves are not computed, since they would be the
/// same to the bit. With Z_k(C): in cell C all velocities are zero after substep k (and, except for k = -1, friction
/// exceeds the driving forces by a margin),
///
///     C is inactive in k + 1  if  Z_k and Z_k-1 are true in it and four cells around, twice the reach of its particles
///
/// Then velocity gradients are zero in it and within reach, in k and k + 1: areas, damage and (the return to the yield
/// surface being idempotent) stresses keep their values of k, and so do the accelerations by them.
///
/// The inputs from the grid (push, submergence, area) change between steps. At the start of a step, therefore,
///
///     C is inactive  if  in it and four cells around all particles are still (still_report)
///
/// that is, have no stress which an input could change, and resist the new push: broken material that has come to rest
/// costs that test alone. It reads nothing but the particles, so that a resumed run skips the same.
class Rest {
  public:
    /// Call before the first substep of a step, and after particles were sorted.
    /// @param report_still returns still_report of a run of particles
    template <class Still>
    void begin(const CellOrder& order, PairWork& work, bool skips, ThreadPool& pool, const Still& report_still) {
        columns_ = order.columns();
        rows_ = order.rows();
        const auto cells = static_cast<std::size_t>(rows_ * columns_);
        before_.assign(cells, 1);
        now_.assign(cells, 1);
        reports_.assign(cells, SolidReport{});
        pool.for_each(static_cast<std::size_t>(rows_), [&](std::size_t r) {
            const auto row = static_cast<std::int64_t>(r);
            for (std::int64_t column = 0; column < columns_; ++column) {
                const ParticleRun run = order.cell(row, column);
                if (run.begin == run.end) continue;
                const std::size_t cell = index(row, column);
                for (std::size_t p = run.begin; p < run.end; ++p)
                    if (work[PairWork::u][p] != 0 || work[PairWork::v][p] != 0) before_[cell] = 0;
                record(cell, report_still(run));
            }
        });
        if (skips)
            spread(now_, work.resting);
        else
            work.resting.clear();
    }
    [[nodiscard]] static bool resting(const PairWork& work, std::size_t cell) noexcept {
        return !work.resting.empty() && work.resting[cell] != 0;
    }
    [[nodiscard]] std::size_t index(std::int64_t row, std::int64_t column) const noexcept {
        return static_cast<std::size_t>(row * columns_ + column);
    }
    /// Report of a cell when it was last active, or of a substep in which it is not.
    [[nodiscard]] const SolidReport& report_of(std::size_t cell) const noexcept { return reports_[cell]; }
    void record(std::size_t cell, const SolidReport& report) {
        reports_[cell] = report;
        now_[cell] = report.rests;
    }
    /// Cells whose strength has changed are computed in the next substep, in any case.
    void wake(const std::vector<std::uint8_t>& changed) {
        for (std::size_t c = 0; c < changed.size(); ++c) now_[c] &= changed[c] == 0;
    }
    /// Call after a substep: determines the inactive cells of the next.
    void end_substep(PairWork& work) {
        both_.resize(now_.size());
        for (std::size_t c = 0; c < now_.size(); ++c) both_[c] = now_[c] & before_[c];
        before_ = now_;
        spread(both_, work.resting);
    }

  private:
    static constexpr std::int64_t k_far = 2 * CellOrder::k_near;

    // Inactive are the cells that are still with four cells around them.
    void spread(const std::vector<std::uint8_t>& still, std::vector<std::uint8_t>& resting) {
        along_.assign(still.size(), 1);
        resting.assign(still.size(), 1);
        erode(still, along_, columns_, 1);
        erode(along_, resting, rows_, columns_);
    }

    // The minimum over nine neighbours along one direction; cells beyond the ends count as at rest.
    void erode(const std::vector<std::uint8_t>& from, std::vector<std::uint8_t>& to, std::int64_t length,
               std::int64_t stride) const {
        const std::int64_t lines = static_cast<std::int64_t>(from.size()) / std::max<std::int64_t>(length, 1);
        for (std::int64_t line = 0; line < lines; ++line) {
            const std::int64_t first = stride == 1 ? line * length : line;
            for (std::int64_t i = 0; i < length; ++i) {
                std::uint8_t least = 1;
                for (std::int64_t k = std::max(i - k_far, std::int64_t{0}); k <= std::min(i + k_far, length - 1); ++k)
                    least &= from[static_cast<std::size_t>(first + k * stride)];
                to[static_cast<std::size_t>(first + i * stride)] = least;
            }
        }
    }

    std::int64_t rows_ = 0, columns_ = 0;
    std::vector<std::uint8_t> now_, before_, both_, along_;
    std::vector<SolidReport> reports_;
};

}  // namespace frana::structured
