// SPDX-License-Identifier: Apache-2.0
#include "core/file_aside.h"

#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <filesystem>
#include <map>
#include <mutex>
#include <system_error>
#include <utility>

#include "core/error.h"

namespace frana {
namespace {

namespace fs = std::filesystem;

constexpr const char* k_mark = ".partial";

std::string beside(const fs::path& path) {
    fs::path name = path.stem();
    name += k_mark + std::to_string(getpid());
    name += path.extension();
    return (path.parent_path() / name).string();
}

bool runs(const std::string& process) {
    return ::kill(static_cast<pid_t>(std::stol(process)), 0) == 0 || errno != ESRCH;
}

// The file that another process was writing aside when it was killed; empty: a name is none of that kind.
std::string abandoned_name(const fs::path& file) {
    constexpr std::size_t k_most_digits = 9;
    const std::string stem = file.stem().string();
    const auto mark = stem.rfind(k_mark);
    if (mark == std::string::npos) return {};
    const std::string process = stem.substr(mark + std::string(k_mark).size());
    if (process.empty() || process.size() > k_most_digits ||
        process.find_first_not_of("0123456789") != std::string::npos || runs(process)) {
        return {};
    }
    return stem.substr(0, mark) + file.extension().string();
}

// What killed processes left in the folders that this process writes to. Each folder is looked through once:
// a result may hold ten thousand frames.
class AbandonedFiles {
  public:
    void remove_those_of(const fs::path& file) {
        const std::lock_guard lock(mutex_);
        const auto [folder, is_new] = folders_.try_emplace(file.parent_path());
        if (is_new) look_through(folder->first, folder->second);
        const auto [first, last] = folder->second.equal_range(file.filename().string());
        std::error_code ignored;
        for (auto left = first; left != last; ++left) fs::remove(left->second, ignored);
        folder->second.erase(first, last);
    }

  private:
    using Left = std::multimap<std::string, fs::path>;  // by the name that each was to get

    static void look_through(const fs::path& folder, Left& left) {
        std::error_code ignored;
        for (auto entry = fs::directory_iterator(folder.empty() ? "." : folder, ignored);
             entry != fs::end(entry); entry.increment(ignored)) {
            if (std::string name = abandoned_name(entry->path().filename()); !name.empty())
                left.emplace(std::move(name), entry->path());
        }
    }

    std::mutex mutex_;
    std::map<fs::path, Left> folders_;
};

}  // namespace

FileAside::FileAside(std::string path) : path_(std::move(path)), partial_(beside(path_)) {
    static AbandonedFiles abandoned;
    abandoned.remove_those_of(path_);
}

FileAside::~FileAside() {
    if (done_) return;
    std::error_code ignored;
    std::filesystem::remove(partial_, ignored);
}

void FileAside::rename_into_place() {
    std::error_code code;
    std::filesystem::rename(partial_, path_, code);
    if (code) {
        throw Error(ErrorKind::environment, Problem{"a finished file cannot take its name", path_,
                                                    code.message(), "", "Choose another name or folder"});
    }
    done_ = true;
}

}  // namespace frana
