// SPDX-License-Identifier: Apache-2.0
#include "app/text/text_file.h"

#include <boost/uuid/name_generator_sha1.hpp>
#include <boost/uuid/uuid_io.hpp>
#include <fstream>
#include <map>

#include "core/files.h"

namespace frana::app {

std::string text_hash(const std::string& text) {
    return to_string(boost::uuids::name_generator_sha1(boost::uuids::ns::url())(text));
}

namespace {

std::string with_hash(const std::string& stem, const std::string& name) {
    return stem + "_" + text_hash(name).substr(0, 8);
}

// Independent of the locale, which must not affect names of files.
bool is_plain(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-';
}

std::string plain(std::string name) {
    for (char& c : name)
        if (!is_plain(c)) c = '_';
    return name;
}

std::string small_letters(std::string text) {
    for (char& c : text)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return text;
}

}  // namespace

std::string shortened_name(const std::string& name, std::size_t most) {
    constexpr std::size_t k_hash = 9;  // with the line before it
    if (name.size() <= most) return name;
    std::size_t cut = most - k_hash;
    while (cut > 0 && (static_cast<unsigned char>(name[cut]) & 0xC0) == 0x80) --cut;  // do not cut within a character
    return with_hash(name.substr(0, cut), name);
}

std::vector<std::string> file_stems(const std::vector<std::string>& names) {
    std::map<std::string, int> all, unchanged;  // names per stem, and how many of them equal it
    for (const std::string& name : names) {
        const std::string stem = plain(name), key = small_letters(stem);
        ++all[key];
        if (stem == name) ++unchanged[key];
    }
    std::vector<std::string> stems;
    for (const std::string& name : names) {
        const std::string stem = plain(name), key = small_letters(stem);
        const bool alone = all[key] == 1 || (stem == name && unchanged[key] == 1);
        stems.push_back(alone ? shortened_name(stem) : with_hash(shortened_name(stem), name));
    }
    return stems;
}

void write_text_file(const std::string& path, const std::string& text) {
    write_file(path, text);
}

std::string read_text_file(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace frana::app
