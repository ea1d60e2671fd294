// SPDX-License-Identifier: Apache-2.0
// Sections of a study file as text.
#include "core/shortest_text.h"
#include "study/read_study.h"

namespace frana::study {
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

}  // namespace frana::study
