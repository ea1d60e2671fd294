// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

namespace frana::bench {

/// The result of another program for one of the cases, as measured or published. Seconds are those of its own machine
/// (the compiled ones: 2 cores of 2.4 GHz) and only indicative.
struct PeerResult {
    std::string_view case_name, code;
    double cell_size;          ///< [m]
    std::string_view measure;  ///< "mean depth error [m]", "relative L2 of depth", "relative L2 of momentum"
    double value;
    double seconds;  ///< on one thread; 0: not known
};

/// GeoClaw, D-Claw, TITAN2D and r.avaflow on stoker and ritter; AvaFrame com1DFA on similarity and
/// granular-slope.
std::span<const PeerResult> peer_results();

}  // namespace frana::bench
