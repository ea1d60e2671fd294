// SPDX-License-Identifier: Apache-2.0
#include "params/grammar/data_file.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <utility>

#include "core/text.h"
#include "params/grammar/ini_file.h"
#include "params/grammar/value_text.h"

namespace frana {

namespace fs = std::filesystem;

DataFile::DataFile(const std::string& path, std::string label, std::string guide, Problems& problems)
    : label_(std::move(label)), guide_(std::move(guide)), problems_(problems) {
    for (const IniEntry& entry : read_ini(path)) {
        if (!entries_.emplace(entry.name, entry.value).second)
            refuse("is given more than once", entry.name, entry.value, "", "Keep one of the lines");
        if (entry.value.empty()) refuse("has no value", entry.name, "", "", "Give one or remove the key");
        if (valid_utf8(entry.value) != entry.value)
            refuse("is not UTF-8", entry.name, valid_utf8(entry.value), "", "Save the file as UTF-8");
    }
}

void DataFile::refuse(const std::string& what, const std::string& key, const std::string& value,
                      const std::string& limit, const std::string& remedy) {
    problems_.add({what, Place(label_, key), value, limit, remedy});
}

std::optional<std::string> DataFile::taken(const std::string& key) {
    known_.push_back(key);
    const auto found = entries_.find(key);
    if (found == entries_.end()) return std::nullopt;
    std::string value = found->second;
    entries_.erase(found);
    return value;
}

std::string DataFile::required(const std::string& key) {
    const auto value = taken(key);
    if (!value) refuse("is missing", key, "", "", "Give it a value");
    return value.value_or("");
}

std::string DataFile::named(const std::string& key, OwnTexts& texts) {
    std::string english = required(key);
    if (english.find(':') != std::string::npos)
        refuse("contains a colon, which separates a name from its limits", key, english, "", "Write it without");
    for (const LanguageRow& language : languages().subspan(1))
        if (const auto text = taken(key + "-" + language.code)) texts[language.code][english] = *text;
    return english;
}

std::vector<double> DataFile::rising(const std::string& key, const std::string& text) {
    std::vector<double> numbers;
    for (const std::string& word : words_of(text)) {
        const auto number = number_from_text(word);
        if (!number || !(*number > (numbers.empty() ? 0 : numbers.back()))) {
            refuse("'" + word + "' is not a greater number", key, text, "rising numbers greater than 0",
                   "Write for example 30, 100, 300");
            break;
        }
        numbers.push_back(*number);
    }
    return numbers;
}

std::vector<int> DataFile::numbered(const std::string& prefix, int most) const {
    std::set<int> numbers;
    const std::string begin = prefix + "-";
    for (const auto& [key, text] : entries_) {
        if (!key.starts_with(begin)) continue;
        const auto number = integer_from_text(key.substr(begin.size(), key.find('.') - begin.size()));
        if (number && *number >= 1 && *number <= most) numbers.insert(static_cast<int>(*number));
    }
    return {numbers.begin(), numbers.end()};
}

bool DataFile::has_section(const std::string& section) const {
    return std::any_of(entries_.begin(), entries_.end(),
                       [&](const auto& entry) { return entry.first.starts_with(section + "."); });
}

void DataFile::refuse_rest() {
    for (const auto& [key, value] : entries_)
        refuse("unknown key", key, "", "",
               nearest_name(key, known_).empty() ? guide_ + " lists the keys"
                                                 : "Did you mean " + nearest_name(key, known_) + "?");
}

std::vector<std::string> data_files(const std::string& share, const DataFolder& of) {
    const fs::path place = fs::path(share) / of.folder;
    std::error_code error;
    std::vector<std::string> files;
    for (const fs::directory_entry& entry : fs::directory_iterator(place, error))
        if (entry.path().extension() == ".ini") files.push_back(entry.path().string());
    if (error)
        throw Error(ErrorKind::environment, Problem{std::string("the folder of ") + of.what + "s cannot be read",
                                                    place.string(), "", "", "Set FRANA_SHARE to frana's share folder"});
    std::sort(files.begin(), files.end());
    return files;
}

std::vector<std::string> data_names(const std::string& share, const DataFolder& of) {
    std::vector<std::string> names;
    for (const std::string& file : data_files(share, of)) names.push_back(fs::path(file).stem().string());
    return names;
}

std::optional<std::string> data_file_of(const std::string& value, const std::string& share, const DataFolder& of,
                                        const Place& where, Problems& problems) {
    if (is_own_file(value)) return value;
    const std::vector<std::string> names = data_names(share, of);
    if (std::find(names.begin(), names.end(), value) != names.end())
        return (fs::path(share) / of.folder / (value + ".ini")).string();
    // A table of earlier versions, named after a program whose classes of terrain are others.
    if (value == "ramms-avalanche")
        return problems.add({"is no longer a friction table", where, value, "",
                             "Use ngi-avalanche: the same values, by curvature; RAMMS also takes the slope"}),
               std::nullopt;
    problems.add(
        {std::string("is not a ") + of.what, where, value, joined(names, ", ") + ", or a file FILE.ini", of.lists});
    return std::nullopt;
}

}  // namespace frana
