// SPDX-License-Identifier: Apache-2.0
#include "app/study/calibration_spec.h"

namespace frana::app::study {

const char* source_of(Evidence evidence) {
    switch (evidence) {
        case Evidence::scar:
            return "observed.perimeter in the scene";
        case Evidence::runout:
            return "observed.perimeter in the scene, or runout in [event NAME]";
        case Evidence::deposit:
            return "observed.deposit in the scene";
        case Evidence::elevation_change:
            return "observed.deposit in the scene, as a raster";
        case Evidence::arrival:
            return "arrival GAUGE in [event NAME]";
        case Evidence::speed:
            return "speed GAUGE in [event NAME]";
        case Evidence::depth:
            break;
    }
    return "depth GAUGE in [event NAME]";
}

std::size_t CalibrationSpec::key_count() const {
    return first_own_key(events.size());
}

std::size_t CalibrationSpec::first_own_key(std::size_t event) const {
    std::size_t keys = study.vary.size();
    for (std::size_t e = 0; e < event; ++e) keys += events[e].vary.size();
    return keys;
}

}  // namespace frana::app::study
