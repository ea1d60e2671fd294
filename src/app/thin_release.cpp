// SPDX-License-Identifier: Apache-2.0
#include "app/thin_release.h"

#include "app/number_text.h"
#include "core/json.h"

namespace frana::app {

void warn_of_thin_release(const RunEstimate& expected, const Scene& scene, RunLog& log) {
    if (expected.thin_share <= k_thin_share) return;
    log.warn(
        figure(100 * expected.thin_share, 2) + " % of the release is thinner than numerics.minimum-depth = " +
        shortest_text(scene.numerics.minimum_depth) +
        " m: maps and figures do not show it; set the key to about a hundredth of the flow's usual depth");
}

}  // namespace frana::app
