// SPDX-License-Identifier: Apache-2.0
#include "app/own_files.h"

#include <filesystem>

#include "app/manifest.h"
#include "app/replace_result.h"
#include "app/result_files.h"

namespace frana::app {
namespace {

namespace fs = std::filesystem;

// Whether a folder or one above it lists its files.
bool is_listed(fs::path folder) {
    std::error_code failure;
    folder = fs::weakly_canonical(folder, failure);
    for (;; folder = folder.parent_path()) {
        if (is_listed_result(folder.string())) return true;
        if (!folder.has_relative_path()) return false;
    }
}

}  // namespace

void check_own(const std::string& folder, const std::vector<std::string>& files, const std::string& where,
               Problems& problems) {
    if (is_listed(folder)) return;  // what was changed since is kept when it is written anew: keep_changed_files()
    std::error_code failure;
    const std::string list = (fs::path(folder) / k_manifest_file).string();
    const std::string remedy =
        "Choose another folder with --out, or move the file away; a study of an older frana, which kept no "
        "list of its "
        "files, has to go as a whole";
    if (fs::exists(list, failure))
        problems.add({"is there already and is not frana's list of files", where, list, "", remedy});
    // Results of a frana that did not list files have only its names to go by.
    const bool by_name = is_unlisted_result(folder);
    for (const std::string& file : files) {
        const bool known = by_name && known_file(fs::path(file).lexically_relative(folder).generic_string()) != nullptr;
        if (!known && fs::exists(fs::symlink_status(file, failure)))
            problems.add({"is there already, and frana did not write it", where, file, "", remedy});
    }
}

void begin_own(const std::string& folder, const std::vector<std::string>& files) {
    if (!is_listed(folder) && !is_unlisted_result(folder)) write_manifest(folder, {});
    keep_changed_files(files);
}

}  // namespace frana::app
