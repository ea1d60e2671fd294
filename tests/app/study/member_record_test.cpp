// SPDX-License-Identifier: Apache-2.0
#include "app/study/member_record.h"

#include <cmath>
#include <fstream>
#include <iterator>

#include "core/error.h"
#include "study/records.h"

namespace frana::app::study::test {
namespace {

class Record : public Records {
  protected:
    [[nodiscard]] std::string file() const { return (folder_ / "record").string(); }
    [[nodiscard]] std::string bytes() const {
        std::ifstream in(file(), std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }
};

TEST_F(Record, IsReadAsItWasWritten) {
    MemberRecord written = record(3, {0.5F, 2.0F, 1e-3F});
    written.member = 17;
    written.figures = {{"runout_m", "run-out", "m", 1.0 / 3}};
    written.engine_seconds = 0.25;
    write_record(file(), written);
    const auto read = read_record(file());
    ASSERT_TRUE(read);
    EXPECT_EQ(read->member, 17U);
    EXPECT_TRUE(read->finished());
    ASSERT_EQ(read->figures.size(), 1U);
    EXPECT_EQ(read->figures[0].value, 1.0 / 3);
    EXPECT_EQ(read->depth, written.depth);
    EXPECT_EQ(read->velocity, written.velocity);
    EXPECT_EQ(read->arrival, written.arrival);
    const Raster depth = read->raster(Quantity::depth, grid_);
    EXPECT_EQ(depth.at(0, 3), 0.5);
    EXPECT_EQ(depth.at(1, 0), 2.0);
    EXPECT_TRUE(std::isnan(depth.at(0, 0)));
}

// A member whose record is damaged is computed again.
TEST_F(Record, WithAnyByteChangedIsNotRead) {
    write_record(file(), record(0, {1, 2}));
    const std::string good = bytes();
    for (std::size_t i = 0; i < good.size(); ++i) {
        std::string bad = good;
        bad[i] = static_cast<char>(bad[i] ^ 0x10);
        std::ofstream(file(), std::ios::binary) << bad;
        EXPECT_FALSE(read_record(file())) << "byte " << i;
    }
    for (std::size_t size = 0; size < good.size(); ++size) {
        std::ofstream(file(), std::ios::binary) << good.substr(0, size);
        EXPECT_FALSE(read_record(file())) << size << " bytes";
    }
    EXPECT_FALSE(read_record((folder_ / "missing").string()));
}

TEST_F(Record, OnAnotherPartOfTheSameCellsIsPlaced) {
    MemberRecord one = record(0, {3});
    one.west = 10;
    one.north = 20;
    EXPECT_EQ(one.raster(Quantity::depth, grid_).at(1, 1), 3);
    one.west = 13;
    EXPECT_THROW((void)one.raster(Quantity::depth, grid_), Error);
}

}  // namespace
}  // namespace frana::app::study::test
