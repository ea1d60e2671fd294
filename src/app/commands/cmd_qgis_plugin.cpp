// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <iostream>

#include "app/commands/command_line.h"
#include "app/commands/commands.h"
#include "app/commands/plugin_folder.h"
#include "app/input/share_directory.h"
#include "core/error.h"
#include "core/system_remedy.h"

namespace frana::app {

CommandForm qgis_plugin_form() {
    CommandForm form{"frana qgis-plugin --install|--uninstall [--profile NAME]",
                     "Puts the QGIS plugin into a profile of QGIS (3.22 or newer), or removes it. An older one is "
                     "replaced whole. In QGIS, enable it once under Plugins, Manage and Install Plugins.",
                     "",
                     {}};
    form.options.add_options()("install", "put it into the profile; prints its folder")(
        "uninstall", "remove it from the profile")("profile", one("NAME"), "name of the profile (default: default)");
    return form;
}

namespace {

namespace fs = std::filesystem;

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

}  // namespace

int cmd_qgis_plugin(const Arguments& arguments) {
    const auto values = parse_arguments(qgis_plugin_form(), arguments);
    if (!values) return static_cast<int>(ExitCode::done);
    const bool install = values->count("install") > 0, uninstall = values->count("uninstall") > 0;
    if (install == uninstall)
        throw Error(ErrorKind::input, Problem{install ? "both --install and --uninstall are given" : "nothing to do",
                                              "command line", "", "", "Give --install or --uninstall"});
    const std::string name = text_option(*values, "profile").value_or(k_default_profile);
    const fs::path profile = qgis_profile(name);
    const std::string target = (profile / "python" / "plugins" / "frana").string();
    const std::string working = (profile / "python" / "frana-plugin.partial").string();
    if (uninstall) {
        if (!uninstall_plugin(target, working)) std::cerr << "frana: " << target << " was not there\n";
        return static_cast<int>(ExitCode::done);
    }
    const fs::path source = fs::path(share_directory()) / "qgis" / "frana";
    std::error_code error;
    if (!fs::is_regular_file(source / "metadata.txt", error))
        throw Error(ErrorKind::environment, Problem{"the QGIS plugin is missing", source.string(), "", "",
                                                    "Install frana with its QGIS plugin, or set FRANA_SHARE"});
    make_folder_of_plugins(profile, name);
    install_plugin(source.string(), target, working, fs::read_symlink("/proc/self/exe").string());
    std::cout << target << '\n';
    std::cerr << "frana: enable the plugin once in QGIS: Plugins, Manage and Install Plugins, Installed, frana; for "
                 "qgis_process: qgis_process plugins enable frana\n";
    return static_cast<int>(ExitCode::done);
}

}  // namespace frana::app
