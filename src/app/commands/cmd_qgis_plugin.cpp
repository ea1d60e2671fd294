// SPDX-License-Identifier: Apache-2.0
#include <fcntl.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <sstream>
#include <string>

#include "app/commands/command_line.h"
#include "app/input/share_directory.h"
#include "app/text/text_file.h"
#include "core/error.h"
#include "core/files.h"

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

void move(const fs::path& from, const fs::path& to) {
    std::error_code error;
    fs::rename(from, to, error);
    if (error) fail("cannot be renamed to " + to.string(), from, error);
}

/// Returns the folder of a QGIS profile, which may not exist: $QGIS_CUSTOM_CONFIG_PATH/profiles/NAME, else
/// $XDG_DATA_HOME/QGIS/QGIS3/profiles/NAME, else the same in ~/.local/share. Throws Error(input) for a name that is no
/// name of a folder, Error(environment) without a home folder.
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

/// Copies the plugin from `source` to `target`, whose folder exists, and notes the path of `program` in it; only a
/// plugin of frana's is replaced. `working`: a folder for the copy that is being made, on the same file system, removed
/// at the end. Throws Error(environment).
void install_plugin(const std::string& source, const std::string& target, const std::string& working,
                    const std::string& program) {
    refuse_foreign(target);
    remove_folder(working);  // of an installation that was killed
    try {
        std::error_code error;
        fs::create_directories(working, error);
        if (error) fail("cannot be made", working, error);
        for (fs::recursive_directory_iterator one(source, error), end; !error && one != end; one.increment(error)) {
            const fs::path to = working / one->path().lexically_relative(source);
            if (one->is_directory())
                fs::create_directory(to, error);
            else
                fs::copy_file(one->path(), to, error);
            if (error) fail("cannot be copied", one->path(), error);
        }
        if (error) fail("cannot be read", source, error);
        write_file((fs::path(working) / "program.txt").string(), program + '\n', Sync::yes);
        const bool is_replaced =
            is_there(target) && ::renameat2(AT_FDCWD, working.c_str(), AT_FDCWD, target.c_str(), RENAME_EXCHANGE) == 0;
        if (!is_replaced) {  // a first one, or a file system without this operation
            remove_folder(target);
            move(working, target);
        }
    } catch (const Error&) {
        std::error_code ignored;
        fs::remove_all(working, ignored);
        throw;
    }
    sync_path(fs::path(target).parent_path().string());
    remove_folder(working);  // the older plugin, where there was one
}

}  // namespace

namespace {

constexpr const char* k_default_profile = "default";

/// Makes the folder of plugins. QGIS makes its default profile when it first starts; others are the user's to make.
void make_folder_of_plugins(const fs::path& profile, const std::string& name) {
    std::error_code error;
    if (name != k_default_profile && !fs::is_directory(profile, error))
        throw Error(ErrorKind::input, Problem{"QGIS has no such profile", "--profile", name, "",
                                              "Make it in QGIS under Settings, User Profiles; " + profile.string() +
                                                  " would be its folder"});
    const fs::path plugins = profile / "python" / "plugins";
    fs::create_directories(plugins, error);
    if (error)
        throw Error(ErrorKind::environment, Problem{"cannot be made: " + error.message(), plugins.string(), "", "",
                                                    system_remedy(error.value())});
}

/// Debian 12's script qgis_process passes an option that the program behind it, qgis_process.bin, does not know.
const char* qgis_process() {
    const char* const path = std::getenv("PATH");
    std::istringstream folders(path != nullptr ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');)
        if (std::error_code error; fs::exists(fs::path(folder) / "qgis_process.bin", error)) return "qgis_process.bin";
    return "qgis_process";
}

int cmd_qgis_plugin(const Options& values) {
    if (values.count("install") == 0)
        throw Error(ErrorKind::input, Problem{"nothing to do", "command line", "", "", "Give --install"});
    const std::string name = text_option(values, "profile").value_or(k_default_profile);
    const fs::path profile = qgis_profile(name);
    const std::string target = (profile / "python" / "plugins" / "frana").string();
    const std::string working = (profile / "python" / "frana-plugin.partial").string();
    const fs::path source = fs::path(share_directory()) / "qgis" / "frana";
    std::error_code error;
    if (!fs::is_regular_file(source / "metadata.txt", error))
        throw Error(ErrorKind::environment, Problem{"the QGIS plugin is missing", source.string(), "", "",
                                                    "Install frana with its QGIS plugin, or set FRANA_SHARE"});
    make_folder_of_plugins(profile, name);
    install_plugin(source.string(), target, working, fs::read_symlink("/proc/self/exe").string());
    std::cout << target << '\n';
    std::cerr << "frana: enable the plugin once in QGIS: Plugins, Manage and Install Plugins, Installed, frana; for "
                 "qgis_process: "
              << qgis_process() << " plugins enable frana\n";
    return static_cast<int>(ExitCode::done);
}

}  // namespace

Command command_qgis_plugin() {
    CommandForm form{"frana qgis-plugin --install [--profile NAME]",
                     "Puts the QGIS plugin into a profile of QGIS (3.22 or newer). An older one is "
                     "replaced whole. In QGIS, enable it once under Plugins, Manage and Install Plugins.",
                     "",
                     {}};
    form.options.add_options()("install", "put it into the profile; prints its folder")(
        "profile", one("NAME"), "name of the profile (default: default)");
    return {"qgis-plugin", "put the plugin into a profile of QGIS", form, cmd_qgis_plugin};
}

}  // namespace frana::app
