// SPDX-License-Identifier: Apache-2.0
#include "params/scene/read_scheme.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "core/text.h"
#include "core/words/words.h"
#include "params/grammar/ini_file.h"
#include "params/grammar/value_text.h"

namespace frana {
namespace {

namespace fs = std::filesystem;

constexpr int k_most_classes = 254;  // bytes of a raster in which 0 is no data

/// Takes the entries of a file one by one and collects what is wrong with them.
class SchemeReader {
  public:
    SchemeReader(const std::string& path, const std::string& label, Problems& problems)
        : label_(label), problems_(problems) {
        for (const IniEntry& entry : read_ini(path)) {
            if (!entries_.emplace(entry.name, entry.value).second)
                refuse("is given more than once", entry.name, entry.value, "", "Keep one of the lines");
            if (entry.value.empty()) refuse("has no value", entry.name, "", "", "Give one or remove the key");
            if (valid_utf8(entry.value) != entry.value)
                refuse("is not UTF-8", entry.name, valid_utf8(entry.value), "", "Save the file as UTF-8");
        }
    }

    HazardScheme read(const std::string& name) {
        HazardScheme scheme{.name = name};
        scheme.called = named("scheme.title", scheme);
        if (const auto kind = taken("scheme.classes-are"); kind && *kind != "intensities") {
            scheme.heading = worded("Zones");
            if (*kind != "zones") refuse("is not known", "scheme.classes-are", *kind, "intensities, zones", "");
        }
        scheme.named_source = required("scheme.source");
        scheme.quote = taken("scheme.quote").value_or("");
        scheme.read_at = taken("scheme.read-at").value_or("");
        if (scheme.quote.empty() != scheme.read_at.empty())
            refuse("quote and read-at belong together", scheme.quote.empty() ? "scheme.read-at" : "scheme.quote", "",
                   "words of the source, and where they were read", "Give both, or none if no source was read");
        scheme.source = scheme.quote.empty() ? k_source_not_read : scheme.named_source;
        if (const auto periods = taken("scheme.return-periods"))
            scheme.periods = rising("scheme.return-periods", *periods);
        read_classes(scheme);
        read_matrix(scheme);
        write_thresholds(scheme);
        for (const auto& [key, value] : entries_)
            refuse("unknown key", key, "", "",
                   nearest_name(key, known_).empty() ? "share/doc/hazard.md lists the keys"
                                                     : "Did you mean " + nearest_name(key, known_) + "?");
        return scheme;
    }

  private:
    void refuse(const std::string& what, const std::string& key, const std::string& value, const std::string& limit,
                const std::string& remedy) {
        problems_.add({what, label_ + ": " + key, value, limit, remedy});
    }
    std::optional<std::string> taken(const std::string& key) {
        known_.push_back(key);
        const auto found = entries_.find(key);
        if (found == entries_.end()) return std::nullopt;
        std::string value = found->second;
        entries_.erase(found);
        return value;
    }
    std::string required(const std::string& key) {
        const auto value = taken(key);
        if (!value) refuse("is missing", key, "", "", "Give it a value");
        return value.value_or("");
    }
    /// A name and, as KEY-it and so on, what it is in other languages.
    std::string named(const std::string& key, HazardScheme& scheme) {
        std::string english = required(key);
        if (english.find(':') != std::string::npos)
            refuse("contains a colon, which separates a name from its limits", key, english, "", "Write it without");
        for (const LanguageRow& language : languages().subspan(1))
            if (const auto text = taken(key + "-" + language.code)) scheme.texts[language.code][english] = *text;
        return english;
    }
    std::vector<double> rising(const std::string& key, const std::string& text) {
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

    Rgb colour(const std::string& key) {
        const std::string text = required(key);
        const bool is_hex = text.size() == 6 && text.find_first_not_of("0123456789abcdefABCDEF") == text.npos;
        if (!text.empty() && !is_hex) refuse("is not a colour", key, text, "six hexadecimal digits", "Write d7191c");
        const auto part = [&](std::size_t at) {
            return is_hex ? static_cast<std::uint8_t>(std::stoi(text.substr(at, 2), nullptr, 16)) : std::uint8_t{0};
        };
        return {part(0), part(2), part(4)};
    }

    std::optional<HazardLimit> limit(const std::string& text) {
        const std::vector<std::string> words = words_of(text);
        if (words.size() != 4 || (words[1] != ">" && words[1] != ">=")) return std::nullopt;
        const auto number = number_from_text(words[2]);
        const auto rows = hazard_quantities();
        const auto row = std::find_if(rows.begin(), rows.end(), [&](const auto& one) { return words[0] == one.key; });
        if (row == rows.end() || words[3] != row->unit || !number || !(*number > 0)) return std::nullopt;
        return HazardLimit{static_cast<HazardQuantity>(row - rows.begin()), *number, words[1] == ">="};
    }

    HazardCondition condition(const std::string& key, const std::string& text) {
        HazardCondition any;
        for (const std::string& alternative : parts(text, " or ")) {
            any.emplace_back();
            for (const std::string& part : parts(alternative, " and ")) {
                if (const auto one = limit(part)) {
                    any.back().push_back(*one);
                    continue;
                }
                std::vector<std::string> forms;
                for (const HazardQuantityRow& row : hazard_quantities())
                    forms.push_back(std::string(row.key) + " > NUMBER " + row.unit);
                refuse("'" + trimmed(part) + "' is not a limit", key, text,
                       joined(forms, ", ") + "; > or >=, joined by and, or", "Write for example depth > 1 m");
            }
        }
        return any;
    }
    static std::vector<std::string> parts(const std::string& text, const std::string& separator) {
        std::vector<std::string> all;
        std::size_t begin = 0;
        for (std::size_t end = 0; end != std::string::npos; begin = end + separator.size()) {
            end = text.find(separator, begin);
            all.push_back(text.substr(begin, end == std::string::npos ? end : end - begin));
        }
        return all;
    }

    void read_classes(HazardScheme& scheme) {
        std::set<int> values;
        for (const auto& [key, text] : entries_) {
            const auto number =
                key.starts_with("class-") ? integer_from_text(key.substr(6, key.find('.') - 6)) : std::nullopt;
            if (number && *number >= 1 && *number <= k_most_classes) values.insert(static_cast<int>(*number));
        }
        if (values.empty()) refuse("has no classes", "class-1", "", "", "Add a section for each, from the lowest");
        for (const int value : values) {
            const std::string section = "class-" + std::to_string(value), key = section + ".condition";
            HazardClass kind{.value = value};
            kind.name = named(section + ".name", scheme);
            kind.colour = colour(section + ".colour");
            const auto text = taken(key);
            if (text) kind.condition = condition(key, *text);
            if (!text && (value > *values.begin() || values.size() == 1))
                refuse("is missing", key, "", "", "Only the lowest of several classes may have none");
            if (value > *values.begin() && !values.contains(value - 1))
                refuse("follows no class", section, "", "classes without a gap", "Number them one after the other");
            for (const HazardClass& lower : scheme.classes)
                if (lower.name == kind.name && !kind.name.empty())
                    refuse("is the name of two classes", section + ".name", kind.name, "", "Name one otherwise");
            if (text && !scheme.classes.empty() && !follows(scheme.classes.back().condition, kind.condition))
                refuse("holds where that of the class below does not", key, *text,
                       text_of(scheme.classes.back().condition), "Add what is missing to the class below");
            scheme.classes.push_back(std::move(kind));
        }
    }

    void read_matrix(HazardScheme& scheme) {
        if (std::none_of(entries_.begin(), entries_.end(),
                         [](const auto& entry) { return entry.first.starts_with("degree."); }))
            return;
        DegreeMatrix matrix;
        const std::string key = "degree.return-periods", text = required(key);
        const std::vector<double> periods = rising(key, text);
        if (periods.size() == k_probabilities)
            std::copy(periods.begin(), periods.end(), matrix.periods.begin());
        else
            refuse("are not three", key, text, "three rising numbers", "Write for example 30, 100, 300");
        for (int intensity = 1; intensity <= k_intensities; ++intensity) {
            const std::string row = "degree." + intensity_name(intensity), given = required(row);
            const std::vector<std::string> words = words_of(given);
            for (std::size_t p = 0; p < k_probabilities; ++p) {
                const auto degree = p < words.size() ? degree_from(words[p]) : std::nullopt;
                if (degree && words.size() == k_probabilities) {
                    matrix.degrees[static_cast<std::size_t>(intensity - 1)][p] = *degree;
                    continue;
                }
                refuse("are not three degrees", row, given, "red, blue, yellow, yellow-white",
                       "Write one for each return period");
                break;
            }
        }
        if (scheme.classes.empty() || scheme.classes.back().value != k_intensities)
            refuse("needs classes of intensity up to 3", key, "", "", "Remove the section [degree]");
        scheme.matrix = matrix;
    }

    std::string label_;
    Problems& problems_;
    std::map<std::string, std::string> entries_;
    std::vector<std::string> known_;
};

}  // namespace

HazardScheme read_scheme(const std::string& path, const std::string& label, Problems& problems) {
    return SchemeReader(path, label, problems).read(fs::path(path).stem().string());
}

std::vector<std::string> scheme_files(const std::string& share) {
    const fs::path folder = fs::path(share) / "schemes";
    std::error_code error;
    std::vector<std::string> files;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
        if (entry.path().extension() == ".ini") files.push_back(entry.path().string());
    if (error)
        throw Error(ErrorKind::environment, Problem{"the folder of hazard schemes cannot be read", folder.string(), "",
                                                    "", "Set FRANA_SHARE to frana's share folder"});
    std::sort(files.begin(), files.end());
    return files;
}

std::vector<std::string> scheme_names(const std::string& share) {
    std::vector<std::string> names;
    for (const std::string& file : scheme_files(share)) names.push_back(fs::path(file).stem().string());
    names.emplace_back(k_custom_scheme);
    return names;
}

std::optional<HazardScheme> resolved_scheme(const HazardSpec& spec, const std::string& share, const std::string& where,
                                            Problems& problems) {
    if (!spec.scheme) return std::nullopt;
    if (*spec.scheme == k_custom_scheme)
        return custom_scheme({spec.depth_limits, spec.velocity_limits, spec.flux_limits, spec.pressure_limits});
    std::string file = *spec.scheme;
    if (!is_scheme_file(file)) {
        const std::vector<std::string> names = scheme_names(share);
        if (std::find(names.begin(), names.end(), file) == names.end()) {
            problems.add({"is not a hazard scheme", where, file, joined(names, ", ") + ", or a file FILE.ini",
                          "`frana schemes` lists them"});
            return std::nullopt;
        }
        file = (fs::path(share) / "schemes" / (file + ".ini")).string();
    }
    return attempt(problems, [&] { return std::optional(read_scheme(file, file, problems)); });
}

}  // namespace frana
