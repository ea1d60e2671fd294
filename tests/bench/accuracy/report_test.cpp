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

// The paper's scheme is better here, in less time: the text must say so.
std::vector<AccuracyRow> paper_wins() {
    return {row("stoker", Scheme::standard, 10, 1, 0.1, k_no_data), row("stoker", Scheme::standard, 5, 8, 0.05, 1),
            row("stoker", Scheme::paper, 10, 0.5, 0.02, k_no_data), row("stoker", Scheme::paper, 5, 4, 0.01, 1)};
}

TEST(AccuracyCsv, HasTheContractsColumns) {
    std::istringstream lines(accuracy_csv(paper_wins()));
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

TEST(ErrorInTime, IsLinearInLogarithms) {
    EXPECT_NEAR(error_in_time({{1, 0.1}, {100, 0.001}}, 10), 0.01, 1e-15);
    EXPECT_TRUE(std::isnan(error_in_time({{1, 0.1}, {100, 0.001}}, 0.5)));
    EXPECT_TRUE(std::isnan(error_in_time({{1, 0.1}, {100, 0.001}}, 200)));
    EXPECT_NEAR(time_to_error({{1, 0.1}, {100, 0.001}}, 0.01), 10, 1e-12);
    EXPECT_EQ(time_to_error({{1, 0.1}, {100, 0.001}}, 0.2), 1);
    EXPECT_TRUE(std::isnan(time_to_error({{1, 0.1}, {100, 0.001}}, 1e-4)));
}

TEST(AccuracyVerdict, NamesTheBetterScheme) {
    const std::string words = accuracy_verdict(paper_wins());
    EXPECT_NE(words.find("stoker: PAPER"), std::string::npos) << words;
    EXPECT_NE(words.find("the paper's in 1"), std::string::npos) << words;
}

TEST(AccuracyTable, MarksWhereAnotherCodeIsBetterAndWhereAMarkIsMissed) {
    std::vector<AccuracyRow> rows = paper_wins();
    rows[1].statistics.own = {{"mean depth error [m]", 0.05, 0.015}};  // GeoClaw has 0.0231 with 5 m cells
    const std::string table = accuracy_table(rows);
    EXPECT_NE(table.find("MISSED"), std::string::npos);
    EXPECT_NE(table.find("frana's default, 5 m: WORSE, 2.16 times"), std::string::npos) << table;
    rows[1].statistics.own[0].value = 0.002;  // below every published value, whatever its cells
    EXPECT_EQ(accuracy_table(rows).find("WORSE"), std::string::npos);
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
    EXPECT_NE(outcome.out.find("com1DFA"), std::string::npos);
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
