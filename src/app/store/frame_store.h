// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <exception>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "app/store/frame_files.h"
#include "core/raster.h"
#include "simulation/result.h"

namespace frana::app {

/// Frames as files: FOLDER/depth_0000.tif, velocity_0000.tif, those of Frame::more, particles, and frames.csv (index,
/// time_s). A thread of its own writes them while the run goes on, and lists what is whole after each; at most two
/// wait, so that a slow disk holds the run back and not the memory. Once a frame cannot be written it and all after it
/// are kept in memory: the run is to stop and save them.
class FrameWriter {
  public:
    /// `metadata` goes into every raster.
    /// @param times of frames that are there already [s]
    /// @param records of their files
    FrameWriter(std::string folder, std::map<std::string, std::string> metadata, ParticleFormats particles = {},
                std::vector<double> times = {}, std::vector<FrameRecord> records = {});
    /// Writes what was added, if nothing has failed.
    ~FrameWriter();
    FrameWriter(const FrameWriter&) = delete;
    FrameWriter& operator=(const FrameWriter&) = delete;

    void add(Frame frame);
    /// Whether a frame could not be written.
    [[nodiscard]] bool failed() const noexcept { return failed_; }
    /// Waits until every frame so far is on the disk or has failed; returns those that are not there.
    [[nodiscard]] std::vector<Frame> settle();
    /// The files of all frames that are on the disk.
    [[nodiscard]] std::vector<FrameRecord> records() const;
    /// What settle() may return, as a checkpoint holds it [bytes].
    [[nodiscard]] std::uint64_t most_bytes_waiting() const;
    /// Throws Error(environment) when a frame could not be written.
    void require_good();
    /// Waits for the last frame and lists all, also those that were there already. Throws Error(environment).
    void finish();
    /// Of all frames so far [s].
    [[nodiscard]] const std::vector<double>& times() const noexcept { return times_; }
    [[nodiscard]] double seconds() const noexcept { return seconds_; }  ///< wall time that add() held the run back
    [[nodiscard]] int count() const noexcept { return static_cast<int>(times_.size()); }

  private:
    struct Job {
        std::size_t index;
        Frame frame;
    };
    static constexpr std::size_t k_most_waiting = 2;

    [[nodiscard]] std::vector<FrameRecord> write(const Job& job) const;
    void write(const FrameFile& file, const Job& job) const;
    void wait_until_written(std::unique_lock<std::mutex>& lock);
    void list(const std::vector<double>& times) const;
    void list_particles(const std::vector<double>& times) const;
    void serve();

    std::string folder_;
    std::map<std::string, std::string> metadata_;
    ParticleFormats particles_;
    std::vector<double> times_;
    std::size_t settled_;  // frames that are on the disk for good
    std::vector<FrameRecord> records_;
    double seconds_ = 0;
    mutable std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<Job> waiting_;   // the first is being written
    std::exception_ptr error_;  // the first; nothing is written after it
    std::atomic<bool> failed_ = false;
    std::uint64_t largest_ = 0;  // of the frames so far [bytes]
    bool closed_ = false;
    std::thread thread_;
};

struct StoredFrame {
    double time = 0;  ///< [s]
    std::string depth_file;
    std::string velocity_file;
    std::string particle_file;  ///< there only where output.formats asked for it
};

/// What frames.csv lists, at least one. Throws Error(input) when it is missing, empty or broken.
std::vector<StoredFrame> stored_frames(const std::string& folder);

}  // namespace frana::app
