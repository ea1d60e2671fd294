// SPDX-License-Identifier: Apache-2.0
#include "app/study/plan/read_study.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "app/study/plan/entry_reader.h"
#include "app/study/plan/sampling.h"
#include "app/text/number_text.h"
#include "core/text.h"
#include "params/grammar/ini_file.h"
#include "params/grammar/value_text.h"
#include "params/keys/declare.h"
#include "params/keys/parameter.h"
#include "params/keys/scene_parameters.h"

namespace frana::app::study {
namespace {

namespace fs = std::filesystem;

using StudyKey = ParameterOf<StudySpec>;

constexpr std::int64_t k_last_seed = 2'147'483'647;
constexpr const char* k_table_word = "table:";

/// Samplings and keys of earlier versions, and what to use.
constexpr std::pair<const char*, const char*> k_gone_samplings[] = {
    {"latin-hypercube", "Write sampling = sobol: it is at least as certain with as many runs"},
    {"grid", "Write sampling = sobol, or table:FILE.csv with the combinations as rows"},
    {"saltelli", "Write sampling = sobol: its sensitivities need 64 runs, not thousands"}};
constexpr std::pair<const char*, const char*> k_gone_keys[] = {
    {"study.levels", "Remove it: sampling = sobol is as certain at the same cost"},
    {"study.per-polygon", "Write a region, whose polygons each fail alone, and run it with `frana batch`"}};

StudyKey sampling_key() {
    declare::Words<Sampling> words;
    for (const SamplingMethod& row : k_samplings)
        if (row.kind != SamplingMethod::Kind::given) words.emplace_back(row.name, row.sampling);
    auto key = declare::option<StudySpec>("study.sampling", FRANA_MEMBER(sampling), words,
                                          "How the values of the members are drawn.");
    key.limits += std::string(", ") + k_table_word + "FILE.csv";
    key.read = [of_word = key.read](StudySpec& study, const std::string& text) -> std::optional<ValueProblem> {
        for (const auto& [gone, instead] : k_gone_samplings)
            if (text == gone) return ValueProblem{"is no longer a sampling", instead};
        if (!text.starts_with(k_table_word)) return of_word(study, text);
        const std::string file = trimmed(text.substr(std::string(k_table_word).size()));
        if (file.empty()) return ValueProblem{"names no file", "Write table:FILE.csv"};
        study.sampling = Sampling::table;
        study.table = file;
        return std::nullopt;
    };
    key.write = [of_word = key.write](const StudySpec& study) -> std::optional<std::string> {
        return study.sampling == Sampling::table ? k_table_word + study.table : of_word(study);
    };
    key.map_files = [](StudySpec& study, const FileMap& map) {
        if (!study.table.empty()) study.table = map(study.table);
    };
    return key;
}

}  // namespace

const std::vector<StudyKey>& study_keys() {
    using namespace declare;
    static const std::vector<StudyKey> k_keys = [] {
        StudyKey scene_file = text<StudySpec>("study.scene", FRANA_MEMBER(scene), "file", "The scene whose keys vary.");
        scene_file.limits = "a scene file";
        StudyKey samples = integer<StudySpec>("study.samples", FRANA_MEMBER(samples), 2, k_most_samples,
                                              "Number of members; with until the most.");
        samples.write = [write = samples.write](const StudySpec& study) {
            return study.sampling == Sampling::table ? std::nullopt : write(study);
        };
        return std::vector<StudyKey>{
            scene_file,
            option<StudySpec>(
                "study.scheme", FRANA_MEMBER(scheme),
                declare::Words<Scheme>{{"default", Scheme::standard}, {"finite-volume", Scheme::finite_volume}},
                "Numerical scheme of all members; without it that of the scene. Two members are computed "
                "again by the other one."),
            samples,
            sampling_key(),
            integer<StudySpec>("study.seed", FRANA_MEMBER(seed), 0, k_last_seed,
                               "The same seed gives the same members."),
            text<StudySpec>("study.rare-place", FRANA_MEMBER(rare_place), "text",
                            "A gauge of the scene (output.gauges): with sampling = importance most members are drawn "
                            "near what makes the flow come there."),
            number<StudySpec>("study.until", FRANA_MEMBER(until), "", Range{0, 0.5, true, true},
                              "Standard error of the probabilities, anywhere on the map, below which no more members "
                              "are run."),
            option<StudySpec>("study.keep", FRANA_MEMBER(keep),
                              declare::Words<Keep>{{name_of(Keep::none), Keep::none},
                                                   {name_of(Keep::failed), Keep::failed},
                                                   {name_of(Keep::all), Keep::all}},
                              "Members whose scene and maps are written to members/.")};
    }();
    return k_keys;
}

StudyKey study_key(const std::string& key, const std::string& section, const std::string& meaning) {
    StudyKey copy = *find_parameter(study_keys(), "study." + key);
    copy.section = section;
    if (!meaning.empty()) copy.meaning = meaning;
    return copy;
}

namespace {

/// Reads the entries of one study or region.
class StudyReader : private EntryReader {
  public:
    StudyReader(StudyReading& reading, std::string folder)
        : EntryReader(reading.label, std::move(folder), reading.problems), reading_(reading) {}

    void add(const IniEntry& entry);
    void check();

  private:
    void add_setting(const std::string& key, const IniEntry& entry);
    void add_variation(const std::string& key, const IniEntry& entry);
    void add_correlation(const std::string& keys, const IniEntry& entry);
    void add_column(const std::string& key, const IniEntry& entry);
    void check_columns();
    void check_sampling();
    void check_option(const Variation& vary, std::size_t option, double first_round);
    [[nodiscard]] const Variation* variation_of(const std::string& key) const;
    [[nodiscard]] bool is_region() const { return reading_.study.region.has_value(); }

    StudyReading& reading_;
};

void StudyReader::add(const IniEntry& entry) {
    if (!is_good(entry)) return;
    const auto dot = entry.name.find('.');
    const std::string section = entry.name.substr(0, dot),
                      rest = dot == std::string::npos ? "" : entry.name.substr(dot + 1);
    const auto is = [&](const char* name, bool of_region) {
        return section == name && !rest.empty() && is_region() == of_region;
    };
    const std::vector<StudyKey>& keys = is_region() ? region_keys() : study_keys();
    if (read(keys, entry, reading_.study)) return;
    if (section == "set" && !rest.empty()) return add_setting(rest, entry);
    if (is("columns", true)) return add_column(rest, entry);
    if (is("vary", false)) return add_variation(rest, entry);
    for (const auto& [gone, instead] : k_gone_keys)
        if (entry.name == gone) return refuse("is no longer a key", entry, "", instead);
    if (is("degree", true))
        return refuse("is no longer a key of a region", entry, "",
                      "Write [degree] into a hazard scheme of your own (share/doc/hazard.md), and name that file in "
                      "hazard.scheme");
    if (is("correlate", false)) return add_correlation(rest, entry);
    const std::string all = joined(names_of(keys), ", ");
    if (is_region() || is("study", false))
        refuse_name(
            "unknown key", entry.name, names_of(keys),
            is_region() ? "A region has the sections [region], [set] and [columns], with " + all : "Known are " + all,
            entry);
    else
        refuse("unknown key", entry, "",
               "An ensemble has the sections [study], [set], [vary] and [correlate]; a calibration, for `frana "
               "calibrate`, also [objective] and [event NAME]");
}

void StudyReader::add_column(const std::string& key, const IniEntry& entry) {
    const std::string name = present_name(key);
    const Parameter* const parameter = scene_key(name, entry);
    if (parameter == nullptr) return;
    if (name.starts_with("release.perimeter"))
        refuse("cannot differ from slope to slope", entry, "", "Each slope has one polygon of the perimeter");
    else if (const auto refusal = refusal_to_vary(*parameter))
        refuse(refusal->what, entry, "", refusal->remedy);
    else
        reading_.study.region->columns.push_back({name, entry.value});
}

void StudyReader::add_setting(const std::string& key, const IniEntry& entry) {
    const std::string name = present_name(key);
    const Parameter* const parameter = scene_key(name, entry);
    if (parameter == nullptr) return;
    SceneSpec scene;
    if (const auto refusal = parameter->read(scene, entry.value))
        refuse(refusal->what, entry, parameter->limits, refusal->remedy);
    else
        reading_.study.set.push_back(name + "=" + with_absolute_paths(*parameter, entry.value, folder()));
}

void StudyReader::add_variation(const std::string& key, const IniEntry& entry) {
    const std::string name = present_name(key);
    const Parameter* const parameter = scene_key(name, entry);
    if (parameter == nullptr) return;
    if (const auto refusal = refusal_to_vary(*parameter)) return refuse(refusal->what, entry, "", refusal->remedy);
    auto read = distribution_from_text(entry.value);
    if (const auto* refusal = std::get_if<ValueProblem>(&read))
        return refuse(refusal->what, entry, k_distributions, refusal->remedy);
    auto& distribution = std::get<Distribution>(read);
    if (const auto refusal = refusal_of(*parameter, distribution))
        return refuse(refusal->what, entry, parameter->limits, refusal->remedy);
    for (std::string& value : distribution.values) value = with_absolute_paths(*parameter, value, folder());
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

void StudyReader::check() {
    const StudySpec& study = reading_.study;
    if (study.scene.empty())
        add_problem({"is missing", where(is_region() ? "region.scene" : "study.scene"), "", "a scene file",
                     "Name the scene whose keys vary"});
    for (const char* section : {"set.", "vary.", "columns."})
        if (const std::string scheme = section + std::string("numerics.scheme"); study.scheme && has_seen(scheme))
            add_problem({"is also given by scheme", where(scheme), "", "", "Keep one of them"});
    for (const Variation& one : study.vary)
        if (has_seen("set." + one.key))
            add_problem({"is also set for all members", where("vary." + one.key), "", "",
                         "Keep it in one of [set] and [vary]"});
    const bool by_table = study.sampling == Sampling::table;
    const bool has_vary = has_seen_any("vary.");
    if (by_table && (has_vary || !study.correlate.empty()))
        add_problem({"gives all values: [vary] and [correlate] have no effect", where("study.sampling"), "", "",
                     "Remove the sections, or choose another sampling"});
    if (is_region()) return check_columns();
    if (!by_table && !has_vary)
        add_problem({"has no key", where("vary"), "", "", "Give at least one key a distribution"});
    if (variation_of("material.friction-angle") != nullptr && variation_of("material.friction-coefficient") != nullptr)
        add_problem({"contradicts vary.material.friction-coefficient: both give the bed friction",
                     where("vary.material.friction-angle"), "", "", "Keep one of the two"});
    for (const Correlation& one : study.correlate) {
        for (const std::string& key : {one.first, one.second}) {
            const Variation* const varied = variation_of(key);
            const std::string place = where("correlate." + one.first + " " + one.second);
            const bool tried = has_seen("vary." + key);  // its problem is told already
            if (varied == nullptr && !tried) add_problem({key + " does not vary", place, "", "", "Add it to [vary]"});
            if (varied != nullptr && varied->distribution.is_nominal())
                add_problem({key + " has values without an order, which cannot be correlated", place, "", "",
                             "Remove the line"});
        }
    }
    check_sampling();
}

void StudyReader::check_columns() {
    for (const RegionSpec::Column& one : reading_.study.region->columns)
        for (const std::string& set : reading_.study.set)
            if (set.starts_with(one.key + "="))
                add_problem({"is also set for all slopes", where("columns." + one.key), "", "",
                             "Keep it in one of [set] and [columns]"});
}

void StudyReader::check_option(const Variation& vary, std::size_t option, double first_round) {
    const double share = vary.distribution.weights[option];
    if (share * first_round >= k_least_tries_of_option) return;
    const double needed = std::ceil(k_least_tries_of_option / share / k_round_ends[0]);
    add_problem(
        {"has an option that the first round of sampling = importance may not try, and then nobody learns "
         "whether it leads to the rare place",
         where("vary." + vary.key), vary.distribution.values[option] + ": " + number_text(share, 2),
         "at least " + number_text(k_least_tries_of_option / first_round, 2),
         needed > static_cast<double>(k_most_samples) ? "Make it likelier, or run each option as a study of its own"
                                                      : "Write study.samples = " + shortest_text(needed) +
                                                            " or more, or run each option as a study of its own"});
}

void StudyReader::check_sampling() {
    using Kind = SamplingMethod::Kind;
    const StudySpec& study = reading_.study;
    const SamplingMethod& method = method_of(study.sampling);
    const auto refuse_for = [&](const std::string& what, const std::string& remedy) {
        add_problem({what, where("study.sampling"), method.name, "", remedy});
    };
    if (method.kind == Kind::design && !study.correlate.empty())
        refuse_for("needs independent keys", "Remove [correlate], or choose another sampling");
    if (study.until && method.kind != Kind::sample)
        refuse_for("cannot be stopped before its last member by study.until",
                   "Remove study.until, or choose sobol or random");
    if (method.more_in_group > 0 && !study.vary.empty()) {
        const auto group = static_cast<std::int64_t>(study.group_size());
        if (study.samples % group != 0 || study.samples / group < 2)
            add_problem({"is not a multiple of the keys plus " + std::to_string(method.more_in_group) +
                             ", which sampling = " + method.name + " needs",
                         where("study.samples"), std::to_string(study.samples), "",
                         "Write " + std::to_string(std::max<std::int64_t>(2, study.samples / group) * group)});
    }
    const bool in_rounds = study.sampling == Sampling::importance;
    if (in_rounds && !study.rare_place)
        refuse_for("needs a place that is seldom reached",
                   "Add study.rare-place = the name of a gauge of output.gauges, or choose another sampling");
    if (!in_rounds && study.rare_place)
        add_problem({"has no effect with sampling = " + std::string(method.name), where("study.rare-place"),
                     *study.rare_place, "", "Remove it, or write sampling = importance"});
    if (in_rounds && study.samples < k_least_in_rounds)
        add_problem({"are too few for the rounds of sampling = importance", where("study.samples"),
                     std::to_string(study.samples), "at least " + std::to_string(k_least_in_rounds),
                     "Write " + std::to_string(k_least_in_rounds) + " or more"});
    for (const Variation& one : study.vary)
        for (std::size_t i = 0; in_rounds && i < one.distribution.weights.size(); ++i)
            check_option(one, i, static_cast<double>(round_end(study, 0)));
}

}  // namespace

bool is_study(const std::string& path) {
    return has_section(path, "study.");
}

bool is_region(const std::string& path) {
    return has_section(path, "region.");
}

namespace {

/// What is known of a study before its entries are read.
StudyReading begun(const std::string& label) {
    StudyReading reading;
    reading.label = label;
    reading.study.file = fs::absolute(label).lexically_normal().string();
    return reading;
}

StudyReading read_entries(const std::vector<IniEntry>& entries, StudyReading reading) {
    StudyReader reader(reading, fs::path(reading.study.file).parent_path().string());
    for (const IniEntry& entry : entries) reader.add(entry);
    reader.check();
    return reading;
}

}  // namespace

StudyReading read_study(const std::string& path) {
    return read_study_entries(read_ini(path), path);
}

StudyReading read_study_entries(const std::vector<IniEntry>& entries, const std::string& label) {
    return read_entries(entries, begun(label));
}

StudyReading read_region(const std::string& path) {
    StudyReading reading = begun(path);
    reading.study.sampling = Sampling::polygons;
    reading.study.region.emplace();
    return read_entries(read_ini(path), std::move(reading));
}

// Paths in a study file: absolute where it is used, relative where it is echoed.

namespace {

std::string with_mapped_paths(const Parameter& parameter, const std::string& value, const FileMap& map) {
    SceneSpec scene;
    if (!parameter.map_files || parameter.read(scene, value)) return value;
    parameter.map_files(scene, map);
    return parameter.write(scene).value_or(value);
}

}  // namespace

std::string with_absolute_paths(const Parameter& parameter, const std::string& value, const std::string& folder) {
    return with_mapped_paths(parameter, value, [&](const std::string& path) { return absolute_path(path, folder); });
}

std::string with_files(const std::string& key, const std::string& value, const KeyedFileMap& map) {
    // A folder is where something is written, no input.
    static const std::vector<Parameter>& k_keys = scene_parameters();
    const Parameter* const parameter = find_parameter(k_keys, key);
    if (parameter == nullptr || !parameter->reads_files()) return value;
    return with_mapped_paths(*parameter, value, [&](const std::string& path) { return map(key, path); });
}

std::vector<std::string> with_files(std::vector<std::string> set, const KeyedFileMap& map) {
    for (std::string& one : set) {
        const auto equals = one.find('=');
        const std::string key = one.substr(0, equals);
        one = key + "=" + with_files(key, one.substr(equals + 1), map);
    }
    return set;
}

std::vector<Variation> with_files(std::vector<Variation> vary, const KeyedFileMap& map) {
    for (Variation& one : vary)
        for (std::string& value : one.distribution.values) value = with_files(one.key, value, map);
    return vary;
}

StudySpec with_files(StudySpec study, const KeyedFileMap& map) {
    for (const StudyKey& key : study_keys())
        if (key.map_files) key.map_files(study, [&](const std::string& path) { return map(key.name(), path); });
    study.set = with_files(std::move(study.set), map);
    study.vary = with_files(std::move(study.vary), map);
    return study;
}

StudySpec seen_from(StudySpec study, const std::string& folder) {
    return with_files(std::move(study),
                      [&](const std::string&, const std::string& path) { return relative_path(path, folder); });
}

// Sections of a study file as text.

namespace {

std::string quoted_if_needed(const std::string& value) {
    return value.find_first_of(",:\"") == std::string::npos ? value : '"' + value + '"';
}

std::string text_of(const Distribution& distribution) {
    if (distribution.law != Law::choice) return distribution.text;
    std::string text;
    for (std::size_t i = 0; i < distribution.values.size(); ++i)
        text += (i == 0 ? "choice(" : ", ") + quoted_if_needed(distribution.values[i]) + ": " +
                shortest_text(distribution.weights[i]);
    return text + ")";
}

}  // namespace

std::string settings_text(const std::string& section, const std::vector<std::string>& set) {
    std::string text = set.empty() ? "" : "\n[" + section + "]\n";
    for (const std::string& one : set)
        text += one.substr(0, one.find('=')) + " = " + one.substr(one.find('=') + 1) + "\n";
    return text;
}

std::string variations_text(const std::string& section, const std::vector<Variation>& vary) {
    std::string text = vary.empty() ? "" : "\n[" + section + "]\n";
    for (const Variation& one : vary) text += one.key + " = " + text_of(one.distribution) + "\n";
    return text;
}

std::string correlations_text(const StudySpec& study) {
    std::string text = study.correlate.empty() ? "" : "\n[correlate]\n";
    for (const Correlation& one : study.correlate)
        text += one.first + " " + one.second + " = " + shortest_text(one.rho) + "\n";
    return text;
}

std::string study_text(const StudySpec& study) {
    return "# A study as used; `frana ensemble` on this file repeats it.\n\n[study]\n" +
           keys_text(study_keys(), study, "study") + settings_text("set", study.set) +
           variations_text("vary", study.vary) + correlations_text(study);
}

}  // namespace frana::app::study
