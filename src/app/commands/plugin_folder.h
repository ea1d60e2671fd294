// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace frana::app {

/// Returns the folder of a QGIS profile, which may not exist: $QGIS_CUSTOM_CONFIG_PATH/profiles/NAME, else
/// $XDG_DATA_HOME/QGIS/QGIS3/profiles/NAME, else the same in ~/.local/share. Throws Error(input) for a name that is no
/// name of a folder, Error(environment) without a home folder.
std::string qgis_profile(const std::string& name);

/// Copies the plugin from `source` to `target`, whose folder exists, and notes the path of `program` in it. A plugin
/// that is there is replaced whole or not at all; only frana's is. `working`: a folder for the copy that is being made,
/// on the same file system, removed at the end. Throws Error(environment).
void install_plugin(const std::string& source, const std::string& target, const std::string& working,
                    const std::string& program);

/// Removes it. Returns whether it was there. Throws Error(environment) if it is not frana's or cannot be removed.
bool uninstall_plugin(const std::string& target, const std::string& working);

}  // namespace frana::app
