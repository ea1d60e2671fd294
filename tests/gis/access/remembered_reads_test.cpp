// SPDX-License-Identifier: Apache-2.0
#include "gis/access/remembered_reads.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <thread>
#include <vector>

#include "gis/raster/plane_raster.h"
#include "gis/raster/raster_in.h"
#include "support/files.h"

namespace frana::gis {
namespace {

using test::Folder;
using test::make_raster;
using test::plane_raster;
using test::utm_grid;

TEST(RememberedReads, TheSameReadIsMadeOnce) {
    const Folder folder;
    const std::string file = folder.file("dtm.tif");
    make_raster(file, plane_raster(8, 6, 5));
    const GridSpec grid = utm_grid(527000, 5095000, 5, 8, 6);
    const RasterRead direct = read_raster_on(file, grid, "", Resampling::automatic);
    RememberedReads reads;
    {
        const UseRemembered use(reads);
        const RasterRead first = read_raster_on(file, grid, "", Resampling::automatic);
        (void)inspect_raster(file, "key");
        std::filesystem::remove(file);
        const RasterRead again = read_raster_on(file, grid, "", Resampling::automatic);
        for (const RasterRead* one : {&first, &again}) {
            EXPECT_EQ(one->raster.values, direct.raster.values);
            EXPECT_EQ(one->resampling_used, direct.resampling_used);
        }
        EXPECT_EQ(inspect_raster(file, "key").columns, 8);
        // Any other argument is another read, of a file that is no longer there.
        GridSpec other = grid;
        other.columns = 7;
        EXPECT_THROW((void)read_raster_on(file, other, "", Resampling::automatic), Error);
        EXPECT_THROW((void)read_raster_on(file, grid, "", Resampling::cubic), Error);
        EXPECT_THROW((void)read_raster_on(file, grid, "", Resampling::automatic, "foot"), Error);
        EXPECT_THROW((void)read_raster_on(file, grid, "", Resampling::automatic, "auto", 3.0), Error);
        EXPECT_THROW((void)inspect_raster(file, "another key"), Error);
    }
    EXPECT_THROW((void)read_raster_on(file, grid, "", Resampling::automatic), Error);
}

TEST(RememberedReads, WhatFailedIsTriedAgain) {
    const Folder folder;
    const std::string file = folder.file("dtm.tif");
    RememberedReads reads;
    const UseRemembered use(reads);
    EXPECT_THROW((void)inspect_raster(file, "key"), Error);
    make_raster(file, plane_raster(8, 6, 5));
    EXPECT_EQ(inspect_raster(file, "key").rows, 6);
}

TEST(RememberedReads, ThreadsShareOneRead) {
    RememberedReads reads;
    int calls = 0;  // changed under the memory's lock
    std::vector<std::thread> threads;
    std::vector<int> values(8);
    for (int& value : values)
        threads.emplace_back([&] {
            const UseRemembered use(reads);
            value = remembered(
                "count", [&] { return ++calls; }, std::string("file"));
        });
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(calls, 1);
    for (const int value : values) EXPECT_EQ(value, 1);
}

// "ab" + "c" is not "a" + "bc".
TEST(RememberedReads, KeysTellArgumentsApart) {
    RememberedReads reads;
    const UseRemembered use(reads);
    const auto get = [](int value, const std::string& a, const std::string& b) {
        return remembered(
            "f", [&] { return value; }, a, b);
    };
    EXPECT_EQ(get(1, "ab", "c"), 1);
    EXPECT_EQ(get(2, "a", "bc"), 2);
    EXPECT_EQ(get(3, "ab", "c"), 1);
    EXPECT_EQ(remembered(
                  "f", [] { return 4; }, std::optional<double>()),
              4);
    EXPECT_EQ(remembered(
                  "f", [] { return 5; }, std::optional<double>(0)),
              5);
}

}  // namespace
}  // namespace frana::gis
