// SPDX-License-Identifier: Apache-2.0
#include "app/store/frame_store.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "analysis/trace.h"
#include "app/process/terminal.h"
#include "app/store/result_files.h"
#include "app/text/number_text.h"
#include "app/text/text_file.h"
#include "core/error.h"
#include "core/files.h"
#include "core/text.h"
#include "core/thread_pool.h"
#include "gis/raster/raster_in.h"
#include "gis/raster/raster_out.h"
#include "gis/vector/vector_out.h"
#include "params/grammar/value_text.h"
#include "params/keys/result_rasters.h"

namespace frana::app {
namespace {

namespace fs = std::filesystem;

std::string frame_name(const FrameFile& file, std::size_t index) {
    char number[16];
    std::snprintf(number, sizeof number, "_%04zu", index);
    return file.what + number + file.ending;
}

}  // namespace

std::string frames_of_run(const std::string& result) {
    const fs::path whole = fs::path(result) / k_whole_frames;
    return fs::is_directory(whole) ? whole.string() : (fs::path(result) / k_frame_folder).string();
}

std::vector<FrameFile> frame_files(const Frame& frame, bool particles) {
    std::vector<FrameFile> files{k_depth_file, k_velocity_file};
    for (const NamedRaster& raster : frame.more) files.push_back({raster.name, ".tif"});
    if (particles) files.push_back(k_particle_table);
    return files;
}

std::string frame_path(const std::string& folder, const FrameFile& file, std::size_t index) {
    return (fs::path(folder) / frame_name(file, index)).string();
}

std::optional<std::size_t> frame_index(const std::string& name) {
    constexpr std::size_t k_most_digits = 15;
    const auto place = name.rfind('_');
    if (place == std::string::npos) return std::nullopt;
    const std::string ending = fs::path(name).extension().string();
    const auto is_its = [&](const FrameFile& file) { return file.ending == ending; };
    const std::array<FrameFile, 2> endings{k_depth_file, k_particle_table};
    if (std::none_of(endings.begin(), endings.end(), is_its) || name.size() < place + 1 + ending.size())
        return std::nullopt;
    const std::string digits = name.substr(place + 1, name.size() - place - 1 - ending.size());
    if (digits.empty() || digits.size() > k_most_digits || digits.find_first_not_of("0123456789") != std::string::npos)
        return std::nullopt;
    return static_cast<std::size_t>(std::stoull(digits));
}

FrameRecord record_of(const std::string& path) {
    FrameRecord record{fs::path(path).filename().string(), 0, 0};
    std::ifstream file(path, std::ios::binary);
    std::vector<char> buffer(1 << 16);
    uLong sum = 0;
    while (file.read(buffer.data(), static_cast<std::streamsize>(buffer.size())) || file.gcount() > 0) {
        const auto part = static_cast<std::size_t>(file.gcount());
        sum = crc32_z(sum, reinterpret_cast<const Bytef*>(buffer.data()), part);
        record.bytes += part;
    }
    if (!file.eof()) throw Error(ErrorKind::environment, Problem{"cannot be read", path, "", "", ""});
    record.sum = static_cast<std::uint32_t>(sum);
    return record;
}

std::vector<std::string> names_of_frames(const std::string& folder, std::size_t count) {
    std::vector<std::string> names;
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
        std::string name = entry.path().filename().string();
        const auto index = frame_index(name);
        if (index && *index < count) names.push_back(std::move(name));
    }
    std::sort(names.begin(), names.end());
    return names;
}

std::string frame_problem(const std::string& folder, const std::vector<FrameRecord>& records) {
    for (const FrameRecord& record : records) {
        const std::string path = (fs::path(folder) / record.name).string();
        std::error_code error;
        const std::uint64_t bytes = fs::file_size(path, error);
        if (error) return "is missing: " + path;
        if (bytes != record.bytes || record_of(path).sum != record.sum) return "is not as it was written: " + path;
    }
    return {};
}

namespace {

std::string list_file(const std::string& folder) {
    return (fs::path(folder) / fs::path(k_frame_list).filename()).string();
}

gis::BandText band_text(const std::string& what, const std::map<std::string, std::string>& metadata) {
    const ResultRaster* const row = find_result_raster(what);
    if (row == nullptr) return {what, what, "", metadata};
    std::string text = row->title + " at one instant";
    if (row->kind == ResultRaster::Kind::frame || row->is_flow_depth)
        text = directed_description(*row, what, gis::depth_direction_in(metadata));
    return {what, text, row->unit, metadata};
}

const Raster& raster_of(const Frame& frame, const std::string& what) {
    if (what == k_depth_file.what) return frame.depth;
    if (what == k_velocity_file.what) return frame.velocity;
    return std::find_if(frame.more.begin(), frame.more.end(), [&](const NamedRaster& one) { return one.name == what; })
        ->values;
}

}  // namespace

FrameWriter::FrameWriter(std::string folder, std::map<std::string, std::string> metadata, bool particles,
                         std::vector<double> times, std::vector<FrameRecord> records)
    : folder_(std::move(folder)),
      metadata_(std::move(metadata)),
      particles_(particles),
      times_(std::move(times)),
      records_(std::move(records)),
      thread_([this] { serve(); }) {}

FrameWriter::~FrameWriter() {
    {
        const std::lock_guard lock(mutex_);
        closed_ = true;
    }
    changed_.notify_all();
    thread_.join();
}

void FrameWriter::add(Frame frame) {
    const Stopwatch watch;
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return error_ || waiting_.size() < k_most_waiting; });
    const double time = frame.time;
    waiting_.push_back({times_.size(), std::move(frame)});
    times_.push_back(time);
    lock.unlock();
    changed_.notify_all();
    seconds_ += watch.seconds();
}

std::vector<FrameRecord> FrameWriter::write(const Job& job) const {
    std::vector<FrameRecord> records;
    for (const FrameFile& file : frame_files(job.frame, particles_)) {
        write(file, job);
        records.push_back(record_of(frame_path(folder_, file, job.index)));
    }
    return records;
}

void FrameWriter::write(const FrameFile& file, const Job& job) const {
    const std::string path = frame_path(folder_, file, job.index);
    const Frame& frame = job.frame;
    const PointTable& table = frame.particles;
    if (file.ending == k_particle_table.ending) {
        gis::write_points(path, frame.depth.grid.crs_wkt, "particles", table);
    } else {
        gis::BandText text = band_text(file.what, metadata_);
        text.metadata["TIME_S"] = shortest_text(frame.time);
        gis::write_geotiff(path, raster_of(frame, file.what), text, gis::RasterUse::frame);
    }
}

void FrameWriter::list(const std::vector<double>& times) const {
    std::string text = "index,time_s,moved_m3\n";
    for (std::size_t i = 0; i < times.size(); ++i)
        text += std::to_string(i) + "," + shortest_text(times[i]) + "," + number_text(moved_[i], 8) + "\n";
    write_text_file(list_file(folder_), text);
}

// Volume of what left its cells since the last frame, or came to others. Depths as in the files and sums of whole
// micrometres: the same bits after a resume.
void FrameWriter::follow(const Raster& depth) {
    std::int64_t lost = 0, gained = 0;
    const auto of = [](double value) { return std::isnan(value) ? 0 : static_cast<double>(static_cast<float>(value)); };
    if (!moved_.empty())
        depth.values.for_each_stored([&](std::size_t cell, double value) {
            const std::int64_t more = std::llround(1e6 * (of(value) - of(before_.values[cell])));
            (more > 0 ? gained : lost) += std::abs(more);
        });
    const double volume = 1e-6 * static_cast<double>(std::max(lost, gained)) * depth.grid.cell_area();
    moved_.push_back(moved_.empty() ? 0 : moved_.back() + volume);
    before_ = depth;
}

// Those of the part of a resumed run that is done.
void FrameWriter::follow_written(std::size_t count) {
    while (moved_.size() < count) follow(gis::read_result_raster(frame_path(folder_, k_depth_file, moved_.size())));
}

void FrameWriter::serve() {
    std::unique_lock lock(mutex_);
    while (true) {
        changed_.wait(lock, [&] { return closed_ || !waiting_.empty(); });
        if (waiting_.empty()) return;
        const Job& job = waiting_.front();  // a deque's elements do not move
        const auto end = times_.begin() + static_cast<std::ptrdiff_t>(job.index) + 1;
        const std::vector<double> times(times_.begin(), end);
        lock.unlock();
        std::exception_ptr error;
        std::vector<FrameRecord> written;
        try {
            follow_written(job.index);
            follow(job.frame.depth);
            written = write(job);
            list(times);  // readers of an unfinished run find only complete frames
        } catch (...) {
            error = std::current_exception();
        }
        lock.lock();
        if (error) {
            error_ = error;
            failed_ = true;
        } else {
            records_.insert(records_.end(), written.begin(), written.end());
            waiting_.pop_front();
        }
        changed_.notify_all();
        if (error) return;
    }
}

void FrameWriter::require_good() {
    const std::lock_guard lock(mutex_);
    if (error_) std::rethrow_exception(error_);
}

std::vector<FrameRecord> FrameWriter::records() const {
    const std::lock_guard lock(mutex_);
    return records_;
}

bool FrameWriter::settle() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return error_ || waiting_.empty(); });
    if (!error_) sync_path(folder_);  // each file is on the disk before it is renamed
    return !error_;
}

void FrameWriter::finish() {
    if (!settle()) require_good();
    follow_written(times_.size());
    list(times_);
}

void FrameWriter::cut_to(const CellWindow& window, int threads) {
    const fs::path folder = folder_, whole = folder.parent_path() / k_whole_frames,
                   cut = folder.parent_path() / k_cut_frames;
    const auto attempt = [](const fs::path& path, const auto& change) {
        std::error_code error;
        change(error);
        if (error) {
            throw Error(ErrorKind::environment,
                        Problem{"the frames cannot be cut to what was reached: " + error.message(), path.string(), "",
                                "", "Check the disk's space and the rights"});
        }
    };
    attempt(cut, [&](std::error_code& error) { fs::remove_all(cut, error); });  // of a killed program
    attempt(cut, [&](std::error_code& error) { fs::create_directories(cut, error); });
    std::vector<std::string> rasters;
    for (const std::string& name : names_of_frames(folder.string(), times_.size())) {
        if (name.ends_with(".tif")) {
            rasters.push_back(name);
        } else {  // particles do not depend on the map
            attempt(cut / name, [&](std::error_code& error) {
                fs::create_hard_link(folder / name, cut / name, error);
                if (error) fs::copy_file(folder / name, cut / name, fs::copy_options::overwrite_existing, error);
            });
        }
    }
    std::vector<std::exception_ptr> errors(rasters.size());
    ThreadPool(threads).for_each(rasters.size(), [&](std::size_t i) {
        try {
            const std::string& name = rasters[i];
            gis::BandText text = band_text(name.substr(0, name.rfind('_')), metadata_);
            text.metadata["TIME_S"] = shortest_text(times_[frame_index(name).value()]);
            gis::write_geotiff((cut / name).string(),
                               frana::cut_to(gis::read_result_raster((folder / name).string()), window), text,
                               gis::RasterUse::frame);
        } catch (...) {
            errors[i] = std::current_exception();
        }
    });
    for (const std::exception_ptr& error : errors)
        if (error) std::rethrow_exception(error);
    folder_ = cut.string();
    list(times_);
    folder_ = folder.string();
    sync_path(cut.string());
    attempt(whole, [&](std::error_code& error) { fs::rename(folder, whole, error); });
    attempt(folder, [&](std::error_code& error) { fs::rename(cut, folder, error); });
}

std::string StoredFrame::raster_file(const std::string& name) const {
    return frame_path(folder, {name, ".tif"}, index);
}

std::vector<StoredFrame> stored_frames(const std::string& folder) {
    std::ifstream file(list_file(folder));
    if (!file) {
        throw Error(ErrorKind::input, Problem{"the result has no frames", list_file(folder), "", "",
                                              "Run the scene with output.frames = on"});
    }
    constexpr std::size_t k_shown = 80;  // characters shown of an invalid line
    std::vector<StoredFrame> frames;
    std::string line;
    std::getline(file, line);
    while (std::getline(file, line)) {
        const auto words = words_of(trimmed(line));
        const auto time = words.size() == 3 ? number_from_text(words[1]) : std::nullopt;
        const auto moved = time ? number_from_text(words[2]) : std::nullopt;
        const bool next = moved && integer_from_text(words[0]) == static_cast<std::int64_t>(frames.size());
        if (!next || file.eof() || (!frames.empty() && (*time < frames.back().time || *moved < frames.back().moved))) {
            throw Error(
                ErrorKind::input,
                Problem{
                    "is not a list of frames: a line is not the next index with a time and a volume not below the last",
                    list_file(folder), elided(valid_utf8(line), k_shown), "index,time_s,moved_m3",
                    "The file is damaged, or of an earlier version: run the scene again"});
        }
        const std::size_t index = frames.size();
        frames.push_back({*time, *moved, folder, index, frame_path(folder, k_particle_table, index)});
    }
    if (frames.empty())
        throw Error(ErrorKind::input,
                    Problem{"lists no frames", list_file(folder), "", "",
                            "A run lists each frame when it is complete; a finished result without any is damaged"});
    return frames;
}

}  // namespace frana::app
