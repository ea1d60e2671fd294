// SPDX-License-Identifier: Apache-2.0
#include "models/structured/solid/near_quads.h"

#include <algorithm>

#include "core/quad.h"

namespace frana::structured {

void NearQuads::find(const CellOrder& order, const double* x, const double* y, std::size_t size, ThreadPool& pool) {
    const double far = order.reach() + order.slack();
    const Quad far2(far * far);
    rows_.resize(static_cast<std::size_t>(order.rows()));
    ranges_.resize(size);
    pool.for_each(rows_.size(), [&](std::size_t r) {
        const auto row = static_cast<std::int64_t>(r);
        std::vector<std::uint32_t>& quads = rows_[r];
        quads.clear();
        for (std::int64_t column = 0; column < order.columns(); ++column) {
            const ParticleRun own = order.cell(row, column);
            if (own.begin == own.end) continue;
            const auto runs = order.around(row, column);
            for (std::size_t i = own.begin; i < own.end; ++i) {
                const Quad at_x(x[i]), at_y(y[i]);
                ranges_[i].begin = static_cast<std::uint32_t>(quads.size());
                for (const ParticleRun& run : runs) {
                    for (std::size_t k = run.begin; k < run.end; k += 4) {
                        const Quad dx = at_x - Quad::load(x + k), dy = at_y - Quad::load(y + k);
                        if (!any(dx * dx + dy * dy < far2)) continue;
                        quads.push_back(static_cast<std::uint32_t>(4 * k + std::min<std::size_t>(run.end - k, 4) - 1));
                    }
                }
                ranges_[i].end = static_cast<std::uint32_t>(quads.size());
            }
        }
    });
}

}  // namespace frana::structured
