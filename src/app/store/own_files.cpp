// SPDX-License-Identifier: Apache-2.0
#include "app/store/own_files.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/store/manifest.h"
#include "app/store/result_directory.h"
#include "app/store/result_files.h"
#include "app/text/text_file.h"
#include "app/text/version.h"
#include "core/error.h"
#include "core/files.h"

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
    int refused = descriptor_ < 0 ? -1 : ::flock(descriptor_, wait ? LOCK_EX : LOCK_EX | LOCK_NB);
    while (refused != 0 && wait && errno == EINTR) refused = ::flock(descriptor_, LOCK_EX);
    if (refused == 0) return;
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

void remove_partial(const std::string& result, Findings found) {
    std::error_code error;
    const fs::path note = fs::path(result) / k_building_file;
    if (const auto json = read_json_file(note.string()); json && value_in<std::string>(*json, "/program") == k_program)
        fs::remove(note, error);
    const std::string partial = partial_folder(result);
    const FolderLock lock(partial, false);
    if (!lock.is_held()) return;  // there is none, or another run builds in it
    if (is_being_built(partial) || is_being_replaced(partial)) {
        if (const std::vector<std::string> users = users_files(partial); !users.empty()) {
            found.log.info(partial + " contains " + told(users) + "; it is kept");
            return;
        }
        error = remove_own_files(partial);
    }
    if (!error) fs::remove(partial, error);
    if (error && error != std::errc::directory_not_empty)
        found.warn(worded("older result not removed: {1}; the rest is in {2}", {error.message(), partial}));
}

std::vector<std::string> spellings(const std::string& source) {
    std::vector<std::string> all{source, source.substr(0, source.find('|'))};
    for (std::size_t from = 0; from < source.size();) {
        const std::size_t to = std::min(source.find_first_of(":\"|?,", from), source.size());
        all.push_back(source.substr(from, to - from));
        from = to + 1;
    }
    const std::string archive = "/vsi";
    for (std::size_t i = 0, count = all.size(); i < count; ++i) {
        if (!all[i].starts_with(archive)) continue;
        fs::path inner = all[i].substr(std::min(all[i].find('/', archive.size()), all[i].size()));
        for (; inner.has_relative_path(); inner = inner.parent_path()) {
            all.push_back(inner.string());            // "/vsizip//folder/file.zip/part"
            all.push_back(inner.string().substr(1));  // "/vsizip/file.zip/part" from the current folder
        }
    }
    return all;
}

void refuse_inputs(const std::vector<std::string>& outputs, const std::vector<std::string>& inputs, const Place& where,
                   Problems& problems) {
    std::vector<std::string> places;
    for (const std::string& input : inputs)
        for (std::string& place : spellings(input)) places.push_back(std::move(place));
    for (const std::string& output : outputs) {
        const auto is_it = [&](const std::string& place) {
            std::error_code error;
            return fs::equivalent(place, output, error) && !error;
        };
        if (std::any_of(places.begin(), places.end(), is_it))
            problems.add(
                {"would be overwritten: it is an input", where, output, "", "Choose another folder with --out"});
    }
    problems.throw_if_any();
}

namespace {

bool lists_files(const fs::path& folder) {
    return read_manifest(folder.string()).has_value();
}

// Whether it is of a run, complete or unfinished; comparisons and studies list their files too, but belong to no scene.
bool is_result(const fs::path& folder) {
    const std::optional<Manifest> manifest = read_manifest(folder.string());
    if (manifest && !manifest->scene_hash.empty()) return true;
    return is_being_built(folder.string());
}

/// Returns the nearest folder of a kind, at a path or above it; the path need not exist yet.
template <class Kind>
std::optional<fs::path> around(const std::string& path, const Kind& kind) {
    std::error_code error;
    fs::path folder = fs::weakly_canonical(fs::absolute(path.empty() ? "." : path), error);
    if (!folder.has_filename()) folder = folder.parent_path();  // "folder/"
    for (;; folder = folder.parent_path()) {
        if (kind(folder)) return folder;
        if (!folder.has_relative_path()) return std::nullopt;
    }
}

void check_another_result(const std::string& folder, const Place& where, const std::vector<std::string>& reads,
                          Problems& problems) {
    const auto result = around(folder, is_result);
    const auto is_it = [&](const std::string& read) { return around(read, is_result) == result; };
    if (!result || std::any_of(reads.begin(), reads.end(), is_it)) return;
    const std::string read = reads.empty() ? "" : "; the input is " + joined(reads, ", ");
    problems.add({"is in another result, " + result->string() + ", whose files would be changed" + read, where, folder,
                  "", "Choose a place outside it"});
}

}  // namespace

void check_own(const std::string& folder, const std::vector<std::string>& files, const Place& where,
               const std::vector<std::string>& reads, Problems& problems) {
    check_another_result(folder, where, reads, problems);
    if (around(folder, lists_files)) {
        for (const std::string& file : changed_files(files))
            problems.add({"was changed since frana wrote it, or is the user's", where, file, "",
                          "Choose another folder with " + where + ", or move the file away"});
        return;
    }
    std::error_code error;
    const std::string list = (fs::path(folder) / k_manifest_file).string();
    const std::string remedy = "Choose another folder with " + where + ", or move the file away";
    if (fs::exists(list, error))
        problems.add({"exists already and is not frana's list of files", where, list, "", remedy});
    for (const std::string& file : files)
        if (fs::exists(fs::symlink_status(file, error)))
            problems.add({"exists already and was not written by frana", where, file, "", remedy});
}

void make_drawing_folder(const std::string& folder) {
    std::error_code error;
    if (fs::is_symlink(folder, error))
        throw Error(ErrorKind::environment, Problem{"is a symbolic link: pictures would be written elsewhere", folder,
                                                    "", "", "Remove the link, or name its target with --out"});
    fs::create_directories(folder, error);
    if (error)
        throw Error(ErrorKind::environment, Problem{"cannot be made: " + error.message(), folder, "", "",
                                                    "Check the place's rights and free space"});
}

void begin_own(const std::string& folder, const std::vector<std::string>& files) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error)
        throw Error(ErrorKind::environment,
                    Problem{"cannot be made: " + error.message(), folder, "", "",
                            "Check the place's rights and free space, or choose another folder with --out"});
    if (!around(folder, lists_files) && !around(folder, is_result)) write_manifest(folder, {});
    for (const std::string& file : changed_files(files))
        throw Error(ErrorKind::environment, Problem{"was changed since frana wrote it", file, "", "",
                                                    "Move the file away, or choose another folder with --out"});
    note_in_making(files);
}

}  // namespace frana::app
