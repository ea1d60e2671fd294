// SPDX-License-Identifier: Apache-2.0
#include "app/study/member_record.h"

#include <cmath>
#include <fstream>

#include "core/error.h"
#include "study/records.h"

namespace frana::app::study::test {
namespace {

class Record : public Records {
  protected:
    Record() { std::filesystem::create_directories(folder_ / "records"); }
    /// Of a member, with a depth that tells it.
    [[nodiscard]] static std::string bytes_of_member(std::uint64_t member, float depth) {
        MemberRecord one = record(0, {depth});
        one.member = member;
        return bytes_of(one);
    }
    [[nodiscard]] std::string file(int number) const {
        return (folder_ / ("records/records_0000" + std::to_string(number) + ".frana")).string();
    }
    [[nodiscard]] float depth_of(std::uint64_t member) const {
        return require_record(RecordFiles(folder_.string()).place(member)).of(Quantity::depth).front();
    }
};

TEST_F(Record, IsReadAsItWasWritten) {
    MemberRecord written = record(3, {0.5F, 2.0F, 1e-3F});
    written.member = 17;
    written.figures = {{"runout_m", "run-out", "m", 1.0 / 3}};
    written.engine_seconds = 0.25;
    const auto read = record_from(bytes_of(written));
    ASSERT_TRUE(read);
    EXPECT_EQ(read->member, 17U);
    EXPECT_TRUE(read->finished());
    ASSERT_EQ(read->figures.size(), 1U);
    EXPECT_EQ(read->figures[0].value, 1.0 / 3);
    EXPECT_EQ(read->values, written.values);
    const Raster depth = read->raster(Quantity::depth, grid_);
    EXPECT_EQ(depth.at(0, 3), 0.5);
    EXPECT_EQ(depth.at(1, 0), 2.0);
    EXPECT_TRUE(std::isnan(depth.at(0, 0)));
}

// A member whose record is damaged is computed again.
TEST_F(Record, WithAnyByteChangedIsNotRead) {
    const std::string good = bytes_of(record(0, {1, 2}));
    for (std::size_t i = 0; i < good.size(); ++i) {
        std::string bad = good;
        bad[i] = static_cast<char>(bad[i] ^ 0x10);
        EXPECT_FALSE(record_from(bad)) << "byte " << i;
    }
    for (std::size_t size = 0; size < good.size(); ++size)
        EXPECT_FALSE(record_from(good.substr(0, size))) << size << " bytes";
    EXPECT_FALSE(read_record(RecordPlace{(folder_ / "missing").string(), 0, good.size()}));
}

// Wherever a kill cuts the file of a process, the records before are found, and those of the next process, which writes
// to a file of its own.
TEST_F(Record, IsFoundBeforeATornOneAndInTheNextFile) {
    const std::string first = bytes_of_member(4, 1), second = bytes_of_member(9, 2);
    for (std::size_t size = 0; size < second.size(); ++size) {
        std::ofstream(file(1), std::ios::binary) << first << second.substr(0, size);
        RecordFiles records(folder_.string());
        EXPECT_EQ(records.count(), 1U) << size;
        if (size % 50 > 0) continue;
        std::filesystem::remove(file(2));
        records.append(9, second);
        EXPECT_EQ(depth_of(4), 1) << size;
        EXPECT_EQ(depth_of(9), 2) << size;
        EXPECT_EQ(std::filesystem::file_size(file(2)), second.size()) << size;
        std::filesystem::remove(file(2));
    }
}

// What a power failure leaves between records hides none of those after it; the last record of a member counts.
TEST_F(Record, IsFoundAfterDamage) {
    const std::string a = bytes_of_member(0, 1), b = bytes_of_member(1, 2), c = bytes_of_member(2, 3);
    for (std::size_t from = 0; from < b.size(); from += 7) {
        std::string lost = b;
        lost.replace(from, std::min<std::size_t>(24, b.size() - from), 24, '\x55');
        std::ofstream(file(1), std::ios::binary) << a << lost << c << bytes_of_member(0, 5);
        EXPECT_FALSE(read_record(RecordFiles(folder_.string()).place(1))) << from;
        EXPECT_EQ(depth_of(2), 3) << from;
        EXPECT_EQ(depth_of(0), 5) << from;
    }
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
