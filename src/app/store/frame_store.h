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

#include "core/raster.h"
#include "simulation/result.h"

namespace frana::app {

/// Returns the folder in a result with the frames as the run wrote them, which --resume continues: frames.whole where
/// they were cut, else frames.
std::string frames_of_run(const std::string& result);

/// One file of a frame: "depth" and ".tif" are depth_0012.tif in frame 12.
struct FrameFile {
    std::string what, ending;
};

inline const FrameFile k_depth_file{"depth", ".tif"}, k_velocity_file{"velocity", ".tif"},
    k_particle_table{"particles", ".gpkg"};

/// Returns all files of a frame: depth, velocity, those of Frame::more, particles. The one list for writing, searching,
/// linking and checking frames.
std::vector<FrameFile> frame_files(const Frame& frame, bool particles);

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

/// Returns the problem of frames in a folder: one that is missing or differs from its record; empty: none.
std::string frame_problem(const std::string& folder, const std::vector<FrameRecord>& records);

/// Frames as files: FOLDER/depth_0000.tif, velocity_0000.tif, those of Frame::more, particles, and frames.csv (index,
/// time_s, moved_m3: volume that has come to other cells up to the frame). A separate thread writes them while the run
/// continues, and lists the complete ones after each; at most two wait, so that a slow disk delays the run instead of
/// filling the memory. After a frame that cannot be written none is: the run must stop.
class FrameWriter {
  public:
    /// `metadata` is written to every raster.
    /// @param times of existing frames [s]
    /// @param records of their files
    FrameWriter(std::string folder, std::map<std::string, std::string> metadata, bool particles = false,
                std::vector<double> times = {}, std::vector<FrameRecord> records = {});
    /// Writes the added frames, unless an error occurred.
    ~FrameWriter();
    FrameWriter(const FrameWriter&) = delete;
    FrameWriter& operator=(const FrameWriter&) = delete;

    void add(Frame frame);
    /// Whether a frame could not be written.
    [[nodiscard]] bool failed() const noexcept { return failed_; }
    /// Waits until every frame so far is on the disk; false: one could not be written.
    [[nodiscard]] bool settle();
    /// The files of all frames on the disk.
    [[nodiscard]] std::vector<FrameRecord> records() const;
    /// Throws Error(environment) if a frame could not be written.
    void require_good();
    /// Waits for the last frame and lists all, including those that existed before. Throws Error(environment).
    void finish();
    /// After finish(): cuts the rasters of all frames to a window of their cells. The whole ones remain beside the
    /// folder (see frames_of_run) until the result is complete. Throws Error(environment).
    void cut_to(const CellWindow& window, int threads);
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
    void list(const std::vector<double>& times) const;
    void follow(const Raster& depth);
    void follow_written(std::size_t count);
    void serve();

    std::string folder_;
    std::map<std::string, std::string> metadata_;
    bool particles_;
    std::vector<double> times_;
    std::vector<FrameRecord> records_;
    std::vector<double> moved_;  ///< up to each frame that is written [m3]
    Raster before_;              ///< depth of the last of them
    double seconds_ = 0;
    mutable std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<Job> waiting_;   // the first is being written
    std::exception_ptr error_;  // the first; no frame is written after it
    std::atomic<bool> failed_ = false;
    bool closed_ = false;
    std::thread thread_;
};

struct StoredFrame {
    double time = 0;   ///< [s]
    double moved = 0;  ///< volume that has come to other cells until then [m3], rising
    std::string folder;
    std::size_t index = 0;
    std::string particle_file;  ///< exists only if output.formats requests it

    /// Of any raster of the frames.
    [[nodiscard]] std::string raster_file(const std::string& name) const;
};

/// Returns the frames listed in frames.csv, at least one. Throws Error(input) if it is missing, empty or invalid.
std::vector<StoredFrame> stored_frames(const std::string& folder);

}  // namespace frana::app
