// SPDX-License-Identifier: Apache-2.0
#include "app/commands/plugin_folder.h"

#include <fcntl.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "app/text/text_file.h"
#include "core/error.h"
#include "core/file_aside.h"
#include "core/sync_path.h"
#include "core/system_remedy.h"

namespace frana::app {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& what, const fs::path& path, const std::error_code& error) {
    throw Error(ErrorKind::environment,
                Problem{what + ": " + error.message(), path.string(), "", "", system_remedy(error.value())});
}

std::string folder_named_by(const char* variable) {
    const char* value = std::getenv(variable);
    return value == nullptr ? "" : value;
}

bool is_there(const fs::path& path) {
    std::error_code error;
    return fs::exists(fs::symlink_status(path, error));
}

void remove_folder(const fs::path& path) {
    std::error_code error;
    fs::remove_all(path, error);
    if (error) fail("cannot be removed", path, error);
}

/// Another plugin of the same name is the user's.
void refuse_foreign(const fs::path& target) {
    if (!is_there(target)) return;
    const std::string text = '\n' + read_text_file((target / "metadata.txt").string());
    if (text.find("\nname=frana\n") != std::string::npos) return;
    throw Error(ErrorKind::environment, Problem{"is not frana's plugin and is left as it is", target.string(), "", "",
                                                "Move it away or choose another --profile"});
}

void copy_plugin(const fs::path& source, const fs::path& to) {
    std::error_code error;
    fs::create_directories(to, error);
    if (error) fail("cannot be made", to, error);
    fs::directory_iterator entries(source, error);
    for (; !error && entries != fs::directory_iterator(); entries.increment(error)) {
        const fs::path name = entries->path().filename();
        if (name == "__pycache__") continue;
        if (entries->is_directory()) {
            copy_plugin(entries->path(), to / name);
            continue;
        }
        std::error_code unknown;
        const std::string bytes = read_text_file(entries->path().string());
        if (bytes.size() != fs::file_size(entries->path(), unknown))
            fail("cannot be read", entries->path(), unknown ? unknown : std::make_error_code(std::errc::io_error));
        write_file((to / name).string(), bytes, Sync::yes);
    }
    if (error) fail("cannot be read", source, error);
}

void move(const fs::path& from, const fs::path& to) {
    std::error_code error;
    fs::rename(from, to, error);
    if (error) fail("cannot be renamed to " + to.string(), from, error);
}

}  // namespace

std::string qgis_profile(const std::string& name) {
    if (name.empty() || name == "." || name == ".." || name.find('/') != std::string::npos)
        throw Error(ErrorKind::input, Problem{"is not the name of a profile", "--profile", name, "",
                                              "Give one that QGIS shows under Settings, User Profiles"});
    if (const std::string own = folder_named_by("QGIS_CUSTOM_CONFIG_PATH"); !own.empty())
        return (fs::path(own) / "profiles" / name).string();
    fs::path data = folder_named_by("XDG_DATA_HOME");
    if (data.empty()) {
        const std::string home = folder_named_by("HOME");
        if (home.empty())
            throw Error(ErrorKind::environment, Problem{"is not set, so the folder of QGIS's profiles is not known",
                                                        "HOME", "", "", "Set HOME or XDG_DATA_HOME"});
        data = fs::path(home) / ".local" / "share";
    }
    return (data / "QGIS" / "QGIS3" / "profiles" / name).string();
}

void install_plugin(const std::string& source, const std::string& target, const std::string& working,
                    const std::string& program) {
    refuse_foreign(target);
    remove_folder(working);  // of an installation that was killed
    try {
        copy_plugin(source, working);
        write_file((fs::path(working) / "program.txt").string(), program + '\n', Sync::yes);
        if (!is_there(target)) {
            move(working, target);
        } else if (::renameat2(AT_FDCWD, working.c_str(), AT_FDCWD, target.c_str(), RENAME_EXCHANGE) != 0) {
            // Not supported by the file system.
            const std::string older = working + ".old";
            remove_folder(older);
            move(target, older);
            std::error_code error, ignored;
            fs::rename(working, target, error);
            if (error) {
                fs::rename(older, target, ignored);
                fail("cannot take its name", target, error);
            }
            remove_folder(older);
        }
    } catch (const Error&) {
        std::error_code ignored;
        fs::remove_all(working, ignored);
        throw;
    }
    sync_path(fs::path(target).parent_path().string());
    remove_folder(working);  // the older plugin, where there was one
}

bool uninstall_plugin(const std::string& target, const std::string& working) {
    refuse_foreign(target);
    remove_folder(working);
    if (!is_there(target)) return false;
    move(target, working);  // at once; a half of it would break QGIS's start
    remove_folder(working);
    return true;
}

}  // namespace frana::app
