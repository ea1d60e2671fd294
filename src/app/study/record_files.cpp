// SPDX-License-Identifier: Apache-2.0
#include "app/study/record_files.h"

#include <zlib.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <set>
#include <string_view>
#include <utility>

#include "app/store/interrupted_run.h"
#include "app/store/result_files.h"
#include "app/text/text_file.h"
#include "core/archive.h"
#include "core/error.h"
#include "core/files.h"

namespace frana::app::study {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view k_magic = "frana mb";
/// Increases with every change of what a record contains.
constexpr std::uint32_t k_format = 6;
/// Before the record itself, which begins with its member.
constexpr std::size_t k_start_bytes = k_magic.size() + sizeof k_format + sizeof(std::uint64_t),
                      k_head_bytes = k_start_bytes + sizeof MemberRecord::member, k_crc_bytes = sizeof(std::uint32_t);

/// What the first bytes of a record tell.
struct RecordHead {
    std::uint64_t member = 0, bytes = 0;  ///< bytes: of the whole record
};
/// Returns none if these are no such bytes, or have another format.
std::optional<RecordHead> record_head(const std::string& bytes) {
    if (bytes.size() < k_head_bytes || !bytes.starts_with(k_magic)) return std::nullopt;
    StateReader reader(std::string_view(bytes).substr(k_magic.size()));
    std::uint32_t format = 0;
    RecordHead head;
    reader(format, head.bytes, head.member);
    if (format != k_format || head.bytes > std::numeric_limits<std::uint64_t>::max() / 2) return std::nullopt;
    head.bytes += k_start_bytes + k_crc_bytes;
    return head;
}

/// The sum at the end of a record, of all before.
std::uint32_t crc_of(const std::string& bytes, std::size_t count) {
    return static_cast<std::uint32_t>(crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), count));
}

constexpr std::uint64_t k_most_bytes = 256'000'000;  // of a file that still gets another record
// Synced together they cost little more than one. What a power failure damages is seen by its CRC, and computed again.
constexpr std::size_t k_together = 64;
constexpr double k_longest_wait = 1;  // [s]

[[noreturn]] void fail(const std::string& what, int reason, const std::string& path) {
    throw Error(ErrorKind::environment,
                Problem{what + ": " + std::strerror(reason), path, "", "", "Check the place's rights and free space"});
}

/// A file of which no byte is read before somebody asks for it.
std::ifstream opened(const std::string& path) {
    std::ifstream file;
    file.rdbuf()->pubsetbuf(nullptr, 0);
    file.open(path, std::ios::binary);
    return file;
}

/// The next place from `at` on where a record may begin; `size` if there is none.
std::uint64_t next_beginning(std::ifstream& file, std::uint64_t at, std::uint64_t size) {
    std::string block(1 << 20, '\0');
    for (; at < size; at += block.size() - k_magic.size()) {
        file.clear();
        file.seekg(static_cast<std::streamoff>(at));
        file.read(block.data(), static_cast<std::streamsize>(block.size()));
        const std::size_t found = block.substr(0, static_cast<std::size_t>(file.gcount())).find(k_magic);
        if (found != std::string::npos) return at + found;
    }
    return size;
}

std::string bytes_at(const RecordPlace& place) {
    std::ifstream file = opened(place.file);
    std::string bytes(place.bytes, '\0');
    file.seekg(static_cast<std::streamoff>(place.at));
    file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    return file ? bytes : "";
}

}  // namespace

std::string bytes_of(MemberRecord record) {
    std::string content, bytes(k_magic);
    StateWriter of_content(content);
    of_content(record);
    std::uint32_t format = k_format;
    std::uint64_t size = content.size();
    StateWriter writer(bytes);
    writer(format, size);
    bytes += content;
    std::uint32_t crc = crc_of(bytes, bytes.size());
    writer(crc);
    return bytes;
}

std::optional<MemberRecord> record_from(const std::string& bytes) {
    const auto head = record_head(bytes);
    if (!head || head->bytes != bytes.size()) return std::nullopt;
    const std::size_t end = bytes.size() - k_crc_bytes;
    StateReader reader(std::string_view(bytes).substr(k_start_bytes, end - k_start_bytes));
    MemberRecord record;
    try {
        std::uint32_t crc = 0;
        StateReader sum(std::string_view(bytes).substr(end));
        sum(crc);
        StateReader::require(crc == crc_of(bytes, end));
        reader(record);
        StateReader::require(reader.left() == 0);
        std::uint64_t cells = 0;
        for (const CellRun& run : record.runs) cells += run.count;
        for (std::size_t q = 0; q < k_quantities; ++q)
            StateReader::require(cells == record.values[q].size() ||
                                 (q >= k_least_quantities && record.values[q].empty()));
    } catch (const Error&) {
        return std::nullopt;
    }
    return record;
}

std::optional<MemberRecord> read_record(const RecordPlace& place) {
    return record_from(bytes_at(place));
}

MemberRecord require_record(const RecordPlace& place) {
    auto record = read_record(place);
    if (!record)
        throw Error(ErrorKind::environment, Problem{"the record of a member cannot be read", place.file, "", "",
                                                    "Check the disk; --resume computes that member again"});
    return *std::move(record);
}

void for_each_record(const std::string& path,
                     const std::function<void(std::uint64_t member, const RecordPlace& place)>& visit) {
    std::ifstream file = opened(path);
    std::error_code error;
    const std::uint64_t size = fs::file_size(path, error);
    if (!file || error) return;
    for (std::uint64_t at = 0; at < size;) {
        std::string head(k_head_bytes, '\0');
        file.clear();
        file.seekg(static_cast<std::streamoff>(at));
        file.read(head.data(), static_cast<std::streamsize>(head.size()));
        const auto found = file ? record_head(head) : std::nullopt;
        if (!found || found->bytes > size - at) {
            at = next_beginning(file, at + 1, size);
            continue;
        }
        visit(found->member, {path, at, found->bytes});
        at += found->bytes;
    }
}

RecordFiles::RecordFiles(std::string folder) : folder_(std::move(folder)) {
    for (const std::string& file : records_in(folder_))
        for_each_record(file, [this](std::uint64_t member, const RecordPlace& place) { places_[member] = place; });
}

RecordPlace RecordFiles::place(std::uint64_t member) const {
    const auto found = places_.find(member);
    return found == places_.end() ? RecordPlace{} : found->second;
}

void RecordFiles::append(std::uint64_t member, const std::string& bytes) {
    if (file_.empty() || size_ >= k_most_bytes) {
        sync();
        for (int number = 1; file_.empty() || fs::exists(file_); ++number) file_ = record_file(folder_, number);
        size_ = 0;
    }
    std::ofstream file(file_, std::ios::binary | std::ios::app);
    file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    file.close();
    if (!file) fail("cannot be written", errno, file_);
    places_[member] = {file_, size_, bytes.size()};
    size_ += bytes.size();
    if (++unsynced_ >= k_together || since_sync_.seconds() > k_longest_wait) sync();
}

void RecordFiles::sync() {
    if (unsynced_ == 0) return;
    for (const std::string& path : {file_, fs::path(file_).parent_path().string()})
        if (const int reason = sync_path(path); reason != 0) fail("cannot be stored", reason, path);
    unsynced_ = 0;
    since_sync_ = {};
}

std::size_t count_records(const std::string& folder) {
    std::set<std::pair<fs::path, std::uint64_t>> found;
    for (const std::string& file : records_in(folder))
        for_each_record(file, [&](std::uint64_t member, const RecordPlace&) {
            found.emplace(fs::path(file).parent_path(), member);
        });
    return found.size();
}

void join_records(const std::string& folder) {
    const std::string path = (fs::path(folder) / k_joined_records).string();
    const RecordFiles records(folder);
    std::ofstream file(path, std::ios::binary);
    file << records.count() << '\n' << read_text_file((fs::path(folder) / k_record_identity).string());
    for (std::size_t member = 0; member < records.count(); ++member) file << bytes_at(records.place(member));
    file.close();
    if (!file) fail("cannot be written", errno, path);
}

JoinedRecords split_records(const std::string& result, RecordFiles* to) {
    const std::string path = (fs::path(result) / k_joined_records).string();
    JoinedRecords joined;
    std::uint64_t first = 0;
    for_each_record(path, [&](std::uint64_t member, const RecordPlace& place) {
        if (joined.members++ == 0) first = place.at;
        if (to != nullptr && to->place(member).file.empty()) to->append(member, bytes_at(place));
    });
    std::ifstream file(path, std::ios::binary);
    if (!file) return joined;
    std::size_t written = 0;
    file >> written;
    if (file.get() != '\n' || written == 0 || written != joined.members)
        throw Error(ErrorKind::environment,
                    Problem{"is damaged", path, "", "", "Run the study anew with more samples and --overwrite"});
    joined.identity.resize(first - static_cast<std::uint64_t>(file.tellg()));
    file.read(joined.identity.data(), static_cast<std::streamsize>(joined.identity.size()));
    return joined;
}

}  // namespace frana::app::study
