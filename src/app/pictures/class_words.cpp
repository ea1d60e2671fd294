// SPDX-License-Identifier: Apache-2.0
#include "app/pictures/class_words.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "params/grammar/value_text.h"

namespace frana::app {
namespace {

/// "depth > 1.5 m": the quantity before the sign or the first number.
std::string one_threshold(const std::string& english, const Words& words) {
    std::size_t end = std::string::npos;
    for (const char* sign : {" > ", " < ", " \u2264 ", " \u2265 "}) end = std::min(end, english.find(sign));
    if (end == std::string::npos) {
        const std::size_t digit = english.find_first_of("0123456789");
        if (digit == std::string::npos || digit == 0) return words(english);
        end = digit - 1;  // "depth 0.5 – 2 m"
    }
    return words(english.substr(0, end)) + words.number(english.substr(end));
}

/// "depth > 1 m and speed > 1 m/s"; one conjunction only. Alternatives are between semicolons.
std::string thresholds(const std::string& english, const Words& words) {
    const std::string next = "; ";
    if (const std::size_t place = english.find(next); place != std::string::npos)
        return thresholds(english.substr(0, place), words) + next +
               thresholds(english.substr(place + next.size()), words);
    for (const char* conjunction : {worded("and"), worded("or")}) {
        const std::string between = " " + std::string(conjunction) + " ";
        const std::size_t place = english.find(between);
        const bool has_number = english.find_first_of("0123456789") != std::string::npos;
        if (place == std::string::npos || !has_number) continue;
        return one_threshold(english.substr(0, place), words) + " " + words(conjunction) + " " +
               thresholds(english.substr(place + between.size()), words);
    }
    return one_threshold(english, words);
}

}  // namespace

std::string raster_title(const ResultRaster& row, const std::string& name, const Words& words) {
    if (!row.by_value) return words(row.title);
    const std::string place = "{1}";
    const std::string pattern = text_for(row, row.title, row.name + "_" + place);
    return words(pattern, {words.number(text_for(row, "{}", name))});
}

std::string class_label(const std::string& english, const Words& words) {
    const std::size_t colon = english.find(": ");
    if (colon == std::string::npos) return thresholds(english, words);
    return words.labelled(words(english.substr(0, colon)), thresholds(english.substr(colon + 2), words));
}

std::string scheme_title(const std::string& scheme, const Words& words) {
    constexpr std::pair<std::string_view, const char*> k_titles[] = {
        {"swiss-debris-flow", worded("Switzerland, debris flows")},
        {"swiss-flood", worded("Switzerland, floods")},
        {"austrian-torrent", worded("Austria, torrents")},
        {"custom", worded("own limits")}};
    for (const auto& [name, title] : k_titles)
        if (name == scheme) return words(title);
    return scheme;
}

std::string class_name(const std::string& label) {
    std::string name = label.substr(0, label.find(':'));
    const std::string space = "\u202F";  // before a French colon
    if (name.ends_with(space)) name.resize(name.size() - space.size());
    return name;
}

}  // namespace frana::app
