// SPDX-License-Identifier: Apache-2.0
#include "app/commands/command_line.h"

#include <algorithm>
#include <boost/any.hpp>
#include <boost/program_options/cmdline.hpp>
#include <boost/program_options/parsers.hpp>
#include <boost/program_options/positional_options.hpp>
#include <boost/program_options/value_semantic.hpp>
#include <cctype>
#include <iostream>
#include <sstream>
#include <thread>

#include "app/commands/commands.h"
#include "app/input/share_directory.h"
#include "app/process/terminal.h"
#include "app/text/text_table.h"
#include "core/error.h"
#include "core/text.h"
#include "params/keys/materials.h"
#include "params/keys/result_rasters.h"
#include "params/keys/scene_parameters.h"

namespace frana::app {

namespace options = boost::program_options;

namespace {

constexpr std::size_t k_least_help = 40, k_most_help = 80;  // columns of the options

/// An empty argument, from an unset variable of a script, would replace the intended folder or file.
void refuse_empty_words(const options::variables_map& values, const CommandForm& form) {
    Problems problems;
    const auto check = [&](const std::string& name, const std::string& word) {
        if (!word.empty()) return;
        problems.add({"is empty", name == "operand" ? form.operand : "--" + name, "", "", "Usage: " + form.usage});
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

std::optional<options::variables_map> parse_arguments(const CommandForm& form,
                                                      const std::vector<std::string>& arguments) {
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
    options::variables_map values;
    try {
        // Guessing abbreviations would turn a misspelt option into another one.
        using namespace options::command_line_style;
        options::store(options::command_line_parser(arguments)
                           .options(all)
                           .positional(positions)
                           .style(unix_style & ~allow_guessing)
                           .run(),
                       values);
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

std::optional<std::string> text_option(const options::variables_map& values, const std::string& name) {
    if (values.count(name) == 0) return std::nullopt;
    return values[name].as<std::string>();
}

std::vector<std::string> text_options(const options::variables_map& values, const std::string& name) {
    if (values.count(name) == 0) return {};
    return values[name].as<std::vector<std::string>>();
}

int thread_count(const options::variables_map& values) {
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

std::optional<Size> size_option(const options::variables_map& values) {
    const auto text = text_option(values, "size");
    if (!text) return std::nullopt;
    const auto size = size_from_text(*text);
    if (!size) {
        throw Error(ErrorKind::input, Problem{"is not a picture's size", "--size", *text, k_sizes,
                                              "Write for example 1600x1200 or A4@300"});
    }
    return size;
}

std::optional<double> threshold_option(const options::variables_map& values) {
    const auto text = text_option(values, "threshold");
    if (!text) return std::nullopt;
    const auto metres = number_from_text(*text);
    for (const Parameter& key : scene_parameters()) {  // the option replaces it
        if (key.name() != "observed.threshold" || (metres && key.fits(*metres))) continue;
        throw Error(ErrorKind::input, Problem{"is not a depth", "--threshold", *text, key.limits + " " + key.unit, ""});
    }
    return metres;
}

std::vector<OptionRow> option_rows(const CommandForm& form) {
    std::vector<OptionRow> rows;
    for (const auto& option : form.options.options()) {
        OptionRow row{"--" + option->long_name(), "", "", option->description()};
        const std::string brief = option->canonical_display_name(options::command_line_style::allow_dash_for_short);
        if (brief.size() == 2 && brief.front() == '-') row.brief = brief;
        if (option->semantic()->max_tokens() > 0) {
            row.value = option->semantic()->name();
            // Boost adds the default: "N (=3)".
            row.value = row.value.substr(0, row.value.find(" (="));
        }
        rows.push_back(std::move(row));
    }
    rows.push_back({"--allow-network", "", "", "inputs may be URLs, databases and map services"});
    rows.push_back({"--help", "-h", "", "print the help of the command"});
    return rows;
}

}  // namespace frana::app
