// SPDX-License-Identifier: Apache-2.0
#include "core/session.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <thread>
#include <vector>

namespace frana {
namespace {

std::atomic<int> calls = 0;

int count(const std::string&) {
    return ++calls;
}
int count_pair(const std::string&, const std::string&) {
    return ++calls;
}
int count_number(std::optional<double>) {
    return ++calls;
}
int succeed_at_last(int) {
    if (++calls == 1) throw std::runtime_error("not yet");
    return calls;
}

class RememberedInSession : public testing::Test {
  protected:
    void SetUp() override { calls = 0; }
    const Session session{0, std::make_shared<RememberedReads>()};
};

TEST_F(RememberedInSession, WithoutMemoryEverythingIsReadAnew) {
    EXPECT_EQ(Session{}.read(count, "file"), 1);
    EXPECT_EQ(Session{}.read(count, "file"), 2);
}

TEST_F(RememberedInSession, WhatFailedIsTriedAgain) {
    EXPECT_THROW(session.read(succeed_at_last, 0), std::runtime_error);
    EXPECT_EQ(session.read(succeed_at_last, 0), 2);
    EXPECT_EQ(session.read(succeed_at_last, 0), 2);
}

TEST_F(RememberedInSession, ThreadsShareOneRead) {
    std::vector<std::thread> threads;
    std::vector<int> values(8);
    for (int& value : values) threads.emplace_back([&] { value = session.read(count, "file"); });
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(calls, 1);
    for (const int value : values) EXPECT_EQ(value, 1);
}

// "ab" + "c" is not "a" + "bc"; nothing is not 0; another function is another read.
TEST_F(RememberedInSession, KeysTellArgumentsApart) {
    EXPECT_EQ(session.read(count_pair, "ab", "c"), 1);
    EXPECT_EQ(session.read(count_pair, "a", "bc"), 2);
    EXPECT_EQ(session.read(count_pair, "ab", "c"), 1);
    EXPECT_EQ(session.read(count_number, std::nullopt), 3);
    EXPECT_EQ(session.read(count_number, 0.0), 4);
    EXPECT_EQ(session.read(count, "ab"), 5);
}

}  // namespace
}  // namespace frana
