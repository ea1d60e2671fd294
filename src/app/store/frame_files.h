// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "simulation/result.h"

namespace frana::app {

/// Formats of a frame's particles, if it has any: frames/particles_0000.gpkg, .vtp.
struct ParticleFormats {
    bool gpkg = false, vtp = false;

    [[nodiscard]] bool any() const noexcept { return gpkg || vtp; }
};
/// Returns those in output.formats.
ParticleFormats particle_formats(const std::vector<std::string>& formats);

/// Returns the folder in a result with the frames as the run wrote them, which --resume continues: frames.whole where
/// they were cut, else frames.
std::string frames_of_run(const std::string& result);

/// One file of a frame: "depth" and ".tif" are depth_0012.tif in frame 12.
struct FrameFile {
    std::string what, ending;
};

inline const FrameFile k_depth_file{"depth", ".tif"}, k_velocity_file{"velocity", ".tif"},
    k_particle_table{"particles", ".gpkg"}, k_particle_cloud{"particles", ".vtp"};

/// Returns all files of a frame: depth, velocity, those of Frame::more, particles. The one list for writing, searching,
/// linking and checking frames.
std::vector<FrameFile> frame_files(const Frame& frame, ParticleFormats formats);

/// Returns FOLDER/WHAT_0012.ENDING
std::string frame_path(const std::string& folder, const FrameFile& file, std::size_t index);

/// Returns the number in the name of a frame's file: "depth_0012.tif" is 12; none for other names.
std::optional<std::size_t> frame_index(const std::string& name);

/// Size and checksum of a frame's file as written.
struct FrameRecord {
    std::string name;
    std::uint64_t bytes = 0;
    std::uint32_t sum = 0;  ///< CRC-32
};

/// Throws Error(environment) if it cannot be read.
FrameRecord record_of(const std::string& path);

/// Returns the files in a folder of its first `count` frames, by their names alone.
std::vector<std::string> names_of_frames(const std::string& folder, std::size_t count);

/// Returns the problem of the first `count` frames in a folder: one that is missing or differs from its record; empty:
/// none. Without records (checkpoints up to format 4) every frame must have the files of the first one.
std::string frame_problem(const std::string& folder, std::size_t count, const std::vector<FrameRecord>& records);

}  // namespace frana::app
