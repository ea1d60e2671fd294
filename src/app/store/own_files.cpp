// SPDX-License-Identifier: Apache-2.0
#include "app/store/own_files.h"

#include <algorithm>
#include <filesystem>
#include <optional>

#include "app/store/manifest.h"
#include "app/store/replace_result.h"
#include "app/store/result_files.h"
#include "app/store/unfinished_results.h"
#include "core/system_remedy.h"
#include "params/grammar/value_text.h"

namespace frana::app {
namespace {

namespace fs = std::filesystem;

bool lists_files(const fs::path& folder) {
    return is_listed_result(folder.string());
}

// Whether it is of a run, complete or unfinished; comparisons and studies list their files too, but belong to no scene.
bool is_result(const fs::path& folder) {
    const std::optional<Manifest> manifest = read_manifest(folder.string());
    if (manifest && !manifest->scene_hash.empty()) return true;
    return is_being_built(folder.string()) || (!manifest && is_unlisted_result(folder.string()));
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

void check_another_result(const std::string& folder, const std::string& where, const std::vector<std::string>& reads,
                          Problems& problems) {
    const auto result = around(folder, is_result);
    const auto is_it = [&](const std::string& read) { return around(read, is_result) == result; };
    if (!result || std::any_of(reads.begin(), reads.end(), is_it)) return;
    const std::string read = reads.empty() ? "" : "; the input is " + joined(reads, ", ");
    problems.add({"is in another result, " + result->string() + ", whose files would be changed" + read, where, folder,
                  "", "Choose a place outside it"});
}

}  // namespace

void check_own(const std::string& folder, const std::vector<std::string>& files, const std::string& where,
               const std::vector<std::string>& reads, Problems& problems) {
    check_another_result(folder, where, reads, problems);
    if (around(folder, lists_files)) return;  // files changed since are kept when they are rewritten
    std::error_code error;
    const std::string list = (fs::path(folder) / k_manifest_file).string();
    const std::string remedy =
        "Choose another folder with " + where +
        ", or move the file away; a study by an older frana, without a list of its files, must be moved as a whole";
    if (fs::exists(list, error))
        problems.add({"exists already and is not frana's list of files", where, list, "", remedy});
    // Results of a frana without lists of files are identified only by its names.
    const auto unlisted = around(folder, is_result);
    const fs::path real = fs::weakly_canonical(folder.empty() ? "." : folder, error);
    for (const std::string& file : files) {
        const fs::path inside = real / fs::path(file).lexically_relative(folder.empty() ? "." : folder);
        const bool known =
            unlisted &&
            existing_file(inside.lexically_normal().lexically_relative(*unlisted).generic_string()) != nullptr;
        if (!known && fs::exists(fs::symlink_status(file, error)))
            problems.add({"exists already and was not written by frana", where, file, "", remedy});
    }
}

void begin_own(const std::string& folder, const std::vector<std::string>& files) {
    if (!around(folder, lists_files) && !around(folder, is_result)) write_manifest(folder, {});
    keep_changed_files(files);
}

void clear_own(const std::string& folder, const std::vector<std::string>& files,
               const std::function<bool(const std::string& name)>& belongs) {
    const auto home = around(folder, lists_files);
    const auto manifest = home ? read_manifest(home->string()) : std::nullopt;
    if (!manifest) return;
    const fs::path real = fs::canonical(folder);
    std::vector<std::string> removed;
    for (const auto& [name, mark] : manifest->files) {
        const fs::path file = *home / name;
        const auto is_it = [&](const std::string& one) { return fs::path(one).filename() == file.filename(); };
        if (file.parent_path() != real || !belongs(file.filename().string()) ||
            std::any_of(files.begin(), files.end(), is_it))
            continue;
        std::error_code error;
        if (!fs::is_regular_file(fs::symlink_status(file, error)) || mark_of(file.string()) != mark) continue;
        fs::remove(file, error);
        if (error)
            throw Error(ErrorKind::environment,
                        Problem{"is from an earlier, longer series and cannot be removed: " + error.message(),
                                file.string(), "", "", system_remedy(error.value())});
        removed.push_back(name);
    }
    remove_from_manifest(home->string(), removed);
}

}  // namespace frana::app
