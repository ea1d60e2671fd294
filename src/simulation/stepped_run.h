// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "simulation/result.h"
#include "simulation/scene.h"

namespace frana {

/// The run of simulation.h, step by step. Refers to scene and options.
class SteppedRun {
  public:
    /// Throws as run() does.
    SteppedRun(const Scene& scene, const RunOptions& options);
    ~SteppedRun();

    /// Whether a step remains to be done.
    [[nodiscard]] bool continues() const;
    void step();
    [[nodiscard]] Progress progress() const;
    /// Returns the result; call once.
    RunResult finish();

    /// Of one model; called once a step.
    class OfModel;

  private:
    std::unique_ptr<OfModel> run_;
};

}  // namespace frana
