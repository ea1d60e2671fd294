// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include "facade/frana.h"

namespace frana::facade {

std::string version() {
    return FRANA_VERSION;
}

Error::Error(const std::string& text, std::vector<Problem> problems)
    : std::runtime_error(text), problems_(std::move(problems)) {}
Error::~Error() = default;

RunFailed::RunFailed(const std::string& text, std::vector<Problem> problems, Result result)
    : Error(text, std::move(problems)), result_(std::move(result)) {}
RunFailed::~RunFailed() = default;

}  // namespace frana::facade
