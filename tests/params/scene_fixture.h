// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "params/scene/read_scene.h"
#include "support/problems.h"

namespace frana {

/// A separate folder for every test, with scene files in it.
class SceneFixture : public ::testing::Test {
  protected:
    SceneFixture() {
        std::string name = "frana_params_" + std::to_string(::getpid()) + "_" +
                           ::testing::UnitTest::GetInstance()->current_test_info()->name();
        std::replace(name.begin(), name.end(), '/', '_');  // parameterised tests
        folder_ = std::filesystem::temp_directory_path() / name;
        std::filesystem::create_directories(folder_);
    }
    ~SceneFixture() override {
        std::error_code ignored;
        std::filesystem::remove_all(folder_, ignored);
    }

    std::string write(const std::string& text, const std::string& name = "scene.ini") const {
        std::ofstream(folder_ / name) << text;
        return (folder_ / name).string();
    }
    SceneReading read(const std::string& text, const std::vector<std::string>& overrides = {}) const {
        return read_scene(write(text), overrides, FRANA_SOURCE_SHARE);
    }
    std::vector<Problem> problems(const std::string& text, const std::vector<std::string>& overrides = {}) const {
        return read(text, overrides).problems.list();
    }

    std::filesystem::path folder_;
};

/// The minimal scene.
inline const std::string k_least =
    "[terrain]\ndtm = dtm.tif\n[release]\nperimeter = area.shp\nthickness = 2\n[material]\nfriction-angle = "
    "20\n";

}  // namespace frana
