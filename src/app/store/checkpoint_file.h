// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/store/frame_store.h"
#include "simulation/result.h"
#include "simulation/scene.h"

namespace frana::app {

/// Format of checkpoint files: increases with every change of the output of any serialise or of its use by a step. No
/// other format is read: a run begun by an older frana would not end with the same bits.
inline constexpr std::uint32_t k_checkpoint_format = 20;

/// Description in a checkpoint of its run.
struct CheckpointHead {
    std::string build;  ///< program, compiler and instruction set: the same ones give the same bits
    std::string scene;  ///< scene_identity of the run
    std::int64_t step = 0;
    double time = 0, end = 0;                ///< simulated [s]
    double wall_seconds = 0;                 ///< of all sessions so far
    std::vector<double> frame_times;         ///< of the frames on the disk [s]
    std::vector<std::string> log;            ///< lines so far
    std::optional<OriginCell> origin;        ///< cell of its local origin; none: as set by place_origin
    std::vector<FrameRecord> frame_records;  ///< of the files of frame_times
    std::string accuracy{};                  ///< record_text of the choice by numerics.accuracy; empty: not used
};

/// This program, in the form of CheckpointHead::build.
std::string checkpoint_build();

/// Writes a checkpoint aside, syncs it to the disk, and renames it.
///
///     8 bytes "frana ck", mark of byte order, format, size of the rest | head | state | CRC-32 of all before
///
/// @return bytes of the file
/// Throws Error(environment).
std::uint64_t write_checkpoint(const std::string& path, CheckpointHead head, const SaveState& state);

/// An open checkpoint whose every byte has been checked.
class CheckpointFile {
  public:
    /// Throws Error(input) with the reason if it cannot be used: truncated, damaged, no checkpoint, of a newer or older
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
