// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "simulation/result.h"

namespace frana::app {

/// How a frame's particles are written, where it has any: frames/particles_0000.gpkg, .vtp.
struct ParticleFormats {
    bool gpkg = false, vtp = false;

    [[nodiscard]] bool any() const noexcept { return gpkg || vtp; }
};
/// What output.formats says of them.
ParticleFormats particle_formats(const std::vector<std::string>& formats);

/// One file of a frame: "depth" and ".tif" are depth_0012.tif in frame 12.
struct FrameFile {
    std::string what, ending;
};

inline const FrameFile k_depth_file{"depth", ".tif"}, k_velocity_file{"velocity", ".tif"},
    k_particle_table{"particles", ".gpkg"}, k_particle_cloud{"particles", ".vtp"};

/// All files of a frame: depth, velocity, those of Frame::more, particles. Whoever writes, looks for, links or checks
/// frames takes them from here.
std::vector<FrameFile> frame_files(const Frame& frame, ParticleFormats formats);

/// FOLDER/WHAT_0012.ENDING
std::string frame_path(const std::string& folder, const FrameFile& file, std::size_t index);

/// The number in the name of a frame's file: "depth_0012.tif" is 12; none for other names.
std::optional<std::size_t> frame_index(const std::string& name);

/// A frame's file as it was written, to know it again.
struct FrameRecord {
    std::string name;
    std::uint64_t bytes = 0;
    std::uint32_t sum = 0;  ///< CRC-32
};

/// Throws Error(environment) when it cannot be read.
FrameRecord record_of(const std::string& path);

/// The files that a folder has of its first `count` frames, without saying more of them than their names.
std::vector<std::string> names_of_frames(const std::string& folder, std::size_t count);

/// What is wrong with the first `count` frames in a folder: one that is not there any more, or not as it was recorded;
/// empty: nothing. Without records (checkpoints up to format 4) every frame must have what the first one has.
std::string frame_problem(const std::string& folder, std::size_t count, const std::vector<FrameRecord>& records);

}  // namespace frana::app
