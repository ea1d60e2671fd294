// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

namespace frana::gis {

/// What a library wanted while it read a file, and was not given: a place on the network, a file that is no
/// file.
struct Refusal {
    std::string what, value, remedy;  ///< as in Problem
};

/// For the doors through which libraries read (network, local_files). Whoever reads the file learns of the
/// first.
void note_refusal(Refusal refusal);

/// The first since the last call, if there was any: the cause of whatever the library says then.
[[nodiscard]] std::optional<Refusal> pop_refusal();

}  // namespace frana::gis
