// SPDX-License-Identifier: Apache-2.0
#include "app/store/unfinished_results.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/store/checkpoints.h"
#include "app/store/json_file.h"
#include "app/store/manifest.h"
#include "app/store/result_files.h"
#include "app/store/result_place.h"
#include "app/text/text_file.h"
#include "app/text/version.h"
#include "core/folder_entries.h"
#include "core/read_blocks.h"

namespace frana::app {
namespace {

namespace fs = std::filesystem;

std::string own_name(const std::string& folder) {
    return fs::path(folder).filename().string();
}

void write_note(const fs::path& path, const std::string& folder_name, const std::string& result) {
    char host[256] = "";
    ::gethostname(host, sizeof host - 1);
    write_text_file(path.string(), json_text({{"program", k_program},
                                              {"version", k_version},
                                              {"folder", escaped_name(folder_name)},
                                              {"result", escaped_name(result)},
                                              {"process", ::getpid()},
                                              {"host", escaped_name(host)}}));
}

/// The folder's name that a note gives; empty where there is no note of frana's.
std::string noted_name(const fs::path& path) {
    try {
        const std::optional<Json> json = read_json_file(path.string());
        if (!json || value_in<std::string>(*json, "/program") != k_program) return {};
        return unescaped_name(value_in<std::string>(*json, "/folder").value_or(""));
    } catch (const std::exception&) {
        return {};
    }
}

template <class Is>
std::vector<std::string> siblings(const std::string& directory, const Is& is_wanted) {
    const fs::path result = result_path(directory);
    const std::string beginning = result.filename().string() + k_building;
    std::vector<std::pair<fs::file_time_type, std::string>> found;
    std::error_code error;
    for (const fs::directory_entry& entry : folder_entries(result.parent_path())) {
        if (own_name(entry.path()).starts_with(beginning) && is_wanted(entry.path().string()))
            found.emplace_back(entry.last_write_time(error), entry.path().string());
    }
    std::sort(found.rbegin(), found.rend());
    std::vector<std::string> folders;
    for (const auto& [time, folder] : found) folders.push_back(folder);
    return folders;
}

// As mkdtemp draws it: RESULT.partial-Ab12Cd.
bool has_drawn_name(const std::string& folder) {
    constexpr std::size_t k_drawn = 6;
    const std::string name = own_name(folder), letters = name.substr(name.rfind('-') + 1);
    return letters.size() == k_drawn &&
           std::all_of(letters.begin(), letters.end(), [](unsigned char c) { return std::isalnum(c) != 0; });
}

bool is_free(const std::string& folder) {
    const int descriptor = lock_folder(folder, false);
    if (descriptor < 0) return false;
    ::close(descriptor);
    return true;
}

}  // namespace

void note_building(const std::string& folder, const std::string& result) {
    write_note(fs::path(folder) / k_building_file, own_name(folder), result);
}

bool is_being_built(const std::string& folder) {
    return !is_being_replaced(folder) && noted_name(fs::path(folder) / k_building_file) == own_name(folder);
}

void note_replaced(const std::string& result, const std::string& later_name) {
    write_note(fs::path(result) / k_replaced_file, later_name, result);
}

bool is_being_replaced(const std::string& folder) {
    return noted_name(fs::path(folder) / k_replaced_file) == own_name(folder);
}

int lock_folder(const std::string& folder, bool wait) {
    const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0) return -1;
    if (::flock(descriptor, wait ? LOCK_EX : LOCK_EX | LOCK_NB) == 0) return descriptor;
    const int reason = errno;
    ::close(descriptor);
    errno = reason;
    return -1;
}

std::vector<std::string> unfinished_results(const std::string& directory) {
    return siblings(directory, [](const std::string& folder) {
        return is_being_built(folder) || (!is_being_replaced(folder) && !checkpoints_in(folder).empty());
    });
}

bool another_run_builds(const std::string& directory, const std::string& own) {
    for (const std::string& folder : siblings(directory, [](const std::string&) { return true; })) {
        if (folder == own) continue;
        const int other = lock_folder(folder, false);
        if (other < 0 && errno == EWOULDBLOCK) return true;
        if (other >= 0) ::close(other);  // left behind by a run that was killed, or no run's
    }
    return false;
}

std::vector<std::string> left_results(const std::string& directory) {
    std::vector<std::string> folders = unfinished_results(directory);
    std::erase_if(folders, [](const std::string& folder) { return !is_free(folder); });
    std::sort(folders.begin(), folders.end());
    return folders;
}

std::vector<std::string> replaced_results(const std::string& directory) {
    std::vector<std::string> folders = siblings(directory, is_being_replaced);
    std::erase_if(folders, [](const std::string& folder) { return !is_free(folder); });
    return folders;
}

bool remove_unfinished(const std::string& folder) {
    if (!is_being_built(folder)) return false;
    std::vector<fs::path> files, folders{folder};
    std::error_code error;
    // The note goes last: a folder that is removed in part can still be.
    const fs::path note = fs::path(folder) / k_building_file;
    try {
        for (std::size_t next = 0; next < folders.size(); ++next) {
            for (const fs::directory_entry& entry : folder_entries(fs::path(folders[next]))) {
                const fs::file_status status = entry.symlink_status(error);
                if (error) return false;
                if (fs::is_directory(status)) {
                    folders.push_back(entry.path());
                } else if (fs::is_regular_file(status) &&
                           existing_file(entry.path().lexically_relative(folder).generic_string()) != nullptr) {
                    if (entry.path() != note) files.push_back(entry.path());
                } else {
                    return false;
                }
            }
        }
    } catch (const Error&) {
        return false;
    }
    std::reverse(folders.begin(), folders.end());  // those inside come first
    for (const fs::path& file : files)
        if (!fs::remove(file, error) || error) return false;
    for (const fs::path& one : folders) {
        if (one == folder) fs::remove(note, error);
        if (!fs::remove(one, error) || error) return false;
    }
    return true;
}

void remove_note_of_building(const std::string& result) {
    const fs::path note = fs::path(result) / k_building_file;
    std::error_code ignored;
    if (!noted_name(note).empty()) fs::remove(note, ignored);
}

void remove_empty_siblings(const std::string& directory) {
    for (const std::string& folder : siblings(directory, has_drawn_name)) {
        const int mine = lock_folder(folder, false);
        if (mine < 0) continue;  // a run has just made it
        ::rmdir(folder.c_str());
        ::close(mine);
    }
}

}  // namespace frana::app
