// SPDX-License-Identifier: Apache-2.0
// The kernels give the same bits in every set of instructions, so that a result does not depend on the processor.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "models/finite_volume/cells.h"

namespace frana::finite_volume {
namespace {

constexpr std::int64_t k_stride = 43, k_rows = 7;
constexpr std::size_t k_first = 3 * k_stride + 3, k_count = 37;  // not a multiple of four

// Rough ground with flow, films and dry cells on it.
struct Ground {
    std::vector<std::vector<double>> arrays =
        std::vector<std::vector<double>>(24, std::vector<double>(k_stride* k_rows + 8));
    Cells cells{};

    Ground() {
        double** const fields[] = {&cells.depth, &cells.qx, &cells.qy};
        std::mt19937 random(7);
        std::uniform_real_distribution<double> part(-1, 1);
        std::size_t next = 0;
        const auto take = [&](double scale, double middle) {
            for (double& value : arrays[next]) value = middle + scale * part(random);
            return arrays[next++].data();
        };
        for (double** field : fields) *field = take(2, 0);
        for (double& h : arrays[0]) h = h < 0 ? 0 : h < 0.5 ? 1e-5 * h : h;
        cells.bed = take(3, 0);
        cells.slope_x = take(1, 0);
        cells.slope_y = take(1, 0);
        double* const root = take(0, 0);
        for (std::size_t k = 0; k < arrays[0].size(); ++k)
            root[k] = std::sqrt(1 + cells.slope_x[k] * cells.slope_x[k] + cells.slope_y[k] * cells.slope_y[k]);
        cells.root = root;
        cells.curvature_xx = take(0.1, 0);
        cells.curvature_xy = take(0.1, 0);
        cells.curvature_yy = take(0.1, 0);
        for (double** field : {&cells.weight, &cells.slowed_x, &cells.slowed_y, &cells.pull_x, &cells.pull_y,
                               &cells.bound, &cells.spare, &cells.before, &cells.held, &cells.head, &cells.start,
                               &cells.max_depth, &cells.max_speed, &cells.arrival_plus_1})
            *field = take(0, 0);
        cells.stride = k_stride;
    }
};

StepValues values() {
    StepValues v;
    v.dt = 0.05;
    v.cell_size = 2;
    v.gravity = 9.81;
    v.dry = 1e-4;
    v.minimum_depth = 0.01;
    v.time = 3;
    return v;
}

TEST(RowKernels, GiveTheSameBitsInEverySetOfInstructions) {
    Ground ground[2];
    StripTotals totals[2];
    const StepValues v = values();
    for (const int n : {0, 1}) {
        const RowKernels& kernels = row_kernels(n == 0);
        const Cells& c = ground[n].cells;
        const VoellmyFriction law{0.3, 1 / 500.0};
        for (std::int64_t j = 2; j < 5; ++j)
            kernels.prepare(c, static_cast<std::size_t>(j * k_stride + 2), k_count + 2, v, UniformFriction{law});
        kernels.hold(c, k_first, k_count, v);
        std::vector<double> work(40 * 64);
        const auto array = [&](std::size_t a) { return work.data() + 64 * a; };
        for (const bool along_y : {false, true}) {
            const CellRow row{array(0), array(1), array(2), array(3), array(4),
                              array(5), array(6), array(7), array(15)};
            const std::size_t before = k_first - 2;
            kernels.read_row(c, before, k_count + 4, c.depth + before, c.qx + before, c.qy + before, along_y, v.dry,
                             row);
            const auto moved = [&](std::size_t by) {
                return CellRow{row.depth + by, row.speed + by, row.normal + by, row.tangential + by, row.weight + by,
                               row.drive + by, row.bed + by,   row.closed + by, row.spare + by};
            };
            const FaceRow faces{array(8), array(9), array(10), array(11), array(12), array(13), array(14)};
            const SideRow starts{array(16), array(17), array(18), array(19), array(20)},
                ends{array(21), array(22), array(23), array(24), array(25)};
            kernels.sides(moved(0), moved(1), moved(2), k_count + 2, v, starts, ends);
            const SideRow next{starts.depth + 1, starts.speed + 1, starts.normal + 1, starts.tangential + 1,
                               starts.bed + 1};
            kernels.faces(moved(0), moved(1), moved(2), moved(3), ends, next, k_count + 1, v, faces);
            const FaceRow after{faces.mass + 1,           faces.normal + 1,         faces.tangential + 1,
                                faces.pressure_below + 1, faces.pressure_above + 1, faces.step_below + 1,
                                faces.step_above + 1};
            kernels.update(c, k_first, k_count, along_y, v, faces, after);
        }
        kernels.finish(c, k_first, k_count, v, UniformFriction{law}, totals[n]);
    }
    EXPECT_EQ(ground[0].arrays, ground[1].arrays);
    for (int lane = 0; lane < 4; ++lane) {
        EXPECT_EQ(totals[0].max_speed[lane], totals[1].max_speed[lane]);
        EXPECT_EQ(totals[0].dissipated[lane], totals[1].dissipated[lane]);
    }
    double motion = 0;
    for (const double q : ground[0].arrays[1]) motion += std::abs(q);
    EXPECT_GT(motion, 1);
}

}  // namespace
}  // namespace frana::finite_volume
