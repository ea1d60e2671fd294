// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/store/frame_files.h"
#include "app/store/reserved_space.h"
#include "simulation/result.h"
#include "simulation/scene_origin.h"

namespace frana::app {

/// Format of checkpoint files: counts up with every change of what any serialise writes or of what a step does with it.
/// No other is read: what an older frana began, this one would not end with the same bits.
inline constexpr std::uint32_t k_checkpoint_format = 9;

/// What a checkpoint tells of the run that it belongs to.
struct CheckpointHead {
    std::string build;  ///< program, compiler and instructions: same ones, same bits
    std::string scene;  ///< scene_identity of the run
    std::int64_t step = 0;
    double time = 0, end = 0;                ///< simulated [s]
    double wall_seconds = 0;                 ///< of all sessions so far
    std::vector<double> frame_times;         ///< of the frames that were on disk [s]
    std::vector<Frame> waiting;              ///< frames after those, which the disk would not take; without their grid
    std::vector<std::string> log;            ///< lines so far
    std::optional<OriginCell> origin;        ///< that its places count from; none: where place_origin puts it
    std::vector<FrameRecord> frame_records;  ///< of the files of frame_times
};

/// This program, as CheckpointHead::build tells it.
std::string checkpoint_build();

/// Writes a checkpoint beside its place, waits until it is on the disk, and renames it.
///
///     8 bytes "frana ck", mark of byte order, format, size of the rest | head | state | CRC-32 of all before
///
/// @param space to be written into, if there is any; then no room is needed but what it lacks
/// @return bytes of the file
/// Throws Error(environment).
std::uint64_t write_checkpoint(const std::string& path, CheckpointHead head, const SaveState& state,
                               ReservedSpace& space);

/// Bytes that write_checkpoint would write.
std::uint64_t checkpoint_bytes(CheckpointHead head, const SaveState& state);

/// An open checkpoint of which every byte has been checked.
class CheckpointFile {
  public:
    /// Throws Error(input) saying why it cannot be used: cut short, damaged, no checkpoint at all, of a newer or older
    /// format, of a machine with another byte order.
    explicit CheckpointFile(const std::string& path);
    ~CheckpointFile();
    CheckpointFile(const CheckpointFile&) = delete;
    CheckpointFile& operator=(const CheckpointFile&) = delete;

    [[nodiscard]] const std::string& path() const noexcept;
    [[nodiscard]] const CheckpointHead& head() const noexcept;
    /// The state, to be read once.
    [[nodiscard]] StateReader& state() noexcept;

  private:
    struct Open;
    std::unique_ptr<Open> open_;
};

}  // namespace frana::app
