// SPDX-License-Identifier: Apache-2.0
#include "app/store/checkpoint_file.h"

#include <fcntl.h>
#include <unistd.h>
#include <zlib.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <optional>

#include "app/text/version.h"
#include "core/error.h"
#include "core/files.h"
#include "mpm/vector/kernels.h"

namespace frana::app {

namespace {

constexpr std::array<char, 8> k_magic{'f', 'r', 'a', 'n', 'a', ' ', 'c', 'k'};
constexpr std::uint32_t k_byte_order = 0x01020304, k_other_order = 0x04030201;
constexpr std::size_t k_start_bytes = k_magic.size() + 2 * sizeof(std::uint32_t) + sizeof(std::uint64_t);
constexpr std::size_t k_sum_bytes = sizeof(std::uint32_t);
constexpr std::size_t k_buffer = 1 << 20;

template <class Archive>
void serialise_records(Archive& archive, std::vector<FrameRecord>& records) {
    records.resize(transfer_count(archive, records.size(), sizeof(std::uint64_t)));
    for (auto& [name, bytes, sum] : records) archive(name, bytes, sum);
}

template <class Archive>
void serialise(Archive& archive, CheckpointHead& head) {
    auto& [build, scene, step, time, end, wall_seconds, frame_times, log, origin, frame_records, accuracy] = head;
    if (!origin) origin.emplace();
    archive(origin->column, origin->row);
    serialise_records(archive, frame_records);
    archive(build, scene, step, time, end, wall_seconds, frame_times, log, accuracy);
}

[[noreturn]] void fail(const std::string& path, int reason) {
    throw Error(ErrorKind::environment, Problem{std::string("a checkpoint cannot be written: ") + std::strerror(reason),
                                                path, "", "", "Check the disk's space and the rights"});
}

[[noreturn]] void refuse(const std::string& path, const std::string& why) {
    throw Error(ErrorKind::input, Problem{why, path, "", "", ""});
}

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

// Writes through a buffer and computes the checksum.
class SummedOutput {
  public:
    explicit SummedOutput(const std::string& path) : path_(path), file_(std::fopen(path.c_str(), "wb"), &std::fclose) {
        if (!file_) fail(path_, errno);
        std::setvbuf(file_.get(), nullptr, _IOFBF, k_buffer);
    }
    void write(const void* data, std::size_t count) {
        if (count == 0) return;  // of an empty list, whose null pointer would reset the sum
        sum_ = crc32_z(sum_, static_cast<const Bytef*>(data), count);
        if (std::fwrite(data, 1, count, file_.get()) != count) fail(path_, errno);
        written_ += count;
    }
    // Rewrites the beginning, which contains the size; the sum then starts with it.
    void start(std::uint64_t size) {
        std::uint64_t rest = size;
        if (std::fseek(file_.get(), 0, SEEK_SET) != 0) fail(path_, errno);
        for (const auto& [data, count] : {std::pair<const void*, std::size_t>{k_magic.data(), k_magic.size()},
                                          {&k_byte_order, sizeof k_byte_order},
                                          {&k_checkpoint_format, sizeof k_checkpoint_format},
                                          {&rest, sizeof rest}}) {
            if (std::fwrite(data, 1, count, file_.get()) != count) fail(path_, errno);
        }
    }
    std::uint64_t finish() {
        const auto sum = static_cast<std::uint32_t>(sum_);
        if (std::fwrite(&sum, 1, sizeof sum, file_.get()) != sizeof sum) fail(path_, errno);
        start(written_);
        const std::uint64_t size = k_start_bytes + written_ + k_sum_bytes;
        if (std::fflush(file_.get()) != 0 || ::fsync(::fileno(file_.get())) != 0) fail(path_, errno);
        if (std::fclose(file_.release()) != 0) fail(path_, errno);
        return size;
    }

  private:
    std::string path_;
    File file_;
    uLong sum_ = 0;
    std::uint64_t written_ = 0;
};

void read_exactly(std::FILE* file, void* to, std::size_t count, const std::string& path) {
    if (count > 0 && std::fread(to, 1, count, file) != count) refuse(path, "is cut short");
}

struct Start {
    std::uint32_t format = 0;
    std::uint64_t size = 0;  ///< of head and state [bytes]
};

// Checks everything except the content of head and state.
Start check(std::FILE* file, const std::string& path) {
    std::array<char, k_magic.size()> magic{};
    std::uint32_t order = 0, sum = 0;
    Start start;
    auto& [format, size] = start;
    read_exactly(file, magic.data(), magic.size(), path);
    if (magic != k_magic) refuse(path, "is no checkpoint");
    read_exactly(file, &order, sizeof order, path);
    if (order == k_other_order) refuse(path, "was written on a machine with another order of bytes");
    if (order != k_byte_order) refuse(path, "is damaged");
    read_exactly(file, &format, sizeof format, path);
    if (format != k_checkpoint_format) {
        const std::string age = format > k_checkpoint_format ? "a newer" : "an older";
        refuse(path, "was written by " + age + " frana, in format " + std::to_string(format) + "; this one reads " +
                         std::to_string(k_checkpoint_format));
    }
    read_exactly(file, &size, sizeof size, path);
    std::error_code error;
    const std::uint64_t there = std::filesystem::file_size(path, error);
    if (error || there < k_start_bytes + k_sum_bytes || there - k_start_bytes - k_sum_bytes != size)
        refuse(path, "is cut short");
    uLong computed = 0;
    std::vector<unsigned char> buffer(k_buffer);
    for (std::uint64_t left = size; left > 0;) {
        const auto part = static_cast<std::size_t>(std::min<std::uint64_t>(left, buffer.size()));
        read_exactly(file, buffer.data(), part, path);
        computed = crc32_z(computed, buffer.data(), part);
        left -= part;
    }
    read_exactly(file, &sum, sizeof sum, path);
    if (static_cast<std::uint32_t>(computed) != sum) refuse(path, "is damaged: its checksum does not match");
    return start;
}

}  // namespace

std::string checkpoint_build() {
    return std::string(k_program) + " " + k_version + ", " + FRANA_COMPILER + ", " +
           (vector_kernels() != nullptr ? "vector instructions" : "plain instructions");
}

std::uint64_t write_checkpoint(const std::string& path, CheckpointHead head, const SaveState& state) {
    FileAside aside(path, FileAside::Kind::named);
    SummedOutput file(aside.partial_path());
    file.start(0);
    StateWriter writer([&](const void* data, std::size_t count) { file.write(data, count); });
    serialise(writer, head);
    state(writer);
    const std::uint64_t size = file.finish();
    aside.rename_into_place();
    sync_path(std::filesystem::path(path).parent_path().string());  // the new name too
    return size;
}

struct CheckpointFile::Open {
    std::string path;
    File file;
    CheckpointHead head;
    std::optional<StateReader> reader;
};

CheckpointFile::CheckpointFile(const std::string& path)
    : open_(new Open{path, File(std::fopen(path.c_str(), "rb"), &std::fclose), {}, {}}) {
    std::FILE* const file = open_->file.get();
    if (file == nullptr) refuse(path, std::string("cannot be opened: ") + std::strerror(errno));
    const Start start = check(file, path);
    if (std::fseek(file, static_cast<long>(k_start_bytes), SEEK_SET) != 0) refuse(path, "cannot be read");
    open_->reader.emplace([file, path](void* to, std::size_t count) { read_exactly(file, to, count, path); },
                          start.size);
    serialise(*open_->reader, open_->head);
}

CheckpointFile::~CheckpointFile() = default;

const std::string& CheckpointFile::path() const noexcept {
    return open_->path;
}

const CheckpointHead& CheckpointFile::head() const noexcept {
    return open_->head;
}

StateReader& CheckpointFile::state() noexcept {
    return *open_->reader;
}

}  // namespace frana::app
