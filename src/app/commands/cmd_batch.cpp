// SPDX-License-Identifier: Apache-2.0
#include "app/commands/commands.h"
#include "app/commands/run_study.h"
#include "core/error.h"
#include "study/read_region.h"

namespace frana::app {
namespace {

void require_region(const std::string& file) {
    if (!study::is_region(file))
        throw Error(ErrorKind::input,
                    Problem{"has no section [region]", file, "", "",
                            "A single scene runs with `frana run`, a study with `frana ensemble`; a region names its "
                            "scene under [region]"});
}

}  // namespace

int cmd_batch(const Arguments& arguments) {
    return run_study({"batch", "REGION.ini",
                      "Runs each polygon of a release layer as a slope of its own, in a window of the terrain, and "
                      "writes their union:\ngreatest depth, speed and pressure, how many slopes reach each cell and "
                      "which is the worst, maps of each scenario,\nthe degree of hazard, one table, one project.",
                      "-region", "region", require_region},
                     arguments);
}

}  // namespace frana::app
