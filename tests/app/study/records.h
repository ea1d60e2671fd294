// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "app/study/member_record.h"
#include "app/study/record_files.h"
#include "app/study/statistics/cell_statistics.h"

namespace frana::app::study::test {

/// A folder with records of members that reached some cells of a map of 4 x 3 cells.
class Records : public ::testing::Test {
  protected:
    Records()
        : folder_(std::filesystem::temp_directory_path() /
                  ("frana_study_" + std::to_string(::getpid()) + "_" +
                   ::testing::UnitTest::GetInstance()->current_test_info()->name())) {
        std::filesystem::create_directories(folder_);
        grid_.columns = 4;
        grid_.rows = 3;
        grid_.cell_size = 10;
        grid_.north = 30;
    }
    ~Records() override {
        std::error_code ignored;
        std::filesystem::remove_all(folder_, ignored);
    }
    /// A member with these depths from a first cell on; speeds are ten times as large, arrivals one more.
    [[nodiscard]] static MemberRecord record(std::uint64_t first, const std::vector<float>& depth) {
        MemberRecord one;
        one.north = 30;
        one.cell_size = 10;
        one.columns = 4;
        one.rows = 3;
        if (!depth.empty()) one.runs.push_back({first, depth.size()});
        one.of(Quantity::depth) = depth;
        for (const float d : depth) {
            one.of(Quantity::velocity).push_back(10 * d);
            one.of(Quantity::arrival).push_back(1 + d);
        }
        return one;
    }
    /// Writes a record to a file of its own.
    [[nodiscard]] RecordPlace keep(const std::string& name, const MemberRecord& one) const {
        const std::string file = (folder_ / name).string(), bytes = bytes_of(one);
        std::ofstream(file, std::ios::binary) << bytes;
        return {file, 0, bytes.size()};
    }
    void add(const MemberRecord& one) {
        members_.records.push_back(keep("r" + std::to_string(members_.records.size()), one));
        members_.weights.assign(members_.records.size(), 1.0 / static_cast<double>(members_.records.size()));
    }
    /// Of a study in which no run is open.
    [[nodiscard]] StudyRuns runs() const {
        StudyRuns all{members_, {}, members_, std::vector<bool>(members_.size())};
        for (std::size_t i = 0; i < members_.size(); ++i) all.finished_at.push_back(i);
        return all;
    }

    std::filesystem::path folder_;
    GridSpec grid_;
    FinishedMembers members_;
};

}  // namespace frana::app::study::test
