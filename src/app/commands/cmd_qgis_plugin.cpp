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

std::string folder_named_by(const char* variable) {
    const char* value = std::getenv(variable);
    return value == nullptr ? "" : value;
}

/// Another plugin of the same name is the user's.
void refuse_foreign(const fs::path& target) {
    std::error_code error;
    if (!fs::exists(fs::symlink_status(target, error))) return;
    const std::string text = '\n' + read_text_file((target / "metadata.txt").string());
    if (text.find("\nname=frana\n") != std::string::npos) return;
    throw Error(ErrorKind::environment, Problem{"is not frana's plugin and is left as it is", target.string(), "", "",
                                                "Move it away or choose another --profile"});
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

/// Copies the plugin from `source` to `target`, whose folder exists, and notes the path of `program` in it. A plugin
/// that is there is replaced whole or not at all; only frana's is. `working`: a folder for the copy that is being made,
/// on the same file system, removed at the end. Throws Error(environment), std::filesystem::filesystem_error.
void install_plugin(const fs::path& source, const fs::path& target, const fs::path& working,
                    const std::string& program) {
    refuse_foreign(target);
    const fs::path older = working.string() + ".old";
    for (const fs::path& left : {working, older}) fs::remove_all(left);  // of an installation that was killed
    std::error_code ignored;
    try {
        fs::copy(source, working, fs::copy_options::recursive);
        for (const char* folder : {"", "algorithms"}) fs::remove_all(working / folder / "__pycache__");
        write_file((working / "program.txt").string(), program + '\n');
        if (fs::exists(target)) fs::rename(target, older);
        fs::rename(working, target);
    } catch (...) {
        if (!fs::exists(target, ignored)) fs::rename(older, target, ignored);
        fs::remove_all(working, ignored);
        throw;
    }
    fs::remove_all(older, ignored);
}

}  // namespace

CommandForm qgis_plugin_form() {
    CommandForm form{"frana qgis-plugin --install [--profile NAME]",
                     "Puts the QGIS plugin into a profile of QGIS (3.22 or newer). An older one is "
                     "replaced whole. In QGIS, enable it once under Plugins, Manage and Install Plugins.",
                     "",
                     {}};
    form.options.add_options()("install", "put it into the profile; prints its folder")(
        "profile", one("NAME"), "name of the profile (default: default)");
    return form;
}

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
    fs::create_directories(plugins);
}

/// Debian 12's script qgis_process passes an option that the program behind it, qgis_process.bin, does not know.
const char* qgis_process() {
    const char* const path = std::getenv("PATH");
    std::istringstream folders(path != nullptr ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');)
        if (std::error_code error; fs::exists(fs::path(folder) / "qgis_process.bin", error)) return "qgis_process.bin";
    return "qgis_process";
}

}  // namespace

int cmd_qgis_plugin(const Arguments& arguments) {
    const auto values = parse_arguments(qgis_plugin_form(), arguments);
    if (!values) return static_cast<int>(ExitCode::done);
    if (values->count("install") == 0)
        throw Error(ErrorKind::input, Problem{"nothing to do", "command line", "", "", "Give --install"});
    const std::string name = text_option(*values, "profile").value_or(k_default_profile);
    const fs::path profile = qgis_profile(name);
    const fs::path target = profile / "python" / "plugins" / "frana";
    const fs::path source = fs::path(share_directory()) / "qgis" / "frana";
    std::error_code error;
    if (!fs::is_regular_file(source / "metadata.txt", error))
        throw Error(ErrorKind::environment, Problem{"the QGIS plugin is missing", source.string(), "", "",
                                                    "Install frana with its QGIS plugin, or set FRANA_SHARE"});
    make_folder_of_plugins(profile, name);
    install_plugin(source, target, profile / "python" / "frana-plugin.partial",
                   fs::read_symlink("/proc/self/exe").string());
    std::cout << target.string() << '\n';
    std::cerr << "frana: enable the plugin once in QGIS: Plugins, Manage and Install Plugins, Installed, frana; for "
                 "qgis_process: "
              << qgis_process() << " plugins enable frana\n";
    return static_cast<int>(ExitCode::done);
}

}  // namespace frana::app
