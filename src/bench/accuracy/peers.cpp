// SPDX-License-Identifier: Apache-2.0
#include "bench/accuracy/peers.h"

namespace frana::bench {
namespace {

constexpr std::string_view k_mean = "mean depth error [m]", k_depth_error = "relative L2 of depth",
                           k_momentum = "relative L2 of momentum",
                           k_depth_random = "relative L2 of depth, random particles",
                           k_momentum_random = "relative L2 of momentum, random particles";

constexpr PeerResult k_peers[] = {
    {"stoker", "GeoClaw, order 2", 5, k_mean, 0.0231, 0.14},
    {"stoker", "GeoClaw, order 2", 2.5, k_mean, 0.0119, 0.85},
    {"stoker", "GeoClaw, order 2", 1.25, k_mean, 0.0061, 6.1},
    {"stoker", "GeoClaw, order 2", 0.625, k_mean, 0.0031, 50},
    {"stoker", "D-Claw 1.0", 2.5, k_mean, 0.0096, 4.6},
    {"stoker", "TITAN2D, order 2", 2.9, k_mean, 0.0177, 1.9},
    {"stoker", "r.avaflow", 5, k_mean, 0.0245, 3.2},
    {"ritter", "GeoClaw, order 2", 5, k_mean, 0.0344, 0.17},
    {"ritter", "GeoClaw, order 2", 2.5, k_mean, 0.0176, 1.07},
    {"ritter", "GeoClaw, order 2", 1.25, k_mean, 0.0090, 7.8},
    {"ritter", "GeoClaw, order 2", 0.625, k_mean, 0.0049, 59},
    {"ritter", "D-Claw 1.0", 2.5, k_mean, 0.0151, 5.2},
    {"ritter", "TITAN2D, order 2", 2.9, k_mean, 0.0197, 1.7},
    {"ritter", "r.avaflow", 5, k_mean, 0.060, 2.5},
    {"similarity", "com1DFA", 5, k_depth_error, 0.049, 0},
    {"similarity", "com1DFA", 5, k_momentum, 0.061, 0},
    {"similarity", "com1DFA", 3, k_depth_error, 0.036, 0},
    {"similarity", "com1DFA", 3, k_momentum, 0.048, 0},
    {"similarity", "com1DFA", 2, k_depth_error, 0.028, 78},
    {"similarity", "com1DFA", 2, k_momentum, 0.039, 78},
    {"granular-slope", "com1DFA", 5, k_depth_random, 0.100, 0},
    {"granular-slope", "com1DFA", 5, k_momentum_random, 0.91, 0},
    {"granular-slope", "com1DFA", 2, k_depth_random, 0.059, 0},
    {"granular-slope", "com1DFA", 2, k_momentum_random, 0.54, 0},
    {"granular-slope", "com1DFA", 5, k_depth_error, 0.045, 0},
    {"granular-slope", "com1DFA", 5, k_momentum, 0.14, 0},
};

}  // namespace

std::span<const PeerResult> peer_results() {
    return k_peers;
}

}  // namespace frana::bench
