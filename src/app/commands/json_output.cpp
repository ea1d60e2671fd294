// SPDX-License-Identifier: Apache-2.0
#include "app/commands/json_output.h"

#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/commands/command_line.h"
#include "app/text/version.h"
#include "params/grammar/value_text.h"
#include "params/keys/scene_parameters.h"

namespace frana::app {
namespace {

/// The parts of Problem::where, which is "FILE: KEY", "--set KEY", "--OPTION", "FILE" or a few words.
void add_place(const std::string& where, Json& json) {
    json["where"] = where;
    for (const char* part : {"file", "key", "option"}) json[part] = nullptr;
    std::string rest = where;
    if (rest.rfind("--", 0) == 0) {
        const auto space = rest.find(' ');
        json["option"] = rest.substr(0, space);
        if (space == std::string::npos) return;
        rest = rest.substr(space + 1);
    }
    const std::vector<Parameter>& parameters = scene_parameters();
    const auto colon = rest.rfind(": ");
    const std::string last = colon == std::string::npos ? rest : rest.substr(colon + 2);
    const auto is_key_letter = [](char letter) {
        return (letter >= 'a' && letter <= 'z') || (letter >= '0' && letter <= '9') || letter == '-' || letter == '.';
    };
    const bool is_key = find_parameter(parameters, last) != nullptr ||
                        (colon != std::string::npos && last.find('.') != std::string::npos &&
                         std::all_of(last.begin(), last.end(), is_key_letter));
    if (is_key) {
        json["key"] = last;
        if (colon != std::string::npos) json["file"] = rest.substr(0, colon);
    } else if (rest.find('.') != std::string::npos || rest.find('/') != std::string::npos) {
        json["file"] = rest;
    }
}

/// The cells of a line of CSV (RFC 4180).
std::vector<std::string> cells_of(const std::string& line) {
    std::vector<std::string> cells(1);
    bool quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i] == '"') {
            if (quoted && i + 1 < line.size() && line[i + 1] == '"')
                cells.back() += line[++i];
            else
                quoted = !quoted;
        } else if (line[i] == ',' && !quoted) {
            cells.emplace_back();
        } else {
            cells.back() += line[i];
        }
    }
    return cells;
}

}  // namespace

Json document_of(const std::string& command) {
    return {{"program", k_program}, {"version", k_version}, {"command", command}, {"exit_code", 0}};
}

std::string error_document(const Arguments& words, ExitCode code, const std::vector<Problem>& problems) {
    Json json = document_of(words.empty() ? "" : words.front());
    json["exit_code"] = static_cast<int>(code);
    json["errors"] = Json::array();
    for (const Problem& problem : problems) {
        Json one{{"message", describe(problem)}, {"what", problem.what}};
        add_place(problem.where, one);
        const auto add = [&](const char* name, const std::string& text) {
            one[name] = text.empty() ? Json() : Json(text);
        };
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

Json rows_of(const std::string& csv) {
    Json rows = Json::array();
    std::istringstream lines(csv);
    std::string line;
    std::getline(lines, line);
    const std::vector<std::string> titles = cells_of(line);
    while (std::getline(lines, line)) {
        const std::vector<std::string> cells = cells_of(line);
        Json row = Json::object();
        for (std::size_t i = 0; i < std::min(titles.size(), cells.size()); ++i) {
            const auto whole = integer_from_text(cells[i]);
            const auto number = number_from_text(cells[i]);
            row[titles[i]] = whole                                   ? Json(*whole)
                             : number                                ? Json(*number)
                             : cells[i].empty() || cells[i] == "nan" ? Json()
                                                                     : Json(cells[i]);
        }
        rows.push_back(std::move(row));
    }
    return rows;
}

void print_document(const Json& document) {
    std::cout << json_text(document);
}

}  // namespace frana::app
