// SPDX-License-Identifier: Apache-2.0
#include "app/commands/commands.h"
#include "app/commands/run_study.h"
#include "app/study/plan/read_study.h"

namespace frana::app {
namespace {

void refuse_region(const std::string& file) {
    if (study::is_region(file))
        throw Error(ErrorKind::input, Problem{"is a region of many slopes", file, "", "a study, with [study]",
                                              "Run it with `frana batch`"});
}

}  // namespace

CommandForm ensemble_form() {
    return study_form("ensemble",
                      "Runs a scene many times with values drawn from their distributions and writes what the runs say "
                      "together:\nprobabilities, quantiles, sensitivities, with maps, charts, tables and a report.",
                      "that of the scene, with -ensemble", "study");
}

int cmd_ensemble(const Arguments& arguments) {
    return run_study(ensemble_form(), refuse_region, arguments);
}

}  // namespace frana::app
