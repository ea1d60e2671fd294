// SPDX-License-Identifier: Apache-2.0
#include "program.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <boost/property_tree/json_parser.hpp>
#include <boost/property_tree/ptree.hpp>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <thread>

namespace frana::test {

Outcome run_program(const std::string& folder, const std::vector<std::string>& arguments, int signal_after_ms) {
    const std::string out = folder + "/.stdout", err = folder + "/.stderr";
    std::vector<char*> words{const_cast<char*>(FRANA_PROGRAM)};
    for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
    words.push_back(nullptr);

    const pid_t child = ::fork();
    if (child == 0) {
        const int out_file = ::open(out.c_str(), O_CREAT | O_TRUNC | O_WRONLY, 0644);
        const int err_file = ::open(err.c_str(), O_CREAT | O_TRUNC | O_WRONLY, 0644);
        if (::chdir(folder.c_str()) != 0 || ::dup2(out_file, 1) < 0 || ::dup2(err_file, 2) < 0) ::_exit(126);
        ::execv(FRANA_PROGRAM, words.data());
        ::_exit(127);
    }
    if (signal_after_ms > 0) {
        std::this_thread::sleep_for(std::chrono::milliseconds(signal_after_ms));
        ::kill(child, SIGINT);
    }
    int status = 0;
    rusage used{};
    ::wait4(child, &status, 0, &used);
    Outcome outcome{WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status), read_text(out), read_text(err),
                    1024.0 * static_cast<double>(used.ru_maxrss)};
    ::unlink(out.c_str());
    ::unlink(err.c_str());
    return outcome;
}

namespace {

using Tree = boost::property_tree::ptree;

std::vector<Tree> find_in(const std::string& json, const std::string& key) {
    Tree root;
    try {
        std::istringstream stream(json);
        boost::property_tree::read_json(stream, root);
    } catch (const boost::property_tree::json_parser_error& error) {
        ADD_FAILURE() << "no JSON: " << error.what() << "\n" << json;
        return {};
    }
    if (key.find('.') != std::string::npos) {
        const auto child = root.get_child_optional(key);
        return child ? std::vector<Tree>{*child} : std::vector<Tree>{};
    }
    for (std::vector<Tree> level{root}; !level.empty();) {
        std::vector<Tree> found, next;
        for (const Tree& tree : level)
            for (const auto& [name, child] : tree) {
                if (name == key) found.push_back(child);
                next.push_back(child);
            }
        if (!found.empty()) return found;
        level = std::move(next);
    }
    return {};
}

}  // namespace

std::string read_text(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::stringstream content;
    content << file.rdbuf();
    return content.str();
}

std::string json_text(const std::string& json, const std::string& key) {
    const std::vector<Tree> found = find_in(json, key);
    EXPECT_EQ(found.size(), 1U) << key << " in\n" << json;
    return found.size() == 1 ? found.front().data() : "";
}

double json_number(const std::string& json, const std::string& key) {
    const std::string text = json_text(json, key);
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    EXPECT_TRUE(!text.empty() && *end == '\0') << key << " is no number in\n" << json;
    return value;
}

bool json_has(const std::string& json, const std::string& key) {
    return !find_in(json, key).empty();
}

}  // namespace frana::test
