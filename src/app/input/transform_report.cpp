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

void report_transform(const std::string& input, const gis::TransformInfo& transform, double cell_size, RunLog& log) {
    if (in_place(transform)) return;
    log.note(input + " transformed by: " + transform_text(transform) + ", accuracy " + accuracy_text(transform));
    if (transform.accuracy_m < 0) {
        log.warn(input + ": the accuracy of its transformation is unknown (" + transform.operation +
                 "); its position may be wrong by metres to hundreds of metres");
    } else if (transform.accuracy_m > cell_size / 2) {
        log.warn(input + ": its position is accurate to " + accuracy_text(transform) + " only; half a cell is " +
                 number_text(cell_size / 2, 3) + " m (" + transform.operation + ")");
    }
    if (!transform.needs_missing_grid) return;
    std::string better = "a more accurate transformation";
    if (transform.missing_accuracy_m >= 0) better += " (" + number_text(transform.missing_accuracy_m, 3) + " m)";
    log.warn(input + ": " + better + " needs the grid file" +
             (transform.missing_grid.empty() ? "" : " " + transform.missing_grid + ",") +
             " which is not installed (see Debian's proj-data, or projsync)");
}

}  // namespace frana::app
