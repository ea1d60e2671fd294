// SPDX-License-Identifier: Apache-2.0
#include "app/study/plan/entry_reader.h"

#include <algorithm>

#include "params/grammar/value_text.h"
#include "params/keys/scene_parameters.h"
#include "params/scene/read_scene.h"

namespace frana::app::study {

bool EntryReader::is_good(const IniEntry& entry) {
    if (!seen_.insert(entry.name).second)
        refuse("is given more than once", entry, "", "Keep one of the lines");
    else if (entry.value.empty())
        refuse("has no value", entry, "", "Give one or remove the key");
    else
        return true;
    return false;
}

const Parameter* EntryReader::scene_key(const std::string& name, const IniEntry& entry) {
    const std::vector<Parameter>& keys = scene_parameters();
    const Parameter* const key = find_parameter(keys, name);
    if (key == nullptr) {
        Problem problem = unknown_key(keys, name, where(entry.name));
        problem.value = entry.value;
        add_problem(problem);
    }
    return key;
}

void EntryReader::refuse_name(const std::string& what, const std::string& name, const std::vector<std::string>& known,
                              const std::string& otherwise, const IniEntry& entry, const std::string& limit) {
    const std::string nearest = nearest_name(name, known);
    refuse(what, entry, limit, nearest.empty() ? otherwise : "Did you mean " + nearest + "?");
}

bool EntryReader::has_seen_any(const std::string& beginning) const {
    return std::any_of(seen_.begin(), seen_.end(),
                       [&](const std::string& name) { return name.starts_with(beginning); });
}

bool has_section(const std::string& path, const std::string& beginning) {
    const std::vector<IniEntry> entries = read_ini(path);
    return std::any_of(entries.begin(), entries.end(),
                       [&](const IniEntry& entry) { return entry.name.starts_with(beginning); });
}

}  // namespace frana::app::study
