// SPDX-License-Identifier: Apache-2.0
#include "app/ensemble/mapped_events.h"

#include "app/publish/publish_hazard.h"
#include "core/shortest_text.h"

namespace frana::app {

std::vector<MappedEvents> mapped_events(const SceneSpec& scene) {
    std::vector<MappedEvents> all;
    const auto add = [&](study::Quantity quantity, const std::string& name, const std::vector<double>& thresholds) {
        MappedEvents events{quantity, thresholds, {}};
        for (const double threshold : thresholds)
            events.rasters.push_back("probability_" + name + "_" + shortest_text(threshold));
        all.push_back(std::move(events));
    };
    add(study::Quantity::depth, "depth", scene.output.depth_thresholds);
    add(study::Quantity::velocity, "velocity", scene.output.velocity_thresholds);
    if (!scene.output.pressure_thresholds.empty())
        add(study::Quantity::pressure, "pressure", scene.output.pressure_thresholds);
    if (const auto scheme = hazard_scheme_of(scene)) {
        MappedEvents events{study::Quantity::intensity, {}, {}};
        for (const HazardClass& kind : scheme->classes) {
            events.thresholds.push_back(kind.value - 0.5);  // classes are whole numbers
            events.rasters.push_back("probability_intensity_" + std::to_string(kind.value));
        }
        all.push_back(std::move(events));
    }
    return all;
}

study::RecordExtras record_extras(const SceneSpec& scene) {
    return {!scene.output.pressure_thresholds.empty(), hazard_scheme_of(scene)};
}

}  // namespace frana::app
