// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <boost/program_options/variables_map.hpp>
#include <string>

namespace frana::app {

/// `frana bench estimate SCENE.ini`: computes all levels of numerics.accuracy and the scene's own cells, prints for
/// each level estimates and true changes against the scene's own cells, and writes estimate.csv into --out. Returns the
/// exit code: numerical where a level ended early. Throws Error.
int bench_estimate(const std::string& scene, const boost::program_options::variables_map& values);

/// `frana bench ensemble STUDY.ini`: computes maps of probability by plain, Latin hypercube, Sobol' and multilevel
/// sampling with several numbers of members and seeds, prints their errors against a large reference and their cost,
/// and writes ensemble.csv and ensemble.png into --out. Returns the exit code. Throws Error.
int bench_ensemble(const std::string& study, const boost::program_options::variables_map& values);

}  // namespace frana::app
