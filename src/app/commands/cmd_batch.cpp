// SPDX-License-Identifier: Apache-2.0
#include "app/commands/commands.h"
#include "app/commands/run_study.h"
#include "app/study/plan/read_study.h"

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

CommandForm batch_form() {
    return study_form("batch",
                      "Runs each polygon of a release layer as a slope of its own, in a window of the terrain, and "
                      "writes their union:\ngreatest depth, speed and pressure, how many slopes reach each cell and "
                      "which is the worst, maps of each scenario,\nthe degree of hazard, one table, one project.",
                      "that of the scene, with -region", "region", "REGION.ini");
}

int cmd_batch(const Arguments& arguments) {
    return run_study(batch_form(), require_region, arguments);
}

}  // namespace frana::app
