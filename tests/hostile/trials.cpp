// SPDX-License-Identifier: Apache-2.0
#include "trials.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>

namespace frana::test {
namespace {

int failures_now() {
    return ::testing::UnitTest::GetInstance()->current_test_info()->result()->total_part_count();
}

}  // namespace

std::uint64_t trial_seed() {
    const char* asked = std::getenv("FRANA_SEED");
    return asked != nullptr ? std::strtoull(asked, nullptr, 10) : 1;
}

int trial_count(int usual) {
    const char* asked = std::getenv("FRANA_TRIALS");
    return asked != nullptr ? std::atoi(asked) : usual;
}

Trials::Trials() : failures_before_(failures_now()) {}

void Trials::settle() {
    const int failures = failures_now();
    if (!kind_.empty() && failures > failures_before_) ++kinds_[kind_].failed;
    failures_before_ = failures;
}

void Trials::begin(const std::string& kind) {
    settle();
    kind_ = kind;
    ++kinds_[kind].count;
}

Trials::~Trials() {
    settle();
    int count = 0, failed = 0;
    for (const auto& [name, kind] : kinds_) {
        std::cout << "hostile: " << name << ", seed " << trial_seed() << ": " << kind.count << " trials, "
                  << kind.failed << " failed;";
        for (const auto& [code, times] : kind.endings) std::cout << " exit code " << code << ": " << times << ';';
        std::cout << '\n';
        count += kind.count;
        failed += kind.failed;
    }
    ::testing::Test::RecordProperty("trials", count);
    ::testing::Test::RecordProperty("failed", failed);
}

}  // namespace frana::test
