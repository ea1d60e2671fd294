// SPDX-License-Identifier: Apache-2.0
#include "app/input/thin_release.h"

#include "app/text/number_text.h"
#include "core/shortest_text.h"

namespace frana::app {

void warn_of_thin_release(const RunEstimate& expected, const Scene& scene, RunLog& log) {
    const auto warn = [&](double fraction, const char* key, double depth, const char* then) {
        if (fraction <= k_thin_fraction) return;
        log.warn(worded("{1} % of the release is thinner than {2} = {3} m: {4}",
                        {numeral(number_text(100 * fraction, 2)), key, shortest_text(depth), then}));
    };
    warn(expected.thin_fraction, "numerics.minimum-depth", scene.numerics.minimum_depth,
         worded("maps and results do not include it; set the key to about a hundredth of the usual flow depth"));
    if (scene.time.trace_threshold > scene.numerics.minimum_depth)
        warn(expected.untraced_fraction, "output.trace-threshold", scene.time.trace_threshold,
             worded(
                 "outlines, covered area and run-out do not include it; set the key to about a tenth of the usual flow "
                 "depth"));
}

}  // namespace frana::app
