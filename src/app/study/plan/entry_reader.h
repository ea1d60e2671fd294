// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "app/study/study_spec.h"
#include "core/error.h"
#include "params/grammar/ini_file.h"
#include "params/keys/parameter.h"

namespace frana::app::study {

/// What the readers of studies, regions and calibrations share: each key once and with a value, keys of a table within
/// their limits, keys of the scene; problems are named by file and key.
class EntryReader {
  public:
    EntryReader(const EntryReader&) = delete;
    EntryReader& operator=(const EntryReader&) = delete;

  protected:
    /// @param label the file as the user named it  @param folder of its relative paths
    EntryReader(std::string label, std::string folder, Problems& problems)
        : label_(std::move(label)), folder_(std::move(folder)), problems_(problems) {}
    ~EntryReader() = default;

    /// Whether an entry has a value and is the first of its name.
    bool is_good(const IniEntry& entry);
    /// Stores the value of a key; its paths become absolute. Returns false if the table does not have the key.
    template <class Spec>
    bool read(const std::vector<ParameterOf<Spec>>& table, const IniEntry& entry, Spec& spec) {
        const ParameterOf<Spec>* const key = find_parameter(table, entry.name);
        if (key == nullptr) return false;
        if (const auto refusal = key->read(spec, entry.value))
            refuse(refusal->what, entry, key->limits, refusal->remedy);
        else if (key->map_files)
            key->map_files(spec, [&](const std::string& path) { return absolute_path(path, folder_); });
        return true;
    }
    /// Returns a key of the scene; null: there is none, which was refused.
    const Parameter* scene_key(const std::string& name, const IniEntry& entry);
    /// Refuses a name with the nearest of those known; without one, with another remedy.
    void refuse_name(const std::string& what, const std::string& name, const std::vector<std::string>& known,
                     const std::string& otherwise, const IniEntry& entry, const std::string& limit = {});
    void refuse(const std::string& what, const IniEntry& entry, const std::string& limit, const std::string& remedy) {
        add_problem({what, where(entry.name), entry.value, limit, remedy});
    }
    void add_problem(const Problem& problem) { problems_.add(problem); }
    [[nodiscard]] Place where(const std::string& name) const { return {label_, name}; }
    [[nodiscard]] const std::string& folder() const noexcept { return folder_; }
    /// Names of the entries so far, right or wrong.
    [[nodiscard]] const std::set<std::string>& seen() const noexcept { return seen_; }
    [[nodiscard]] bool has_seen(const std::string& name) const { return seen_.count(name) > 0; }
    [[nodiscard]] bool has_seen_any(const std::string& beginning) const;

  private:
    std::string label_, folder_;
    Problems& problems_;
    std::set<std::string> seen_;
};

/// The keys of [study], and of [region]; the parser, the messages and the echo follow from them.
const std::vector<ParameterOf<StudySpec>>& study_keys();
const std::vector<ParameterOf<StudySpec>>& region_keys();
/// Returns a key of [study] for another section, perhaps with another meaning.
ParameterOf<StudySpec> study_key(const std::string& key, const std::string& section, const std::string& meaning = {});

/// Whether an INI has a section that begins so. Throws Error(input) as read_ini.
bool has_section(const std::string& path, const std::string& beginning);

/// The words of the samplings for which a condition holds.
template <class Condition>
std::vector<std::string> sampling_words(const Condition& holds) {
    std::vector<std::string> words;
    for (const SamplingMethod& row : k_samplings)
        if (holds(row)) words.emplace_back(row.name);
    return words;
}

/// Returns the keys of a table as lines of a file, each after its meaning and its limits; without a value commented
/// out.
template <class Spec>
std::string keys_text(const std::vector<ParameterOf<Spec>>& table, const Spec& spec, const std::string& section) {
    std::string text;
    for (const ParameterOf<Spec>& key : table) {
        if (key.section != section) continue;
        const auto value = key.write(spec);
        text += "# " + key.meaning + (key.limits.empty() ? "" : " Values: " + key.limits + ".") + "\n" +
                (value ? "" : "# ") + key.key + " =" + (value ? " " + *value : "") + "\n";
    }
    return text;
}

}  // namespace frana::app::study
