// SPDX-License-Identifier: Apache-2.0
#include "params/keys/key_words.h"

#include "core/words/number_pattern.h"
#include "params/keys/laws.h"

namespace frana {
namespace {

const std::string k_required_with = "required with ";

/// The meaning without the laws that use the key.
std::string own_meaning(const Parameter& key) {
    const std::string laws = used_by(key.name());
    return key.meaning.ends_with(laws) ? key.meaning.substr(0, key.meaning.size() - laws.size()) : key.meaning;
}

/// "material.bed-friction = bingham or manning": keys and their values, with the conjunction between them.
std::string choices_in(std::string keys, const Words& words) {
    const std::string or_word = " or ";
    for (std::size_t at = 0; (at = keys.find(or_word, at)) != std::string::npos;) {
        const std::string shown = " " + words("or") + " ";
        keys.replace(at, or_word.size(), shown);
        at += shown.size();
    }
    return keys;
}

}  // namespace

std::string used_by(const std::string& key) {
    const std::vector<const Law*> readers = readers_of(key);
    return readers.empty() ? "" : " Used by " + selected_by(readers) + ".";
}

std::string meaning_in(const Parameter& key, const Words& words) {
    const std::string own = own_meaning(key);
    if (own == key.meaning) return words(own);
    return words(own) + " " + words("Used by {1}.", {choices_in(selected_by(readers_of(key.name())), words)});
}

std::string absent_in(const Parameter& key, const Words& words) {
    if (!key.absent.starts_with(k_required_with)) return NumberPattern(key.absent).in(words);
    const std::string what = key.absent.substr(k_required_with.size());
    return words("required with {1}", {what == "solids" ? words("solids") : choices_in(what, words)});
}

std::vector<std::string> rows_of(const Parameter& key) {
    std::vector<std::string> rows{own_meaning(key)};
    const std::string absent = NumberPattern(key.absent).text;
    const bool is_key = absent.find('.') != absent.npos && absent.find(' ') == absent.npos;  // another key's value
    const bool has_words = !absent.empty() && absent != "{1}" && absent != "off" && !is_key;
    if (has_words && !absent.starts_with(k_required_with)) rows.push_back(absent);
    return rows;
}

}  // namespace frana
