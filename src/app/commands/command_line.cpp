// SPDX-License-Identifier: Apache-2.0
#include "app/commands/command_line.h"

#include <algorithm>
#include <array>
#include <boost/any.hpp>
#include <boost/program_options/cmdline.hpp>
#include <boost/program_options/parsers.hpp>
#include <boost/program_options/positional_options.hpp>
#include <boost/program_options/value_semantic.hpp>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "app/process/terminal.h"
#include "app/text/text_table.h"
#include "app/text/version.h"
#include "core/error.h"
#include "params/grammar/value_text.h"
#include "params/keys/scene_parameters.h"

namespace frana::app {

/// Each in its cmd_NAME.cpp.
Command command_new(), command_release(), command_run(), command_check(), command_render(), command_compare(),
    command_params(), command_materials(), command_schemes(), command_converge(), command_ensemble(), command_batch(),
    command_calibrate(), command_qgis_plugin();

const std::vector<Command>& commands() {
    static const std::vector<Command> list{
        command_new(),      command_release(), command_run(),       command_check(),   command_render(),
        command_compare(),  command_params(),  command_materials(), command_schemes(), command_converge(),
        command_ensemble(), command_batch(),   command_calibrate(), command_bench(),   command_qgis_plugin()};
    return list;
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
        std::istringstream lines(command.form.usage);
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

namespace options = boost::program_options;

namespace {

constexpr std::size_t k_least_help = 40, k_most_help = 80;  // columns of the options

/// Options that went, and what to use.
constexpr std::array<std::array<const char*, 2>, 8> k_gone_options{{
    {"--beside", "Use --difference"},
    {"--fly", "Draw --view 3d from one --camera"},
    {"--legend", "Remove it: colours are in classes"},
    {"--organisation", "Write it into --author"},
    {"--background-licence", "Write it into --attribution"},
    {"--schema", "Use --json: keys with types and limits"},
    {"--schemes", "Run it again with --set numerics.scheme=..."},
    {"--uninstall", "Uninstall it in QGIS, Plugins"},
}};

/// An empty argument, from an unset variable of a script, would replace the intended folder or file.
void refuse_empty_words(const Options& values, const CommandForm& form) {
    Problems problems;
    const auto check = [&](const std::string& name, const std::string& word) {
        if (!word.empty()) return;
        problems.add({"is empty", name == "operand" ? Place(form.operand.c_str()) : Place("--" + name), "", "",
                      "Usage: " + form.usage});
    };
    for (const auto& [name, value] : values) {
        const auto* option = form.options.find_nothrow(name, false);
        if (option != nullptr && option->semantic()->max_tokens() == 0) continue;  // a flag
        if (const auto* word = boost::any_cast<std::string>(&value.value())) check(name, *word);
        if (const auto* words = boost::any_cast<std::vector<std::string>>(&value.value()))
            for (const std::string& word : *words) check(name, word);
    }
    problems.throw_if_any();
}

}  // namespace

std::optional<Options> parse_arguments(const CommandForm& form, const Arguments& arguments) {
    const auto columns = static_cast<unsigned>(std::clamp(output_width(), k_least_help, k_most_help));
    options::options_description visible("Options", columns, columns / 2);
    for (const auto& option : form.options.options()) visible.add(option);
    visible.add_options()("help,h", "print this help");
    options::options_description all = visible;
    options::positional_options_description positions;
    if (!form.operand.empty()) {
        if (form.repeats)
            all.add_options()("operand", options::value<std::vector<std::string>>());
        else
            all.add_options()("operand", options::value<std::string>());
        positions.add("operand", form.repeats ? -1 : 1);
    }
    Options values;
    values.words = arguments;
    try {
        // Guessing abbreviations would turn a misspelt option into another one.
        using namespace options::command_line_style;
        options::store(options::command_line_parser(arguments)
                           .options(all)
                           .positional(positions)
                           .style(unix_style & ~allow_guessing)
                           .run(),
                       values);
    } catch (const options::unknown_option& unknown) {
        for (const auto& [option, remedy] : k_gone_options)
            if (unknown.get_option_name() == option)
                throw Error(ErrorKind::input, Problem{"is no longer an option", option, "", "", remedy});
        throw Error(ErrorKind::input, Problem{unknown.what(), "command line", "", "", "Usage: " + form.usage});
    } catch (const options::error& error) {
        throw Error(ErrorKind::input, Problem{error.what(), "command line", "", "", "Usage: " + form.usage});
    }
    if (values.count("help") > 0) {
        std::cout << folded("Usage: " + form.usage + "\n\n" + form.purpose + "\n\n", output_width()) << visible;
        return std::nullopt;
    }
    if (!form.operand.empty() && !form.operand_optional && values.count("operand") == 0) {
        throw Error(ErrorKind::input,
                    Problem{form.operand + " is missing", "command line", "", "", "Usage: " + form.usage});
    }
    refuse_empty_words(values, form);
    return values;
}

int run_command(const Command& command, const Arguments& arguments) {
    const auto values = parse_arguments(command.form, arguments);
    return values ? command.run(*values) : static_cast<int>(ExitCode::done);
}

std::optional<std::string> text_option(const Options& values, const std::string& name) {
    if (values.count(name) == 0) return std::nullopt;
    return values[name].as<std::string>();
}

std::vector<std::string> text_options(const Options& values, const std::string& name) {
    if (values.count(name) == 0) return {};
    return values[name].as<std::vector<std::string>>();
}

int thread_count(const Options& values) {
    constexpr std::int64_t k_most_threads = 1024;
    const auto text = text_option(values, "threads");
    if (!text) return static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    const auto count = integer_from_text(*text);
    if (!count || *count < 1 || *count > k_most_threads) {
        throw Error(ErrorKind::input, Problem{"is not a number of threads", "--threads", *text,
                                              "1 to " + std::to_string(k_most_threads), ""});
    }
    return static_cast<int>(*count);
}

std::optional<Size> size_option(const Options& values) {
    const auto text = text_option(values, "size");
    if (!text) return std::nullopt;
    const auto size = size_from_text(*text);
    if (!size) {
        throw Error(ErrorKind::input, Problem{"is not a picture's size", "--size", *text, size_forms(),
                                              "Write for example 1600x1200 or A4@300"});
    }
    return size;
}

std::optional<double> threshold_option(const Options& values) {
    const auto text = text_option(values, "threshold");
    if (!text) return std::nullopt;
    const auto metres = number_from_text(*text);
    for (const Parameter& key : scene_parameters()) {  // the option replaces it
        if (key.name() != "observed.threshold" || (metres && key.fits(*metres))) continue;
        throw Error(ErrorKind::input, Problem{"is not a depth", "--threshold", *text, key.limits + " " + key.unit, ""});
    }
    return metres;
}

Json document_of(const std::string& command) {
    return {{"program", k_program}, {"version", k_version}, {"command", command}, {"exit_code", 0}};
}

std::string error_document(const Arguments& words, ExitCode code, const std::vector<Problem>& problems) {
    Json json = document_of(words.empty() ? "" : words.front());
    json["exit_code"] = static_cast<int>(code);
    json["errors"] = Json::array();
    for (const Problem& problem : problems) {
        Json one{{"message", describe(problem)}, {"what", problem.what}, {"where", problem.where.text}};
        const auto add = [&](const char* name, const std::string& text) {
            one[name] = text.empty() ? Json() : Json(text);
        };
        add("file", problem.where.file);
        add("key", problem.where.key);
        add("option", problem.where.option);
        add("value", problem.value);
        add("limit", problem.limit);
        add("remedy", problem.remedy);
        json["errors"].push_back(std::move(one));
    }
    return json_text(json);
}

bool wants_document(const Arguments& words) {
    // `frana params --json` is another document.
    if (words.empty() || words.front() == "params") return false;
    return std::find(words.begin(), words.end(), "--json") != words.end();
}

void print_document(const Json& document) {
    std::cout << json_text(document);
}

}  // namespace frana::app
