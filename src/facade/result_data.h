// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "facade/prepare_scene.h"
#include "simulation/result.h"

namespace frana::facade {

struct Result::Data {
    RunResult result;
    Grid grid;
    Recording recording;  ///< of which the result has rows
    std::string summary;  ///< JSON
    std::vector<std::string> notes;
};

struct Frame::Data {
    frana::Frame frame;
    Grid grid;
};

std::shared_ptr<const Result::Data> result_data(RunResult result, const EngineScene& prepared, const Grid& grid);

}  // namespace frana::facade
