// SPDX-License-Identifier: Apache-2.0
#include "app/input/transform_report.h"

#include "app/text/number_text.h"

namespace frana::app {
namespace {

bool in_place(const gis::TransformInfo& transform) {
    return transform.operation.empty() || transform.operation == "none";
}

}  // namespace

std::string accuracy_text(const gis::TransformInfo& transform) {
    if (transform.accuracy_m < 0) return "unknown";
    return transform.accuracy_m == 0 ? "exact" : number_text(transform.accuracy_m, 3) + " m";
}

std::string transform_text(const gis::TransformInfo& transform) {
    return in_place(transform) ? "none" : transform.operation;
}

void report_transform(const Sentence& input, const gis::TransformInfo& transform, double cell_size, RunLog& log) {
    if (in_place(transform)) return;
    log.note(input.text() + " transformed by: " + transform_text(transform) + ", accuracy " + accuracy_text(transform));
    if (transform.accuracy_m < 0) {
        log.warn(worded(
            "{1}: the accuracy of its transformation is unknown ({2}); its position may be wrong by metres to hundreds "
            "of metres",
            {input, transform.operation}));
    } else if (transform.accuracy_m > cell_size / 2) {
        log.warn(worded("{1}: its position is accurate to {2} m only; half a cell is {3} m ({4})",
                        {input, numeral(number_text(transform.accuracy_m, 3)), numeral(number_text(cell_size / 2, 3)),
                         transform.operation}));
    }
    if (!transform.needs_missing_grid) return;
    const Sentence better =
        transform.missing_accuracy_m >= 0
            ? worded("a more accurate transformation ({1} m)", {numeral(number_text(transform.missing_accuracy_m, 3))})
            : worded("a more accurate transformation");
    if (transform.missing_grid.empty())
        log.warn(worded("{1}: {2} needs a grid file which is not installed (see Debian's proj-data, or projsync)",
                        {input, better}));
    else
        log.warn(
            worded("{1}: {2} needs the grid file {3}, which is not installed (see Debian's proj-data, or projsync)",
                   {input, better, transform.missing_grid}));
}

}  // namespace frana::app
