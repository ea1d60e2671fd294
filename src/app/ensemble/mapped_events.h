// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "params/keys/scene_spec.h"
#include "study/member_record.h"

namespace frana::app {

/// Events "a quantity exceeds a threshold" whose probability a study maps.
struct MappedEvents {
    study::Quantity quantity = study::Quantity::depth;
    std::vector<double> thresholds;
    std::vector<std::string> rasters;  ///< for each threshold: "probability_depth_0.5"
};

/// Returns the events of a scene: its thresholds of depth, velocity and pressure, and the classes of intensity, each
/// with all higher ones.
std::vector<MappedEvents> mapped_events(const SceneSpec& scene);

/// Returns what a member's record must contain for them.
study::RecordExtras record_extras(const SceneSpec& scene);

}  // namespace frana::app
