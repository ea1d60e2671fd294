// SPDX-License-Identifier: Apache-2.0
#include "study/read_study.h"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <set>

#include "core/text.h"
#include "params/grammar/ini_file.h"
#include "params/grammar/value_text.h"
#include "params/keys/parameter.h"
#include "params/keys/scene_parameters.h"
#include "study/distribution_text.h"
#include "study/sampling.h"

namespace frana::study {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t k_most_samples = 1'000'000;

struct NamedSampling {
    const char* name;
    Sampling sampling;
};
constexpr NamedSampling k_samplings[] = {{"sobol", Sampling::sobol},
                                         {"latin-hypercube", Sampling::latin_hypercube},
                                         {"random", Sampling::random},
                                         {"grid", Sampling::grid},
                                         {"saltelli", Sampling::saltelli}};
constexpr const char* k_table_word = "table:";

/// One key of [study]; the parser, the messages and the echo follow from it.
struct StudyKey {
    const char *name, *limits, *meaning;
    std::function<std::optional<ValueProblem>(StudySpec&, const std::string& text, const std::string& folder)> read;
    std::function<std::optional<std::string>(const StudySpec&)> write;
};

std::optional<ValueProblem> read_sampling(StudySpec& study, const std::string& text, const std::string& folder) {
    if (text.starts_with(k_table_word)) {
        const std::string file = trimmed(text.substr(std::string(k_table_word).size()));
        if (file.empty()) return ValueProblem{"names no file", "Write table:FILE.csv"};
        study.sampling = Sampling::table;
        study.table = absolute_path(file, folder);
        return std::nullopt;
    }
    for (const NamedSampling& one : k_samplings) {
        if (text != one.name) continue;
        study.sampling = one.sampling;
        return std::nullopt;
    }
    return ValueProblem{"is not one of the choices", ""};
}

const std::vector<StudyKey>& study_keys() {
    static const std::vector<StudyKey> k_keys{
        {"scene", "a scene file", "The scene whose keys vary.",
         [](StudySpec& study, const std::string& text, const std::string& folder) -> std::optional<ValueProblem> {
             study.scene = absolute_path(text, folder);
             return std::nullopt;
         },
         [](const StudySpec& study) { return study.scene; }},
        {"samples", "2 to 1000000",
         "Number of members; with sampling = grid, and with until, the most; with levels the budget, in such runs.",
         [](StudySpec& study, const std::string& text, const std::string&) -> std::optional<ValueProblem> {
             const auto count = integer_from_text(text);
             if (!count) return ValueProblem{"is not a whole number", ""};
             if (*count < 2 || *count > k_most_samples) return ValueProblem{"is out of range", ""};
             study.samples = *count;
             return std::nullopt;
         },
         [](const StudySpec& study) -> std::optional<std::string> {
             if (study.sampling == Sampling::table || study.per_polygon()) return std::nullopt;
             return std::to_string(study.samples);
         }},
        {"sampling", "sobol, latin-hypercube, random, grid, saltelli, table:FILE.csv",
         "How the values of the members are drawn.", read_sampling,
         [](const StudySpec& study) -> std::optional<std::string> {
             if (study.per_polygon()) return std::nullopt;
             return study.sampling == Sampling::table ? k_table_word + study.table : name_of(study.sampling);
         }},
        {"per-polygon", "on, off",
         "Each polygon of the release perimeter is a member of its own; nothing is drawn from distributions.",
         [](StudySpec& study, const std::string& text, const std::string&) -> std::optional<ValueProblem> {
             if (text != "on" && text != "off") return ValueProblem{"is not one of the choices", ""};
             if (text == "on") study.sampling = Sampling::polygons;
             return std::nullopt;
         },
         [](const StudySpec& study) -> std::optional<std::string> {
             if (!study.per_polygon()) return std::nullopt;
             return "on";
         }},
        {"seed", "0 to 2147483647", "The same seed gives the same members.",
         [](StudySpec& study, const std::string& text, const std::string&) -> std::optional<ValueProblem> {
             const auto seed = integer_from_text(text);
             if (!seed) return ValueProblem{"is not a whole number", ""};
             if (*seed < 0 || *seed > 2147483647) return ValueProblem{"is out of range", ""};
             study.seed = *seed;
             return std::nullopt;
         },
         [](const StudySpec& study) -> std::optional<std::string> {
             if (study.per_polygon()) return std::nullopt;
             return std::to_string(study.seed);
         }},
        {"until", "greater than 0, less than 0.5",
         "Standard error of the probabilities, anywhere on the map, below which no more members are run.",
         [](StudySpec& study, const std::string& text, const std::string&) -> std::optional<ValueProblem> {
             const auto error = number_from_text(text);
             if (!error) return ValueProblem{"is not a number", ""};
             if (!(*error > 0 && *error < 0.5)) return ValueProblem{"is out of range", ""};
             study.until = *error;
             return std::nullopt;
         },
         [](const StudySpec& study) -> std::optional<std::string> {
             if (!study.until) return std::nullopt;
             return shortest_text(*study.until);
         }},
        {"levels", "2 to 6",
         "Cell sizes, each twice the next, of a multilevel study: many members on coarse cells, few on the scene's "
         "own. "
         "All together cost as much as `samples` on the scene's own.",
         [](StudySpec& study, const std::string& text, const std::string&) -> std::optional<ValueProblem> {
             const auto levels = integer_from_text(text);
             if (!levels) return ValueProblem{"is not a whole number", ""};
             if (*levels < 2 || *levels > 6) return ValueProblem{"is out of range", ""};
             study.levels = static_cast<std::size_t>(*levels);
             return std::nullopt;
         },
         [](const StudySpec& study) -> std::optional<std::string> {
             if (!study.levels) return std::nullopt;
             return std::to_string(*study.levels);
         }},
        {"keep", "none, failed, all", "Members whose scene and maps are written to members/.",
         [](StudySpec& study, const std::string& text, const std::string&) -> std::optional<ValueProblem> {
             if (text != "none" && text != "failed" && text != "all")
                 return ValueProblem{"is not one of the choices", ""};
             study.keep = text == "none" ? Keep::none : text == "all" ? Keep::all : Keep::failed;
             return std::nullopt;
         },
         [](const StudySpec& study) -> std::optional<std::string> {
             return study.keep == Keep::none ? "none" : study.keep == Keep::all ? "all" : "failed";
         }}};
    return k_keys;
}

/// Reads the entries of one study file.
class StudyReader {
  public:
    StudyReader(StudyReading& reading, std::string folder)
        : reading_(reading), folder_(std::move(folder)), parameters_(scene_parameters()) {}

    void add(const IniEntry& entry);
    void check() const;

  private:
    void add_study_key(const std::string& key, const IniEntry& entry);
    void add_setting(const std::string& key, const IniEntry& entry);
    void add_variation(const std::string& key, const IniEntry& entry);
    [[nodiscard]] const Parameter* known_key(const std::string& name, const IniEntry& entry);
    void add_correlation(const std::string& keys, const IniEntry& entry);
    void check_per_polygon() const;
    void check_sampling() const;
    [[nodiscard]] const Variation* variation_of(const std::string& key) const;
    void refuse(const std::string& what, const IniEntry& entry, const std::string& limit, const std::string& remedy) {
        reading_.problems.add({what, reading_.where(entry.name), entry.value, limit, remedy});
    }

    StudyReading& reading_;
    std::string folder_;
    const std::vector<Parameter>& parameters_;
    std::set<std::string> seen_;
};

void StudyReader::add(const IniEntry& entry) {
    if (!seen_.insert(entry.name).second) {
        refuse("is given more than once", entry, "", "Keep one of the lines");
        return;
    }
    if (entry.value.empty()) {
        refuse("has no value", entry, "", "Give one or remove the key");
        return;
    }
    const auto dot = entry.name.find('.');
    const std::string section = entry.name.substr(0, dot),
                      rest = dot == std::string::npos ? "" : entry.name.substr(dot + 1);
    if (section == "study" && !rest.empty()) return add_study_key(rest, entry);
    if (section == "set" && !rest.empty()) return add_setting(rest, entry);
    if (section == "vary" && !rest.empty()) return add_variation(rest, entry);
    if (section == "correlate" && !rest.empty()) return add_correlation(rest, entry);
    refuse("unknown key", entry, "",
           "An ensemble has the sections [study], [set], [vary] and [correlate]; a calibration, for `frana calibrate`, "
           "also [objective] and [event NAME]");
}

void StudyReader::add_study_key(const std::string& key, const IniEntry& entry) {
    std::vector<std::string> names;
    for (const StudyKey& one : study_keys()) {
        names.push_back(std::string("study.") + one.name);
        if (key != one.name) continue;
        if (const auto refusal = one.read(reading_.study, entry.value, folder_))
            refuse(refusal->what, entry, one.limits, refusal->remedy);
        return;
    }
    const std::string nearest = nearest_name(entry.name, names);
    refuse("unknown key", entry, "",
           nearest.empty() ? "Known are " + joined(names, ", ") : "Did you mean " + nearest + "?");
}

const Parameter* StudyReader::known_key(const std::string& name, const IniEntry& entry) {
    const Parameter* const parameter = find_parameter(parameters_, name);
    if (parameter != nullptr) return parameter;
    const std::string nearest = nearest_name(name, names_of(parameters_));
    refuse("unknown key of the scene", entry, "",
           nearest.empty() ? "`frana params` lists all keys" : "Did you mean " + nearest + "?");
    return nullptr;
}

void StudyReader::add_setting(const std::string& key, const IniEntry& entry) {
    const std::string name = present_name(key);
    const Parameter* const parameter = known_key(name, entry);
    if (parameter == nullptr) return;
    SceneSpec scene;
    if (const auto refusal = parameter->read(scene, entry.value))
        refuse(refusal->what, entry, parameter->limits, refusal->remedy);
    else
        reading_.study.set.push_back(name + "=" + with_absolute_paths(*parameter, entry.value, folder_));
}

void StudyReader::add_variation(const std::string& key, const IniEntry& entry) {
    const std::string name = present_name(key);
    const Parameter* const parameter = known_key(name, entry);
    if (parameter == nullptr) return;
    if (const auto refusal = refusal_to_vary(*parameter)) {
        refuse(refusal->what, entry, "", refusal->remedy);
        return;
    }
    auto read = distribution_from_text(entry.value);
    if (const auto* refusal = std::get_if<ValueProblem>(&read)) {
        refuse(refusal->what, entry, k_distributions, refusal->remedy);
        return;
    }
    auto& distribution = std::get<Distribution>(read);
    if (const auto refusal = refusal_of(*parameter, distribution)) {
        refuse(refusal->what, entry, parameter->limits, refusal->remedy);
        return;
    }
    for (std::string& value : distribution.values) value = with_absolute_paths(*parameter, value, folder_);
    reading_.study.vary.push_back({name, std::move(distribution)});
}

void StudyReader::add_correlation(const std::string& keys, const IniEntry& entry) {
    const std::vector<std::string> words = words_of(keys);
    const auto rho = number_from_text(entry.value);
    if (words.size() != 2 || words[0] == words[1])
        return refuse("is not a pair of varied keys", entry, "", "Write material.turbulence release.volume = 0.3");
    if (!rho || !(*rho > -1 && *rho < 1))
        return refuse("is not a rank correlation", entry, "greater than -1, less than 1", "");
    const Correlation one{present_name(words[0]), present_name(words[1]), *rho};
    auto& all = reading_.study.correlate;
    if (std::any_of(all.begin(), all.end(), [&](const auto& other) { return one.is_of_the_keys_of(other); }))
        return refuse("is given more than once, in either order", entry, "", "Keep one of the lines");
    all.push_back(one);
}

const Variation* StudyReader::variation_of(const std::string& key) const {
    const auto& all = reading_.study.vary;
    const auto found = std::find_if(all.begin(), all.end(), [&](const Variation& one) { return one.key == key; });
    return found == all.end() ? nullptr : &*found;
}

void StudyReader::check() const {
    const StudySpec& study = reading_.study;
    Problems& problems = reading_.problems;
    if (study.scene.empty())
        problems.add(
            {"is missing", reading_.where("study.scene"), "", "a scene file", "Name the scene whose keys vary"});
    for (const Variation& one : study.vary)
        if (seen_.count("set." + one.key) > 0)
            problems.add({"is also set for all members", reading_.where("vary." + one.key), "", "",
                          "Keep it in one of [set] and [vary]"});
    const bool by_table = study.sampling == Sampling::table;
    const bool has_vary =
        std::any_of(seen_.begin(), seen_.end(), [](const std::string& name) { return name.starts_with("vary."); });
    if (by_table && (has_vary || !study.correlate.empty()))
        problems.add({"gives all values: [vary] and [correlate] have no effect", reading_.where("study.sampling"), "",
                      "", "Remove the sections, or choose another sampling"});
    if (study.per_polygon()) return check_per_polygon();
    if (!by_table && !has_vary)
        problems.add({"has no key", reading_.where("vary"), "", "", "Give at least one key a distribution"});
    if (variation_of("material.friction-angle") != nullptr && variation_of("material.friction-coefficient") != nullptr)
        problems.add({"contradicts vary.material.friction-coefficient: both give the bed friction",
                      reading_.where("vary.material.friction-angle"), "", "", "Keep one of the two"});
    for (const Correlation& one : study.correlate) {
        for (const std::string& key : {one.first, one.second}) {
            const Variation* const varied = variation_of(key);
            const std::string where = reading_.where("correlate." + one.first + " " + one.second);
            const bool tried = seen_.count("vary." + key) > 0;  // its problem is told already
            if (varied == nullptr && !tried) problems.add({key + " does not vary", where, "", "", "Add it to [vary]"});
            if (varied != nullptr && varied->distribution.is_nominal())
                problems.add({key + " has values without an order, which cannot be correlated", where, "", "",
                              "Remove the line"});
        }
    }
    check_sampling();
}

void StudyReader::check_per_polygon() const {
    for (const std::string& name : seen_) {
        const bool of_sampling = name.starts_with("vary.") || name.starts_with("correlate.") ||
                                 name == "study.samples" || name == "study.sampling" || name == "study.seed" ||
                                 name == "study.until" || name == "study.levels";
        if (of_sampling)
            reading_.problems.add({"has no effect with study.per-polygon = on: each polygon is one member",
                                   reading_.where(name), "", "", "Remove it, or per-polygon"});
    }
}

void StudyReader::check_sampling() const {
    const StudySpec& study = reading_.study;
    Problems& problems = reading_.problems;
    const std::string where = reading_.where("study.sampling"), name = name_of(study.sampling);
    const bool even = study.sampling == Sampling::grid || study.sampling == Sampling::saltelli;
    if (even && !study.correlate.empty())
        problems.add({"needs independent keys", where, name, "", "Remove [correlate], or choose another sampling"});
    if (study.until && (even || study.sampling == Sampling::table))
        problems.add({"cannot be stopped before its last member by study.until", where, name, "",
                      "Remove study.until, or choose sobol, latin-hypercube or random"});
    if (study.sampling == Sampling::saltelli && !study.vary.empty()) {
        const auto group = static_cast<std::int64_t>(study.vary.size()) + 2;
        if (study.samples % group != 0 || study.samples / group < 2)
            problems.add({"is not a multiple of the keys plus 2, which sampling = saltelli needs",
                          reading_.where("study.samples"), std::to_string(study.samples), "",
                          "Write " + std::to_string(std::max<std::int64_t>(2, study.samples / group) * group)});
    }
    if (study.levels && study.sampling != Sampling::random && study.sampling != Sampling::sobol)
        problems.add({"cannot go on drawing members, which study.levels needs", where, name, "",
                      "Remove study.levels, or choose sobol or random"});
    if (study.sampling == Sampling::grid && seen_.count("vary.terrain.error") > 0)
        problems.add({"cannot draw fields of error", where, name, "", "Choose another sampling"});
}

}  // namespace

std::string name_of(Sampling sampling) {
    for (const NamedSampling& one : k_samplings)
        if (one.sampling == sampling) return one.name;
    return sampling == Sampling::polygons ? "per-polygon" : "table";
}

bool is_study(const std::string& path) {
    const std::vector<IniEntry> entries = read_ini(path);
    return std::any_of(entries.begin(), entries.end(),
                       [](const IniEntry& entry) { return entry.name.starts_with("study."); });
}

StudyReading read_study(const std::string& path) {
    return read_study_entries(read_ini(path), path);
}

StudyReading read_study_entries(const std::vector<IniEntry>& entries, const std::string& label) {
    StudyReading reading;
    reading.label = label;
    const fs::path absolute = fs::absolute(label).lexically_normal();
    reading.study.file = absolute.string();
    StudyReader reader(reading, absolute.parent_path().string());
    for (const IniEntry& entry : entries) reader.add(entry);
    reader.check();
    return reading;
}

std::string study_text(const StudySpec& study) {
    std::string text = "# A study as used; `frana ensemble` on this file repeats it.\n\n[study]\n";
    for (const StudyKey& key : study_keys()) {
        const auto value = key.write(study);
        text += std::string("# ") + key.meaning + " Values: " + key.limits + ".\n";
        text += value ? std::string(key.name) + " = " + *value + "\n" : std::string("# ") + key.name + " =\n";
    }
    text += settings_text("set", study.set) + variations_text("vary", study.vary);
    if (!study.correlate.empty()) text += "\n[correlate]\n";
    for (const Correlation& one : study.correlate)
        text += one.first + " " + one.second + " = " + shortest_text(one.rho) + "\n";
    return text;
}

}  // namespace frana::study
