// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <boost/program_options/variables_map.hpp>
#include <string>

namespace frana::app {

/// `frana bench robustness SCENE.ini`: prints the table and writes robustness.csv and robustness.json into
/// --out. Returns the exit code: numerical where a run ended early. Throws Error.
int bench_robustness(const std::string& scene, const boost::program_options::variables_map& values);

}  // namespace frana::app
