// SPDX-License-Identifier: Apache-2.0
#include "params/scene/read_scheme.h"

#include <algorithm>
#include <filesystem>

#include "core/text.h"
#include "core/words/words.h"
#include "params/grammar/data_file.h"
#include "params/grammar/value_text.h"

namespace frana {
namespace {

namespace fs = std::filesystem;

constexpr int k_most_classes = 254;  // bytes of a raster in which 0 is no data

class SchemeReader : DataFile {
  public:
    SchemeReader(const std::string& path, const std::string& label, Problems& problems)
        : DataFile(path, label, "share/doc/hazard.md", problems) {}

    HazardScheme read(const std::string& name) {
        HazardScheme scheme{.name = name};
        describe("scheme", scheme);
        if (const auto kind = taken("scheme.classes-are"); kind && *kind != "intensities") {
            scheme.heading = worded("Zones");
            if (*kind != "zones") refuse("is not known", "scheme.classes-are", *kind, "intensities, zones", "");
        }
        scheme.source = scheme.quote.empty() ? k_source_not_read : scheme.named_source;
        if (const auto periods = taken("scheme.return-periods"))
            scheme.periods = rising("scheme.return-periods", *periods);
        read_least("scheme.least-area", "m2", scheme.least_area);
        read_least("scheme.least-width", "m", scheme.least_width);
        read_classes(scheme);
        read_matrix(scheme, "");
        for (const std::string process : k_processes) read_matrix(scheme, process);
        write_thresholds(scheme);
        refuse_rest();
        return scheme;
    }

  private:
    void read_least(const std::string& key, const std::string& unit, double& least) {
        const auto text = taken(key);
        if (!text) return;
        constexpr double k_most = 1e5;
        const std::vector<std::string> words = words_of(*text);
        const auto number = words.size() == 2 && words[1] == unit ? number_from_text(words[0]) : std::nullopt;
        if (number && *number >= 0 && *number <= k_most)
            least = *number;
        else
            refuse("is not a number with its unit", key, *text, "0 to " + shortest_text(k_most) + " " + unit,
                   "Write for example " + shortest_text(least) + " " + unit);
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
        const std::vector<int> values = numbered("class", k_most_classes);
        if (values.empty()) refuse("has no classes", "class-1", "", "", "Add a section for each, from the lowest");
        for (const int value : values) {
            const std::string section = "class-" + std::to_string(value), key = section + ".condition";
            HazardClass kind{.value = value};
            kind.name = named(section + ".name", scheme.texts);
            kind.colour = colour(section + ".colour");
            const auto text = taken(key);
            if (text) kind.condition = condition(key, *text);
            if (!text && (value > values.front() || values.size() == 1))
                refuse("is missing", key, "", "", "Only the lowest of several classes may have none");
            if (value > values.front() && std::find(values.begin(), values.end(), value - 1) == values.end())
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

    /// @param process of [degree-PROCESS]; empty: of [degree]
    void read_matrix(HazardScheme& scheme, const std::string& process) {
        const std::string section = process.empty() ? "degree" : "degree-" + process;
        if (!has_section(section)) return;
        ProcessMatrix& entry = scheme.matrices.emplace_back();
        entry.process = process;
        entry.source = taken(section + ".source").value_or(scheme.source);
        DegreeMatrix& matrix = entry.degrees;
        const std::string key = section + ".return-periods", text = required(key);
        const std::vector<double> periods = rising(key, text);
        if (periods.size() == k_probabilities)
            std::copy(periods.begin(), periods.end(), matrix.periods.begin());
        else
            refuse("are not three", key, text, "three rising numbers", "Write for example 30, 100, 300");
        for (int intensity = 1; intensity <= k_intensities; ++intensity) {
            const std::string row = section + "." + intensity_name(intensity), given = required(row);
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
            refuse("needs classes of intensity up to 3", key, "", "", "Remove the section [" + section + "]");
    }
};

}  // namespace

HazardScheme read_scheme(const std::string& path, const std::string& label, Problems& problems) {
    return SchemeReader(path, label, problems).read(fs::path(path).stem().string());
}

std::optional<HazardScheme> resolved_scheme(const HazardSpec& spec, const std::string& share, const Place& where,
                                            Problems& problems) {
    if (!spec.scheme) return std::nullopt;
    const auto file = data_file_of(*spec.scheme, share, k_scheme_folder, where, problems);
    if (!file) return std::nullopt;
    return attempt(problems, [&] { return std::optional(read_scheme(*file, *file, problems)); });
}

}  // namespace frana
