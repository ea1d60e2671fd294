// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <chrono>
#include <cstddef>

namespace frana::voellmy_bingham {

/// The parts of a time step that are timed.
enum class Stage : unsigned char {
    particles_to_nodes,  ///< clearing the nodes; mass, momentum, area and sums for the levels to the nodes
    levels,              ///< still level or mean depth, and support, per node
    pressure,            ///< pressure, slope and in-plane stress to the nodes
    nodes,               ///< driving forces, friction, maxima
    nodes_to_particles,  ///< velocity, position, depth, shape; stress if there is any
    sort,
    resample,
    count
};
inline constexpr std::size_t k_stages = static_cast<std::size_t>(Stage::count);
inline constexpr std::array<const char*, k_stages> k_stage_names{"particles to nodes",
                                                                 "levels",
                                                                 "pressure and stress",
                                                                 "nodes and maxima",
                                                                 "nodes to particles",
                                                                 "sort",
                                                                 "resample"};

/// Wall time of a step's stages [s].
using StageSeconds = std::array<double, k_stages>;

/// Adds the time since the last call to the stage that has just ended.
class StageWatch {
  public:
    explicit StageWatch(StageSeconds& seconds) : seconds_(seconds) {}
    void ends(Stage stage) {
        const auto now = std::chrono::steady_clock::now();
        seconds_[static_cast<std::size_t>(stage)] += std::chrono::duration<double>(now - last_).count();
        last_ = now;
    }

  private:
    StageSeconds& seconds_;
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace frana::voellmy_bingham
