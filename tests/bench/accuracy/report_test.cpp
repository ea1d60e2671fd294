// SPDX-License-Identifier: Apache-2.0
#include "bench/accuracy/accuracy.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sstream>

#include "support/program.h"

namespace frana::bench {
namespace {

AccuracyRow row(const char* name, Scheme scheme, double cell, double seconds, double error, double order) {
    AccuracyRow r;
    r.case_name = name;
    r.scheme = scheme;
    r.statistics.cell_size = cell;
    r.statistics.wall_seconds = seconds;
    r.statistics.l1_depth = r.statistics.l1_momentum = error;
    r.observed_order = order;
    return r;
}

std::vector<AccuracyRow> some_rows() {
    return {row("stoker", Scheme::standard, 10, 1, 0.1, k_no_data), row("stoker", Scheme::standard, 5, 8, 0.05, 1),
            row("stoker", Scheme::paper, 10, 0.5, 0.02, k_no_data), row("stoker", Scheme::paper, 5, 4, 0.01, 1)};
}

TEST(AccuracyCsv, HasTheContractsColumns) {
    std::istringstream lines(accuracy_csv(some_rows()));
    std::string line;
    std::getline(lines, line);
    EXPECT_EQ(line,
              "case,scheme,cell_size,particles,steps,wall_seconds,cpu_seconds,l1_depth,l2_depth,linf_depth,"
              "l1_momentum,observed_order");
    std::getline(lines, line);
    EXPECT_EQ(line, "stoker,default,10,0,0,1,0,0.1,0,0,0.1,nan");
    std::getline(lines, line);
    EXPECT_EQ(line, "stoker,default,5,0,0,8,0,0.05,0,0,0.05,1.0000");
}

TEST(AccuracyTable, MarksWhereAMarkIsMissed) {
    std::vector<AccuracyRow> rows = some_rows();
    rows[1].statistics.own = {{"mean depth error [m]", 0.05, 0.015}};
    EXPECT_NE(accuracy_table(rows).find("MISSED"), std::string::npos);
    rows[1].statistics.own[0].value = 0.002;
    EXPECT_EQ(accuracy_table(rows).find("MISSED"), std::string::npos);
}

TEST(CaseStatistic, NanDoesNotPass) {
    EXPECT_FALSE((CaseStatistic{"x", k_no_data, 1.0}).met());
    EXPECT_FALSE((CaseStatistic{"x", -2, 1.0}).met());
    EXPECT_TRUE((CaseStatistic{"x", -1, 1.0}).met());
}

TEST(BenchCommand, WritesCsvAndPicture) {
    namespace fs = std::filesystem;
    const fs::path folder = fs::temp_directory_path() / ("frana_bench_" + std::to_string(::getpid()));
    fs::create_directories(folder);
    const test::Outcome outcome =
        test::run_program(folder.string(), {"bench", "accuracy", "--quick", "--case", "similarity", "--out", "result"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    const std::string csv = test::read_text((folder / "result" / "accuracy.csv").string());
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 7);  // header, 3 schemes x 2 resolutions
    EXPECT_GT(fs::file_size(folder / "result" / "accuracy.png"), 1000u);
    const test::Outcome wrong = test::run_program(folder.string(), {"bench", "speeed"});
    EXPECT_EQ(wrong.exit_code, 2);
    EXPECT_NE(wrong.err.find("accuracy, stability, speed"), std::string::npos) << wrong.err;
    fs::remove_all(folder);
}

}  // namespace
}  // namespace frana::bench
