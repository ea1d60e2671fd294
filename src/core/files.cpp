// SPDX-License-Identifier: Apache-2.0
#include "core/files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <map>
#include <mutex>
#include <regex>
#include <system_error>
#include <utility>
#include <vector>

#include "core/error.h"

namespace frana {
namespace {

// Descriptors opened for reading only, and file systems that do not support syncing, are not disk problems.
bool is_disk_problem(int reason) {
    return reason == EIO || reason == ENOSPC || reason == EDQUOT || reason == EFBIG;
}

}  // namespace

int sync_descriptor(int descriptor) {
    int reason = 0;
    do reason = ::fsync(descriptor) == 0 ? 0 : errno;
    while (reason == EINTR);
    return is_disk_problem(reason) ? reason : 0;
}

int sync_path(const std::string& path) {
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) return 0;
    const int reason = sync_descriptor(descriptor);
    ::close(descriptor);
    return reason;
}

namespace {

namespace fs = std::filesystem;

constexpr const char* k_mark = ".partial";

std::string beside(const fs::path& path) {
    fs::path name = path.stem();
    name += k_mark + std::to_string(::getpid());
    name += path.extension();
    return (path.parent_path() / name).string();
}

fs::path folder_of(const fs::path& path) {
    return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

// Whether the process is running, so that its file is still being written; a number with more digits is not a process
// number.
bool is_running(const std::string& process) {
    constexpr std::size_t k_most_digits = 9;
    return process.size() > k_most_digits || ::kill(static_cast<pid_t>(std::stol(process)), 0) == 0 || errno != ESRCH;
}

// Files that killed processes left in the folders this process writes to. Each folder is scanned once: a result may
// contain ten thousand frames.
class AbandonedFiles {
  public:
    void remove_those_of(const fs::path& file) {
        const std::lock_guard lock(mutex_);
        const auto [folder, is_new] = folders_.try_emplace(file.parent_path());
        if (is_new) search(folder->first, folder->second);
        const auto [first, last] = folder->second.equal_range(file.filename().string());
        std::error_code ignored;
        for (auto left = first; left != last; ++left) fs::remove(left->second, ignored);
        folder->second.erase(first, last);
    }

  private:
    using Leftovers = std::multimap<std::string, fs::path>;  // by the name intended for each

    static void search(const fs::path& folder, Leftovers& left) {
        std::error_code ignored;
        for (auto entry = fs::directory_iterator(folder.empty() ? "." : folder, ignored); entry != fs::end(entry);
             entry.increment(ignored)) {
            const std::string name = entry->path().filename().string();
            const auto made = file_in_making(name);
            // SQLite's journal of a file without its file is of no use; others beside it may be the user's.
            if (made && made->abandoned && (!made->is_beside || name.ends_with("-journal")))
                left.emplace(made->name, entry->path());
        }
    }

    std::mutex mutex_;
    std::map<fs::path, Leftovers> folders_;
};

class Descriptor {
  public:
    Descriptor(const std::string& path, int flags) : number_(::open(path.c_str(), flags | O_CLOEXEC, 0666)) {}
    ~Descriptor() {
        if (number_ >= 0) ::close(number_);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    [[nodiscard]] int number() const noexcept { return number_; }

  private:
    int number_;
};

int write_all(int descriptor, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return written < 0 ? errno : ENOSPC;
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return 0;
}

}  // namespace

std::optional<FileInMaking> file_in_making(const std::string& name) {
    static const std::regex k_form(R"((.*)\.partial([0-9]+)(\.[A-Za-z0-9]+)(.*))");
    std::smatch parts;
    if (!std::regex_match(name, parts, k_form)) return std::nullopt;
    return FileInMaking{parts[1].str() + parts[3].str(), parts[4].length() > 0, !is_running(parts[2])};
}

FileAside::FileAside(std::string path, Kind kind) : path_(std::move(path)), named_(beside(path_)), partial_(named_) {
    if (kind == Kind::unnamed) open_without_name();
    static AbandonedFiles abandoned;
    abandoned.remove_those_of(path_);
}

void FileAside::open_without_name() {
    descriptor_ = ::open(folder_of(path_).c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0666);
    if (descriptor_ < 0) return;
    partial_ = "/proc/self/fd/" + std::to_string(descriptor_);
    if (::access(partial_.c_str(), R_OK | W_OK) == 0) return;
    ::close(std::exchange(descriptor_, -1));
    partial_ = named_;
}

FileAside::~FileAside() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (done_ || descriptor_ >= 0) return;
    std::error_code ignored;
    fs::remove(partial_, ignored);
}

void FileAside::fail(const std::string& what, int reason) const {
    throw Error(ErrorKind::environment,
                Problem{what + ": " + std::strerror(reason), path_, "", "", system_remedy(reason)});
}

void FileAside::sync_to_disk() const {
    const Descriptor named(descriptor_ < 0 ? partial_ : "", O_RDONLY);
    const int descriptor = descriptor_ >= 0 ? descriptor_ : named.number();
    if (const int reason = sync_descriptor(descriptor); reason != 0) fail("cannot be written to the disk", reason);
}

void FileAside::rename_into_place() {
    if (descriptor_ >= 0) {
        const auto link = [&](const std::string& name) {
            return ::linkat(AT_FDCWD, partial_.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0;
        };
        done_ = link(path_);
        if (done_) return;
        // The name exists: only a named file can replace it.
        const int refusal = errno;
        ::unlink(named_.c_str());  // left by a program that had our process number
        if (refusal != EEXIST) fail("a finished file cannot be renamed", refusal);
        if (!link(named_)) fail("a finished file cannot be renamed", errno);
    }
    if (std::rename(named_.c_str(), path_.c_str()) != 0) {
        const int reason = errno;
        ::unlink(named_.c_str());
        fail("a finished file cannot be renamed", reason);
    }
    done_ = true;
}

TemporaryFolder::TemporaryFolder() : path_((fs::temp_directory_path() / "franaXXXXXX").string()) {
    if (::mkdtemp(path_.data()) == nullptr)
        throw Error(ErrorKind::environment, Problem{std::string("no folder can be made: ") + std::strerror(errno),
                                                    path_, "", "", "Name a folder that may be written by TMPDIR"});
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

void write_file(const std::string& path, std::string_view bytes, Sync sync) {
    FileAside file(path);
    const auto fail = [&](int reason) {
        throw Error(ErrorKind::environment,
                    Problem{std::string("cannot be written: ") + std::strerror(reason), path, "", "",
                            "Check that the folder exists, may be written and has free space"});
    };
    {
        const Descriptor out(file.partial_path(), O_WRONLY | O_CREAT | O_TRUNC);
        if (out.number() < 0) fail(errno);
        if (const int reason = write_all(out.number(), bytes); reason != 0) fail(reason);
    }
    if (sync == Sync::yes) file.sync_to_disk();
    file.rename_into_place();
}

std::vector<fs::directory_entry> folder_entries(const fs::path& folder) {
    constexpr int k_most_tries = 20;  // repeats after interruptions by signals
    std::vector<fs::directory_entry> entries;
    std::error_code error;
    for (int tries = 0; tries < k_most_tries; ++tries) {
        entries.clear();
        fs::directory_iterator entry(folder, error);
        for (; !error && entry != fs::end(entry); entry.increment(error)) entries.push_back(*entry);
        if (error != std::errc::interrupted) break;
    }
    const bool nowhere = error == std::errc::no_such_file_or_directory || error == std::errc::not_a_directory ||
                         error == std::errc::too_many_symbolic_link_levels || error == std::errc::filename_too_long;
    if (nowhere) return {};
    if (error)
        throw Error(ErrorKind::environment, Problem{"cannot be read: " + error.message(), folder.string(), "", "",
                                                    system_remedy(error.value())});
    std::sort(entries.begin(), entries.end());
    return entries;
}

int read_blocks(const std::string& path, const std::function<void(std::string_view)>& consume) {
    int descriptor = -1;
    do descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);  // a FIFO would wait for a writer
    while (descriptor < 0 && errno == EINTR);
    if (descriptor < 0) return errno;
    struct stat found {};
    if (::fstat(descriptor, &found) != 0 || !S_ISREG(found.st_mode)) {
        ::close(descriptor);
        return EINVAL;
    }
    std::vector<char> block(static_cast<std::size_t>(std::clamp<off_t>(found.st_size, 1, 1 << 20)));
    int reason = 0;
    for (;;) {
        const ssize_t count = ::read(descriptor, block.data(), block.size());
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) reason = errno;
        if (count <= 0) break;
        consume({block.data(), static_cast<std::size_t>(count)});
    }
    ::close(descriptor);
    return reason;
}

}  // namespace frana
