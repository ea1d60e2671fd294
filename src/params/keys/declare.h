// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <limits>
#include <type_traits>
#include <utility>

#include "core/text.h"
#include "params/grammar/data_file.h"
#include "params/grammar/ini_file.h"
#include "params/grammar/value_text.h"
#include "params/keys/parameter.h"

// The kinds of parameter. Each function makes a parameter from a member, its limits and its meaning. `Member` is a
// callable that takes a `Spec` (const or not), a SceneSpec if nothing else is said, and returns a reference to the
// member. One without captures (FRANA_MEMBER) becomes function pointers, so that all members of a type share one reader
// and one writer of each kind.

namespace frana::declare {

using Range = NumberRange;

template <class T>
struct is_optional : std::false_type {};
template <class T>
struct is_optional<std::optional<T>> : std::true_type {};

/// Returns the member's value; none for an empty optional.
template <class Value>
auto given(const Value& value) {
    if constexpr (is_optional<Value>::value)
        return value;
    else
        return std::optional<Value>(value);
}

/// A member as function pointers, for a `Spec` that is const or not.
template <class Spec, class Value>
struct Access {
    Value& (*changed)(Spec&);
    const Value& (*read)(const Spec&);

    Value& operator()(Spec& spec) const { return changed(spec); }
    const Value& operator()(const Spec& spec) const { return read(spec); }
};

/// Returns a member as function pointers if it can be that.
template <class Spec, class Member>
auto plain(Member member) {
    using Value = std::remove_reference_t<decltype(member(std::declval<Spec&>()))>;
    if constexpr (std::is_convertible_v<Member, Value& (*)(Spec&)>) {
        return Access<Spec, Value>{member, member};
    } else {
        return member;
    }
}

/// Sets how a parameter is read, written and reset.
template <class Spec, class Member, class Read, class Write>
void set_access(ParameterOf<Spec>& result, Member member, Read from_text, Write to_text) {
    result.read = [member, from_text](Spec& spec, const std::string& text) { return from_text(member(spec), text); };
    result.write = [member, to_text](const Spec& spec) -> std::optional<std::string> {
        const auto value = given(member(spec));
        if (!value) return std::nullopt;
        return to_text(*value);
    };
    result.reset = [member](Spec& spec) {
        const Spec fresh;
        member(spec) = member(fresh);
    };
}

/// Common to all kinds; `from_text` returns a ValueProblem or stores the value, `to_text` formats the plain value.
template <class Spec = SceneSpec, class Member, class Read, class Write>
ParameterOf<Spec> parameter(const std::string& name, const std::string& type, Member member, Read from_text,
                            Write to_text) {
    ParameterOf<Spec> result;
    const auto dot = name.find('.');
    result.section = name.substr(0, dot);
    result.key = name.substr(dot + 1);
    result.type = type;
    set_access(result, plain<Spec>(member), from_text, to_text);
    return result;
}

inline auto number_reader(Range range) {
    return [range](auto& target, const std::string& text) -> std::optional<ValueProblem> {
        const auto value = number_from_text(text);
        if (!value) return ValueProblem{"is not a number", comma_remedy(text)};
        if (!range.has(*value)) return ValueProblem{"is out of range", ""};
        target = *value;
        return std::nullopt;
    };
}
template <class Spec = SceneSpec, class Member>
ParameterOf<Spec> number(const std::string& name, Member member, const std::string& unit, Range range,
                         const std::string& meaning, const std::string& absent = {}) {
    auto result = parameter<Spec>(name, "number", member, number_reader(range), shortest_text);
    result.unit = unit;
    result.limits = range.text();
    result.range = range;
    result.fits = [range](double value) { return range.has(value); };
    result.meaning = meaning;
    result.absent = absent;
    return result;
}

template <class Spec = SceneSpec, class Member>
ParameterOf<Spec> integer(const std::string& name, Member member, std::int64_t lowest, std::int64_t highest,
                          const std::string& meaning) {
    auto result = parameter<Spec>(
        name, "integer", member,
        [lowest, highest](auto& target, const std::string& text) -> std::optional<ValueProblem> {
            const auto value = integer_from_text(text);
            if (!value) return ValueProblem{"is not a whole number", ""};
            if (*value < lowest || *value > highest) return ValueProblem{"is out of range", ""};
            target = static_cast<typename decltype(given(target))::value_type>(*value);
            return std::nullopt;
        },
        [](auto value) { return std::to_string(value); });
    result.limits = std::to_string(lowest) + " to " + std::to_string(highest);
    result.range = Range{static_cast<double>(lowest), static_cast<double>(highest)};
    result.meaning = meaning;
    return result;
}

inline constexpr auto k_read_on_off = [](auto& target, const std::string& text) -> std::optional<ValueProblem> {
    const auto value = boolean_from_text(text);
    if (!value) return ValueProblem{"is not on or off", ""};
    target = *value;
    return std::nullopt;
};
template <class Spec = SceneSpec, class Member>
ParameterOf<Spec> on_off(const std::string& name, Member member, const std::string& meaning,
                         const std::string& absent = {}) {
    auto result = parameter<Spec>(
        name, "on | off", member, k_read_on_off, +[](bool value) { return std::string(value ? "on" : "off"); });
    result.limits = "on, off";
    result.choices = {"on", "off"};
    result.meaning = meaning;
    result.absent = absent;
    return result;
}

inline auto choice_reader(std::vector<std::string> choices) {
    return [choices = std::move(choices)](auto& target, const std::string& text) -> std::optional<ValueProblem> {
        if (std::find(choices.begin(), choices.end(), text) == choices.end())
            return ValueProblem{"is not one of the choices", ""};
        target = text;
        return std::nullopt;
    };
}
/// One of the words in `choices`.
template <class Spec = SceneSpec, class Member>
ParameterOf<Spec> choice(const std::string& name, Member member, const std::vector<std::string>& choices,
                         const std::string& meaning) {
    auto result = parameter<Spec>(
        name, "choice", member, choice_reader(choices), +[](const std::string& value) { return value; });
    result.limits = joined(choices, ", ");
    result.choices = choices;
    result.meaning = meaning;
    return result;
}

/// One of several words, each of which stands for a value of the member.
template <class Value>
using Words = std::vector<std::pair<std::string, Value>>;
template <class Value>
auto option_reader(const Words<Value>& words) {
    return [words](auto& target, const std::string& text) -> std::optional<ValueProblem> {
        for (const auto& [word, value] : words) {
            if (word != text) continue;
            target = value;
            return std::nullopt;
        }
        return ValueProblem{"is not one of the choices", ""};
    };
}
template <class Value>
auto option_writer(const Words<Value>& words) {
    return [words](const Value& value) {
        return std::find_if(words.begin(), words.end(), [&](const auto& pair) { return pair.second == value; })->first;
    };
}
template <class Spec = SceneSpec, class Member, class Value>
ParameterOf<Spec> option(const std::string& name, Member member, const Words<Value>& words,
                         const std::string& meaning) {
    auto result = parameter<Spec>(name, "choice", member, option_reader(words), option_writer(words));
    std::vector<std::string> choices;
    for (const auto& pair : words) choices.push_back(pair.first);
    result.limits = joined(choices, ", ");
    result.choices = choices;
    result.meaning = meaning;
    return result;
}
template <class Member, class Value, std::size_t n>
Parameter option(const std::string& name, Member member, const std::pair<const char*, Value> (&words)[n],
                 const std::string& meaning) {
    return option(name, member, Words<Value>(std::begin(words), std::end(words)), meaning);
}

/// A key whose default decides a number on the map.
inline Parameter decides_map(Parameter key) {
    key.decides_map = true;
    return key;
}

/// A file that contains a `content` of Parameter, by which other programs choose what they offer for it.
inline Parameter holds(const std::string& content, Parameter file) {
    file.content = content;
    return file;
}

inline constexpr auto k_read_text = [](auto& target, const std::string& text) -> std::optional<ValueProblem> {
    target = text;
    return std::nullopt;
};
template <class Spec = SceneSpec, class Member>
ParameterOf<Spec> text(const std::string& name, Member member, const std::string& type, const std::string& meaning,
                       const std::string& absent = {}) {
    auto result = parameter<Spec>(
        name, type, member, k_read_text, +[](const std::string& value) { return value; });
    result.meaning = meaning;
    result.absent = absent;
    if (type == "file" || type == "folder") {
        result.map_files = [read = result.read, write = result.write](Spec& spec, const FileMap& map) {
            const auto path = write(spec);
            const bool column = path && path->rfind("attribute:", 0) == 0;  // of the vector layer, which names the
                                                                            // files
            if (path && !path->empty() && !column) read(spec, map(*path));
        };
    }
    return result;
}

/// A number, attribute:NAME, raster:FILE or table:FILE, restricted to `kinds`.
template <class Spec = SceneSpec, class Member>
ParameterOf<Spec> source(const std::string& name, Member member, const std::string& unit, Range range,
                         const std::vector<SourceSpec::Kind>& kinds, const std::string& meaning,
                         const std::string& absent) {
    using Kind = SourceSpec::Kind;
    const auto allowed = [kinds](Kind kind) { return std::find(kinds.begin(), kinds.end(), kind) != kinds.end(); };
    std::vector<std::string> forms;
    if (allowed(Kind::number)) forms.push_back("a number");
    for (const auto& [kind, form] : {std::pair(Kind::attribute, "attribute:NAME"),
                                     std::pair(Kind::raster, "raster:FILE"), std::pair(Kind::table, "table:FILE")})
        if (allowed(kind)) forms.emplace_back(form);
    auto result = parameter<Spec>(
        name, "text", member,
        [range, allowed](auto& target, const std::string& text) -> std::optional<ValueProblem> {
            const auto value = source_from_text(text);
            if (!value || !allowed(value->kind)) return ValueProblem{"is not understood", comma_remedy(text)};
            if (value->kind == Kind::number && !range.has(value->number)) return ValueProblem{"is out of range", ""};
            target = *value;
            return std::nullopt;
        },
        [](const SourceSpec& value) { return text_of(value); });
    result.unit = unit;
    result.limits = joined(forms, ", ") + "; values " + range.text();
    if (allowed(Kind::number)) result.range = range;
    result.fits = [range](double value) { return range.has(value); };
    result.meaning = meaning;
    result.absent = absent;
    if (allowed(Kind::raster) || allowed(Kind::table)) {
        result.map_files = [member](Spec& spec, const FileMap& map) {
            auto& target = member(spec);
            if (target && (target->kind == Kind::raster || target->kind == Kind::table))
                target->name = map(target->name);
        };
    }
    return result;
}

/// A list of words from a fixed set; a word in `alone` must be the only one.
template <class Spec = SceneSpec, class Member>
ParameterOf<Spec> word_list(const std::string& name, Member member, const std::vector<std::string>& alone,
                            const std::vector<std::string>& words, const std::string& meaning) {
    auto result = parameter<Spec>(
        name, "list", member,
        [=](std::vector<std::string>& target, const std::string& value) -> std::optional<ValueProblem> {
            const auto is_in = [](const std::vector<std::string>& list, const std::string& word) {
                return std::find(list.begin(), list.end(), word) != list.end();
            };
            const std::vector<std::string> given = words_of(value);
            if (given.empty()) return ValueProblem{"is an empty list", ""};
            for (const std::string& word : given) {
                if (is_in(alone, word) && given.size() > 1)
                    return ValueProblem{"'" + word + "' cannot be combined with others", ""};
                if (!is_in(alone, word) && !is_in(words, word)) return ValueProblem{"'" + word + "' is not known", ""};
            }
            target = given;
            return std::nullopt;
        },
        [](const std::vector<std::string>& value) { return joined(value, ", "); });
    std::vector<std::string> all = alone;
    all.insert(all.end(), words.begin(), words.end());
    result.limits = joined(all, ", ");
    result.choices = all;
    result.meaning = meaning;
    return result;
}

/// Refuses words that earlier versions took, each with what to do instead.
template <class Spec>
ParameterOf<Spec> without(ParameterOf<Spec> list, std::vector<std::pair<std::string, std::string>> gone) {
    list.read = [of_words = list.read, gone](Spec& spec, const std::string& value) -> std::optional<ValueProblem> {
        for (const std::string& word : words_of(value))
            for (const auto& [old, instead] : gone)
                if (word == old) return ValueProblem{"'" + word + "' is no longer written", instead};
        return of_words(spec, value);
    };
    return list;
}

/// Positive numbers in strictly rising order, at most `most`; none by default.
template <class Member>
Parameter rising_numbers(const std::string& name, Member member, const std::string& unit, const std::string& meaning,
                         std::size_t most = std::numeric_limits<std::size_t>::max()) {
    Parameter result = parameter(
        name, "list", member,
        [most](std::vector<double>& target, const std::string& value) -> std::optional<ValueProblem> {
            std::vector<double> numbers;
            for (const std::string& word : words_of(value)) {
                const auto number = number_from_text(word);
                if (!number) return ValueProblem{"'" + word + "' is not a number", ""};
                if (!(*number > (numbers.empty() ? 0 : numbers.back())))
                    return ValueProblem{"does not rise from above 0", "Write for example 0.5 2"};
                numbers.push_back(*number);
            }
            if (numbers.size() > most) return ValueProblem{"has more numbers than there can be classes", ""};
            target = numbers;
            return std::nullopt;
        },
        [](const std::vector<double>& numbers) {
            std::vector<std::string> words;
            for (const double number : numbers) words.push_back(shortest_text(number));
            return joined(words, ", ");
        });
    result.unit = unit;
    result.limits = "rising numbers greater than 0";
    if (most < std::numeric_limits<std::size_t>::max()) result.limits += ", at most " + std::to_string(most);
    result.range = NumberRange{0, std::numeric_limits<double>::max(), true};
    result.meaning = meaning;
    result.absent = "none";
    return result;
}

/// A data file by its name in the share folder, or one of one's own, FILE.ini.
template <class Member>
Parameter data_file(const std::string& name, Member member, const std::string& limits, const std::string& meaning,
                    const std::string& absent) {
    Parameter result = text(name, member, "text", meaning, absent);
    result.limits = limits;
    result.map_files = [member](SceneSpec& scene, const FileMap& map) {
        if (auto& file = member(scene); file && is_own_file(*file)) file = map(*file);
    };
    return result;
}

}  // namespace frana::declare

// The member of a parameter, of a scene or other file that may or may not be const.
#define FRANA_MEMBER(path) ([](auto& scene) -> auto& { return scene.path; })
