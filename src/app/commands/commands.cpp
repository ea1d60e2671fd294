// SPDX-License-Identifier: Apache-2.0
#include "app/commands/commands.h"

#include <sstream>

#include "app/commands/command_line.h"

namespace frana::app {

const std::vector<Command>& commands() {
    static const std::vector<Command> list{
        {"new", "write a commented scene to begin with", new_form, cmd_new},
        {"run", "compute a scene; write rasters, maps, animation, comparison", run_form, cmd_run},
        {"check", "validate a scene, a study or a region and print what would run; writes nothing", check_form,
         cmd_check},
        {"render", "draw maps, views or an animation of a result", render_form, cmd_render},
        {"compare", "compare a result with a surveyed outline", compare_form, cmd_compare},
        {"params", "every key of a scene file: type, unit, default, range, meaning", params_form, cmd_params},
        {"materials", "the material presets", materials_form, cmd_materials},
        {"converge", "the scene at several resolutions: estimated error", converge_form, cmd_converge},
        {"ensemble", "many runs with uncertain values: probabilities, sensitivities", ensemble_form, cmd_ensemble,
         true},
        {"batch", "each polygon of a layer as a slope of its own: union, scenarios, degree of hazard", batch_form,
         cmd_batch, true},
        {"calibrate", "values that explain surveyed events, and how uncertain they stay", calibrate_form, cmd_calibrate,
         true},
        {"bench", "tests of frana: exact solutions, hard cases, throughput, changes of a scene's grid", bench_form,
         cmd_bench},
        {"qgis-plugin", "put the plugin into a profile of QGIS, or remove it", qgis_plugin_form, cmd_qgis_plugin},
        {"complete", "completion of commands, options, keys and values for a shell", complete_form, cmd_complete},
        {"man", "the manual pages", man_form, cmd_man},
    };
    return list;
}

const Command* find_command(const std::string& name) {
    for (const Command& command : commands())
        if (name == command.name) return &command;
    return nullptr;
}

std::string help_text() {
    constexpr std::size_t k_column = 24;
    std::string text = "frana computes the run-out of landslides.\n\nUsage: frana COMMAND [arguments]\n\n";
    const auto add = [&](const std::string& left, const std::string& right) {
        text += "  " + left;
        text += left.size() < k_column ? std::string(k_column - left.size() + 1, ' ')
                                       : "\n" + std::string(k_column + 3, ' ');
        text += right + "\n";
    };
    for (const Command& command : commands()) {
        std::istringstream lines(command.form().usage);
        std::vector<std::string> forms;
        for (std::string line; std::getline(lines, line);) {
            std::string words = line.substr(line.find("frana ") + 6);
            if (words.ends_with(" [options]")) words.resize(words.size() - 10);
            forms.push_back(words);
        }
        for (std::size_t i = 0; i + 1 < forms.size(); ++i) text += "  " + forms[i] + "\n";
        add(forms.back(), command.summary);
    }
    text += '\n';
    add("frana COMMAND --help", "more about a command");
    add("frana --version", "its version and its libraries'");
    add("frana COMMAND --allow-network ...", "inputs may be URLs, databases and map services");
    return text + "\nExit codes: " + k_exit_codes + "\n";
}

}  // namespace frana::app
