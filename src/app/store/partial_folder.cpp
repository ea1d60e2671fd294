// SPDX-License-Identifier: Apache-2.0
#include "app/store/partial_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/store/json_file.h"
#include "app/store/manifest.h"
#include "app/store/result_files.h"
#include "app/store/result_place.h"
#include "app/text/text_file.h"
#include "app/text/version.h"
#include "core/files.h"
#include "params/grammar/value_text.h"

namespace frana::app {
namespace {

namespace fs = std::filesystem;

std::string own_name(const std::string& folder) {
    return fs::path(folder).filename().string();
}

void write_note(const fs::path& path, const std::string& partial) {
    char host[256] = "";
    ::gethostname(host, sizeof host - 1);
    write_text_file(path.string(), json_text({{"program", k_program},
                                              {"version", k_version},
                                              {"folder", escaped_name(own_name(partial))},
                                              {"process", ::getpid()},
                                              {"host", escaped_name(host)}}));
}

/// Whether there is a note of frana's with the folder's own name: a copy has another.
bool has_note(const std::string& folder, const char* name) {
    const std::optional<Json> json = read_json_file((fs::path(folder) / name).string());
    return json && value_in<std::string>(*json, "/program") == k_program &&
           value_in<std::string>(*json, "/folder") == escaped_name(own_name(folder));
}

/// Adds the paths in a folder of everything below it; inner folders before outer ones.
void list_below(const fs::path& root, const fs::path& folder, std::vector<std::string>& files,
                std::vector<std::string>& folders) {
    for (const fs::directory_entry& entry : folder_entries(folder)) {
        const std::string name = entry.path().lexically_relative(root).generic_string();
        const bool is_folder = fs::is_directory(entry.symlink_status());
        if (is_folder) list_below(root, entry.path(), files, folders);
        (is_folder ? folders : files).push_back(name);
    }
}

bool is_list_or_note(const std::string& name) {
    return name == k_manifest_file || name == k_building_file || name == k_replaced_file;
}

/// The files of frana's in a folder.
class OwnFiles {
  public:
    explicit OwnFiles(std::string folder) : folder_(std::move(folder)) {
        if (!is_being_built(folder_)) list_ = read_manifest(folder_).value_or(Manifest{});
    }
    [[nodiscard]] bool lists(const std::string& name) const { return list_ && list_->files.count(name) > 0; }
    [[nodiscard]] bool has(const std::string& name) const {
        const fs::path path = fs::path(folder_) / name;
        std::error_code error;
        if (!fs::is_regular_file(fs::symlink_status(path, error))) return false;
        if (is_list_or_note(name) || is_leftover(name)) return true;
        if (knows(name)) return !list_ || is_as_listed(path.string(), list_->files.at(name));
        for (const std::string ending : {".aux.xml", "-shm", "-wal", "~"})
            if (name.ends_with(ending) && knows(name.substr(0, name.size() - ending.size())))
                return ending != "-wal" || fs::file_size(path, error) == 0;
        return false;
    }

  private:
    [[nodiscard]] bool knows(const std::string& name) const {
        return list_ ? lists(name) : existing_file(name) != nullptr;
    }

    std::string folder_;
    std::optional<Manifest> list_;  ///< none: a result is being built
};

}  // namespace

std::string partial_folder(const std::string& directory) {
    return result_path(directory) + k_partial;
}

void note_building(const std::string& partial) {
    write_note(fs::path(partial) / k_building_file, partial);
}

bool is_being_built(const std::string& folder) {
    return !is_being_replaced(folder) && has_note(folder, k_building_file);
}

void note_replaced(const std::string& result) {
    write_note(fs::path(result) / k_replaced_file, partial_folder(result));
}

bool is_being_replaced(const std::string& folder) {
    return has_note(folder, k_replaced_file);
}

FolderLock::FolderLock(const std::string& folder, bool wait)
    : descriptor_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    if (descriptor_ >= 0 && ::flock(descriptor_, wait ? LOCK_EX : LOCK_EX | LOCK_NB) == 0) return;
    reason_ = errno;
    release();
}

bool FolderLock::is_of(const std::string& folder) const {
    struct stat locked {
    }, named{};
    return descriptor_ >= 0 && ::fstat(descriptor_, &locked) == 0 && ::stat(folder.c_str(), &named) == 0 &&
           locked.st_dev == named.st_dev && locked.st_ino == named.st_ino;
}

void FolderLock::release() {
    if (descriptor_ >= 0) ::close(descriptor_);
    descriptor_ = -1;
}

bool is_locked(const std::string& folder) {
    const FolderLock mine(folder, false);
    return mine.reason() == EWOULDBLOCK;
}

std::vector<std::string> users_files(const std::string& folder) {
    std::vector<std::string> files, folders;
    list_below(folder, folder, files, folders);
    const OwnFiles own(folder);
    std::erase_if(files, [&](const std::string& name) { return own.has(name); });
    for (std::string& name : files)
        if (own.lists(name)) name += " (changed)";
    return files;
}

std::string told(const std::vector<std::string>& users_files) {
    constexpr std::size_t k_most = 10;
    std::vector<std::string> some(users_files.begin(), users_files.begin() + std::min(k_most, users_files.size()));
    if (users_files.size() > k_most) some.push_back("and " + std::to_string(users_files.size() - k_most) + " more");
    return (users_files.size() == 1 ? "a file that frana did not write, or that was changed since: "
                                    : std::to_string(users_files.size()) +
                                          " files that frana did not write, or that were changed since: ") +
           joined(some, ", ");
}

std::error_code remove_own_files(const std::string& folder,
                                 const std::function<bool(const std::string& name)>& is_kept) {
    std::vector<std::string> files, folders;
    list_below(folder, folder, files, folders);
    const OwnFiles own(folder);
    std::erase_if(files, [&](const std::string& name) { return !own.has(name) || (is_kept && is_kept(name)); });
    const auto last = std::stable_partition(files.begin(), files.end(),
                                            [](const std::string& name) { return !is_list_or_note(name); });
    std::vector<std::string> lists(last, files.end());
    files.erase(last, files.end());
    std::sort(lists.rbegin(), lists.rend());  // the manifest before the notes
    std::error_code error;
    for (const std::string& name : files)
        if (!fs::remove(fs::path(folder) / name, error) && error) return error;
    for (const std::string& name : folders)
        if (!fs::remove(fs::path(folder) / name, error) && error != std::errc::directory_not_empty) return error;
    for (const std::string& name : lists)
        if (!fs::remove(fs::path(folder) / name, error) && error) return error;
    return {};
}

void remove_partial(const std::string& result, RunLog& log) {
    std::error_code error;
    const fs::path note = fs::path(result) / k_building_file;
    if (const auto json = read_json_file(note.string()); json && value_in<std::string>(*json, "/program") == k_program)
        fs::remove(note, error);
    const std::string partial = partial_folder(result);
    const FolderLock lock(partial, false);
    if (!lock.is_held()) return;  // there is none, or another run builds in it
    if (is_being_built(partial) || is_being_replaced(partial)) {
        if (const std::vector<std::string> users = users_files(partial); !users.empty()) {
            log.info(partial + " contains " + told(users) + "; it is kept");
            return;
        }
        error = remove_own_files(partial);
    }
    if (!error) fs::remove(partial, error);
    if (error && error != std::errc::directory_not_empty)
        log.warn(worded("the older result could not be removed: {1}; what is left of it is in {2} until the next run",
                        {error.message(), partial}));
}

}  // namespace frana::app
