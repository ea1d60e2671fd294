// SPDX-License-Identifier: Apache-2.0
#include "same_result.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "support/lasting_bytes.h"

namespace frana::test {

namespace fs = std::filesystem;

std::vector<std::string> files_below(const std::string& folder) {
    std::vector<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (!entry.is_directory()) names.push_back(entry.path().lexically_relative(folder).string());
    std::sort(names.begin(), names.end());
    return names;
}

std::size_t expect_same_files(const std::string& expected, const std::string& result) {
    const std::vector<std::string> names = files_below(expected);
    EXPECT_EQ(names, files_below(result));
    for (const std::string& name : names) {
        const fs::path a = fs::path(expected) / name, b = fs::path(result) / name;
        if (fs::exists(b)) {
            EXPECT_TRUE(lasting_bytes(a.string()) == lasting_bytes(b.string())) << b;
        }
    }
    return names.size();
}

}  // namespace frana::test
