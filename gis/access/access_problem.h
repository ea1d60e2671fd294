// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

namespace frana::gis {

/// An access that a library requested while reading a file and that was refused: an address on the network, a special
/// file.
struct AccessProblem {
    std::string what, value, remedy;  ///< as in Problem
};

/// Called by the filters of the libraries' access (network, local_files). The function that reads the file reports the
/// first.
void note_access_problem(AccessProblem problem);

/// Returns the first since the last call, if any: the cause of the library's error.
[[nodiscard]] std::optional<AccessProblem> pop_access_problem();

}  // namespace frana::gis
