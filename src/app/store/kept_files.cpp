// SPDX-License-Identifier: Apache-2.0
#include "app/store/kept_files.h"

#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>

#include "app/store/result_files.h"
#include "gis/raster/picture_out.h"
#include "params/grammar/absolute_path.h"
#include "params/grammar/ini_file.h"
#include "params/keys/former_names.h"
#include "params/keys/scene_parameters.h"

namespace frana::app {
namespace {

namespace fs = std::filesystem;

std::optional<std::pair<std::uint64_t, std::uint64_t>> place_of(const std::string& path) {
    struct stat found {};
    if (::stat(path.c_str(), &found) != 0 || !S_ISREG(found.st_mode)) return std::nullopt;
    return std::pair{static_cast<std::uint64_t>(found.st_dev), static_cast<std::uint64_t>(found.st_ino)};
}

bool is_drawn(const fs::path& file, const fs::path& folder) {
    if (const ResultFile* known = existing_file(file.lexically_relative(folder).generic_string()))
        return known->is_drawn();
    // Drawn to folders chosen by the user.
    const std::array<std::string, 5> pictures{".png", ".pdf", ".svg", ".mp4", ".gif"};
    return std::find(pictures.begin(), pictures.end(), file.extension().string()) != pictures.end();
}

}  // namespace

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

void KeptFiles::add(const std::string& source) {
    for (const std::string& path : spellings(source))
        if (const auto place = place_of(path)) files_.insert(*place);
}

void KeptFiles::add_result(const std::string& folder, const std::vector<std::string>& but) {
    std::error_code error;
    const auto is_rewritten = [&](const fs::path& path) {
        return std::any_of(but.begin(), but.end(), [&](const std::string& one) {
            return fs::path(one).lexically_normal() == path.lexically_normal();
        });
    };
    for (fs::recursive_directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
        const auto place = place_of(entry->path().string());
        if (place && !is_drawn(entry->path(), folder) && !is_rewritten(entry->path())) files_.insert(*place);
    }
    const fs::path scene = fs::path(folder) / k_scene_file;
    if (!fs::exists(scene, error)) return;
    static const std::vector<Parameter>& k_keys = scene_parameters();
    const std::string here = fs::absolute(folder).string();
    for (const IniEntry& entry : read_ini(scene.string())) {
        const Parameter* const key = find_parameter(k_keys, present_name(entry.name));
        SceneSpec spec;
        if (key == nullptr || !key->reads_files() || key->read(spec, entry.value)) continue;
        key->map_files(spec, [&](const std::string& path) {
            add(absolute_path(path, here));
            return path;
        });
    }
}

bool KeptFiles::has(const std::string& path) const {
    const auto place = place_of(path);
    return place && files_.count(*place) > 0;
}

void KeptFiles::check(const std::vector<std::string>& outputs, const std::string& where, Problems& problems) const {
    for (const std::string& path : outputs)
        if (has(path))
            problems.add({"would be overwritten: it is an input or belongs to a result", where, path, "",
                          "Choose another folder with --out"});
}

void KeptFiles::check_pictures(const std::vector<std::string>& outputs, const std::string& where,
                               Problems& problems) const {
    check(outputs, where, problems);
    for (const std::string& path : outputs) {
        if (path.ends_with(".tif") && place_of(path) && !has(path) && !gis::is_drawn_geotiff(path))
            problems.add(
                {"exists already and was not drawn by frana", where, path, "", "Choose another folder with --out"});
    }
}

}  // namespace frana::app
