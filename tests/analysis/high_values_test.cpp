// SPDX-License-Identifier: Apache-2.0
#include "analysis/ground_statistics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "analysis/trace.h"
#include "row_of.h"

namespace frana {
namespace {

Raster fine_row_of(std::vector<double> values) {
    return row_of(std::move(values), 2);
}

TEST(PeakValues, PercentilesAreNumpys) {
    // numpy.percentile([1, 3, 2, 10], 99) = 9.79, 99.9: 9.979, 50: 2.5
    EXPECT_NEAR(percentile({1, 3, 2, 10}, 0.99), 9.79, 1e-12);
    EXPECT_NEAR(percentile({1, 3, 2, 10}, 0.999), 9.979, 1e-12);
    EXPECT_NEAR(percentile({10, 2, 3, 1}, 0.5), 2.5, 1e-12);
    EXPECT_EQ(percentile({1, 3, 2, 10}, 0), 1);
    EXPECT_EQ(percentile({1, 3, 2, 10}, 1), 10);
    EXPECT_EQ(percentile({7}, 0.99), 7);
    EXPECT_EQ(percentile({5, 5, 5}, 0.999), 5);
    EXPECT_TRUE(std::isnan(percentile({}, 0.99)));
}

TEST(PeakValues, DoNotDependOnOneCell) {
    // 0 to 10000 in no order: numpy.percentile(range(10001), 99.9) = 9990, 99: 9900.
    std::vector<double> values(10001);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<double>(i * 7919 % values.size());
    const Raster all = fine_row_of(std::vector<double>(values.size(), 1));
    const PeakValues calm = high_values(fine_row_of(values), all);
    EXPECT_EQ(calm.greatest, 10000);
    EXPECT_NEAR(calm.p999, 9990, 1e-9);
    EXPECT_NEAR(calm.p99, 9900, 1e-9);
    *std::max_element(values.begin(), values.end()) = 1e6;
    const PeakValues wild = high_values(fine_row_of(values), all);
    EXPECT_EQ(wild.greatest, 1e6);
    EXPECT_EQ(wild.p999, calm.p999);
    EXPECT_EQ(wild.p99, calm.p99);
}

TEST(PeakValues, AreThoseOfTheMarkedCells) {
    const Raster speed = fine_row_of({50, 1, 3, k_no_data, 2, 10, 40});
    const Raster depth = fine_row_of({0.05, 1, 1, 1, 1, 1, k_no_data});
    const PeakValues high = high_values(speed, trace_mask(depth, 0.1));
    EXPECT_EQ(high.greatest, 50);  // of all cells
    EXPECT_NEAR(high.p99, 9.79, 1e-12);
    EXPECT_NEAR(high.p999, 9.979, 1e-12);
    const PeakValues dry = high_values(fine_row_of({k_no_data, 0.05}), fine_row_of({0, k_no_data}));
    EXPECT_EQ(dry.greatest, 0.05);
    EXPECT_TRUE(std::isnan(dry.p999) && std::isnan(dry.p99));
}

}  // namespace
}  // namespace frana
