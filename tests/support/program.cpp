// SPDX-License-Identifier: Apache-2.0
#include "support/program.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>
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
    const auto seconds = [](const timeval& time) {
        return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    };
    Outcome outcome{WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status), read_text(out), read_text(err),
                    1024.0 * static_cast<double>(used.ru_maxrss), seconds(used.ru_utime) + seconds(used.ru_stime)};
    ::unlink(out.c_str());
    ::unlink(err.c_str());
    return outcome;
}

Outcome succeeded(const Outcome& outcome, const std::source_location& place) {
    if (outcome.exit_code == 0) return outcome;
    throw std::runtime_error(std::string(place.file_name()) + ":" + std::to_string(place.line()) + ": exit code " +
                             std::to_string(outcome.exit_code) + "\n" + outcome.out + outcome.err);
}

Outcome refusal_of(const Outcome& outcome, const std::vector<std::string>& words, const std::source_location& place) {
    const ::testing::ScopedTrace trace(place.file_name(), static_cast<int>(place.line()), "refused");
    EXPECT_EQ(outcome.exit_code, 2) << outcome.out << outcome.err;
    expect_words(outcome.err, words);
    return outcome;
}

std::vector<std::string> with_more(std::vector<std::string> words, const std::vector<std::string>& more) {
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

std::vector<std::string> with_sets(std::vector<std::string> words, const std::vector<std::string>& sets) {
    for (const std::string& one : sets) words.insert(words.end(), {"--set", one});
    return words;
}

namespace {

// Returns those nearest the root.
std::vector<Json> find_in(const Json& root, const std::string& key) {
    for (std::vector<Json> level{root}; !level.empty();) {
        std::vector<Json> found, next;
        for (const Json& parent : level) {
            if (parent.contains(key)) found.push_back(parent[key]);
            if (parent.is_structured()) next.insert(next.end(), parent.begin(), parent.end());
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

void expect_words(const std::string& text, const std::vector<std::string>& words) {
    for (const std::string& word : words)
        EXPECT_NE(text.find(word), std::string::npos) << "no \"" << word << "\" in:\n" << text;
}

void expect_no_words(const std::string& text, const std::vector<std::string>& words) {
    for (const std::string& word : words)
        EXPECT_EQ(text.find(word), std::string::npos) << '"' << word << "\" in:\n" << text;
}

Json parse_json(const std::string& text) {
    Json json = Json::parse(text, nullptr, false);
    EXPECT_FALSE(json.is_discarded()) << "no JSON:\n" << text;
    return json;
}

Json json_value(const std::string& json, const std::string& key) {
    std::vector<Json> found{parse_json(json)};
    std::istringstream names(key);
    for (std::string name; std::getline(names, name, '.');) {
        found = find_in(found.front(), name);
        EXPECT_EQ(found.size(), 1U) << key << " in\n" << json;
        if (found.size() != 1) return {};
    }
    return found.front();
}

std::string json_text(const std::string& json, const std::string& key) {
    const Json value = json_value(json, key);
    EXPECT_TRUE(value.is_string()) << key << " is no text in\n" << json;
    return value.is_string() ? value.get<std::string>() : "";
}

double json_number(const std::string& json, const std::string& key) {
    const Json value = json_value(json, key);
    EXPECT_TRUE(value.is_number()) << key << " is no number in\n" << json;
    return value.is_number() ? value.get<double>() : std::nan("");
}

bool json_has(const std::string& json, const std::string& key) {
    return !find_in(parse_json(json), key).empty();
}

bool json_lists(const std::string& json, const std::string& key, const std::string& words) {
    const Json list = json_value(json, key);
    return std::any_of(list.begin(), list.end(),
                       [&](const Json& text) { return text.get<std::string>().find(words) != std::string::npos; });
}

}  // namespace frana::test
