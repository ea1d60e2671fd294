// SPDX-License-Identifier: Apache-2.0
#include "params/grammar/ini_file.h"

#include <boost/program_options/options_description.hpp>
#include <boost/program_options/parsers.hpp>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "core/error.h"
#include "params/grammar/value_text.h"

namespace frana {
namespace {

constexpr std::uintmax_t k_most_bytes = 10'000'000;

// The library cuts a line at any '#'. No UTF-8 text contains these bytes.
const std::string k_number_sign = "\xFF\xFE\xFF";

/// A '#' within a word belongs to it, as in the name of a folder; at the start of a line or after a space it starts a
/// comment.
std::string with_signs_in_words_kept(const std::string& text) {
    std::string kept;
    bool comment = false, space = true;
    for (const char c : text) {
        const bool sign = c == '#', end = c == '\n';
        comment = !end && (comment || (sign && space));
        space = end || c == ' ' || c == '\t' || c == '\r';
        kept += sign && !comment ? k_number_sign : std::string(1, c);
    }
    return kept;
}

std::string with_signs_back(std::string value) {
    for (auto at = value.find(k_number_sign); at != std::string::npos; at = value.find(k_number_sign, at))
        value.replace(at, k_number_sign.size(), "#");
    return value;
}

}  // namespace

std::vector<IniEntry> read_ini(const std::string& path) {
    namespace options = boost::program_options;
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored))
        throw Error(ErrorKind::input, Problem{"is a folder, not a file", path, "", "", "Name the .ini file in it"});
    if (std::filesystem::is_other(path, ignored))
        throw Error(ErrorKind::input, Problem{"is not a regular file", path, "", "",
                                              "Copy the content of the FIFO, device or socket into a file"});
    if (const auto bytes = std::filesystem::file_size(path, ignored); !ignored && bytes > k_most_bytes)
        throw Error(ErrorKind::input, Problem{"is too long for a scene", path, std::to_string(bytes) + " bytes",
                                              "up to " + std::to_string(k_most_bytes), "A scene is an INI file"});
    std::ifstream file(path, std::ios::binary);
    if (!file)
        throw Error(ErrorKind::input,
                    Problem{"cannot be opened", path, "", "", "Check that the file exists and may be read"});
    std::stringstream content;
    content << file.rdbuf();
    std::string text = content.str();
    if (text.rfind("\xEF\xBB\xBF", 0) == 0) text.erase(0, 3);  // byte order mark of Windows editors
    if (text.find('\0') != std::string::npos)
        throw Error(ErrorKind::input, Problem{"is not a text file", path, "", "", "A scene is an INI file"});

    std::vector<IniEntry> entries;
    try {
        std::istringstream stream(with_signs_in_words_kept(text));
        // No option is registered: the caller matches the keys and can suggest the nearest one.
        const auto parsed = options::parse_config_file(stream, options::options_description{}, true);
        for (const auto& option : parsed.options)
            entries.push_back({with_signs_back(option.string_key),
                               option.value.empty() ? "" : with_signs_back(trimmed(option.value.front()))});
    } catch (const options::error& error) {
        throw Error(ErrorKind::input, Problem{with_signs_back(error.what()), path, "",
                                              "[section], key = value or # comment", "Correct the line"});
    }
    return entries;
}

}  // namespace frana
