// SPDX-License-Identifier: Apache-2.0
#include <iostream>

#include "app/commands/command_line.h"
#include "app/commands/commands.h"
#include "app/commands/completion.h"
#include "core/error.h"

namespace frana::app {

CommandForm completion_form() {
    return {"frana completion bash|zsh",
            "Prints the script that completes commands, options, keys after --set, the names of presets and other "
            "values.\nFor this shell only: source <(frana completion bash)",
            "bash|zsh",
            {}};
}

int cmd_completion(const Arguments& arguments) {
    const auto values = parse_arguments(completion_form(), arguments);
    if (!values) return static_cast<int>(ExitCode::done);
    const std::string shell = (*values)["operand"].as<std::string>();
    if (shell != "bash" && shell != "zsh")
        throw Error(ErrorKind::input, Problem{"no completion for this shell", "command line", shell, "bash, zsh", ""});
    std::cout << (shell == "bash" ? bash_completion() : zsh_completion());
    return static_cast<int>(ExitCode::done);
}

}  // namespace frana::app
