// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <boost/program_options/variables_map.hpp>
#include <string>

namespace frana::app {

/// Runs `frana bench robustness SCENE.ini`: prints the table and writes robustness.csv and robustness.json to --out.
/// Returns the exit code: numerical if a run ended early. Throws Error.
int bench_robustness(const std::string& scene, const boost::program_options::variables_map& values);

}  // namespace frana::app
