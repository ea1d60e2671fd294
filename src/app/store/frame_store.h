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
/// time_s). A separate thread writes them while the run continues, and lists the complete ones after each; at most two
/// wait, so that a slow disk delays the run instead of filling the memory. After a frame that cannot be written, it and
/// all later ones are kept in memory: the run must stop and save them.
class FrameWriter {
  public:
    /// `metadata` is written to every raster.
    /// @param times of existing frames [s]
    /// @param records of their files
    FrameWriter(std::string folder, std::map<std::string, std::string> metadata, ParticleFormats particles = {},
                std::vector<double> times = {}, std::vector<FrameRecord> records = {});
    /// Writes the added frames, unless an error occurred.
    ~FrameWriter();
    FrameWriter(const FrameWriter&) = delete;
    FrameWriter& operator=(const FrameWriter&) = delete;

    void add(Frame frame);
    /// Whether a frame could not be written.
    [[nodiscard]] bool failed() const noexcept { return failed_; }
    /// Waits until every frame so far is on the disk or has failed; returns the failed ones.
    [[nodiscard]] std::vector<Frame> settle();
    /// The files of all frames on the disk.
    [[nodiscard]] std::vector<FrameRecord> records() const;
    /// Greatest size in a checkpoint of the frames that settle() may return [bytes].
    [[nodiscard]] std::uint64_t most_bytes_waiting() const;
    /// Throws Error(environment) if a frame could not be written.
    void require_good();
    /// Waits for the last frame and lists all, including those that existed before. Throws Error(environment).
    void finish();
    /// After finish(): cuts the rasters of all frames to a window of their cells. The whole ones remain beside the
    /// folder (see frames_of_run) until the result is complete. Throws Error(environment).
    void cut_to(const CellWindow& window);
    /// Of all frames so far [s].
    [[nodiscard]] const std::vector<double>& times() const noexcept { return times_; }
    [[nodiscard]] double seconds() const noexcept { return seconds_; }  ///< wall time by which add() delayed the run
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
    std::size_t settled_;  // frames known to be on the disk
    std::vector<FrameRecord> records_;
    double seconds_ = 0;
    mutable std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<Job> waiting_;   // the first is being written
    std::exception_ptr error_;  // the first; no frame is written after it
    std::atomic<bool> failed_ = false;
    std::uint64_t largest_ = 0;  // of the frames so far [bytes]
    bool closed_ = false;
    std::thread thread_;
};

struct StoredFrame {
    double time = 0;  ///< [s]
    std::string folder;
    std::size_t index = 0;
    std::string particle_file;  ///< exists only if output.formats requests it

    /// Of any raster of the frames.
    [[nodiscard]] std::string raster_file(const std::string& name) const;
};

/// Returns the frames listed in frames.csv, at least one. Throws Error(input) if it is missing, empty or invalid.
std::vector<StoredFrame> stored_frames(const std::string& folder);

}  // namespace frana::app
