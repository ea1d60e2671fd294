// SPDX-License-Identifier: Apache-2.0
#include "core/words/words.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <regex>
#include <vector>

#include "core/error.h"

namespace frana {
namespace {

constexpr auto k_languages = std::to_array<LanguageRow>({
    {"en", ".", " ", ": "},
    {"it", ",", ".", ": "},
    {"de", ",", ".", ": "},
    {"fr", ",", "\u202F", "\u202F: "},  // a narrow space, at which no line ends
    {"es", ",", "\u202F", ": "},
});

}  // namespace

std::span<const LanguageRow> languages() {
    return k_languages;
}

const LanguageRow& row_of(Language language) {
    return k_languages.at(static_cast<std::size_t>(language));
}

std::string language_code(Language language) {
    return row_of(language).code;
}

std::string language_codes() {
    std::string all;
    for (const LanguageRow& one : k_languages) all += (all.empty() ? "" : ", ") + std::string(one.code);
    return all;
}

std::optional<Language> language_of_code(std::string_view code) {
    for (std::size_t i = 0; i < k_languages.size(); ++i)
        if (k_languages.at(i).code == code) return static_cast<Language>(i);
    return std::nullopt;
}

Language language_of_locale(std::string_view locale) {
    return language_of_code(locale.substr(0, locale.find_first_of("_.@"))).value_or(Language::english);
}

Language process_language() {
    for (const char* name : {"LC_ALL", "LC_MESSAGES", "LANG"})
        if (const char* locale = std::getenv(name); locale != nullptr && *locale != '\0')
            return language_of_locale(locale);
    return Language::english;
}

namespace {

constexpr std::uint32_t k_catalogue_magic = 0x950412DE;
constexpr std::uint64_t k_entry_size = 8;  // length and place

[[noreturn]] void refuse_catalogue(const char* what) {
    throw Error(ErrorKind::environment, Problem{what, "catalogue of texts", "", "", "Build the program again"});
}

}  // namespace

Catalogue::Catalogue(std::string_view bytes) : bytes_(bytes) {
    if (number(0) != k_catalogue_magic || number(4) >> 16 != 0) refuse_catalogue("not a compiled catalogue");
    end_ = number(8);
    english_at_ = number(12);
    text_at_ = number(16);
    for (std::uint32_t i = 0; i < end_; ++i) {
        (void)entry(text_at_, i);
        if (i > 0 && entry(english_at_, i - 1) >= entry(english_at_, i)) refuse_catalogue("texts are not sorted");
    }
    if (end_ > 0 && entry(english_at_, 0).empty()) begin_ = 1;
}

/// msgfmt writes the lowest byte first, on every machine.
std::uint32_t Catalogue::number(std::uint64_t at) const {
    if (at + 4 > bytes_.size()) refuse_catalogue("ends early");
    std::uint32_t value = 0;
    for (std::uint64_t i = 4; i-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes_[at + i]);
    return value;
}

std::string_view Catalogue::entry(std::uint32_t table, std::uint32_t index) const {
    const std::uint64_t at = table + k_entry_size * index, length = number(at), begin = number(at + 4);
    if (begin + length > bytes_.size()) refuse_catalogue("ends early");
    return bytes_.substr(begin, length);
}

std::optional<std::string_view> Catalogue::find(std::string_view english) const {
    std::uint32_t begin = begin_, end = end_;
    while (begin < end) {
        const std::uint32_t middle = begin + (end - begin) / 2;
        const int order = entry(english_at_, middle).compare(english);
        if (order == 0) return entry(text_at_, middle);
        (order < 0 ? begin : end) = order < 0 ? middle + 1 : middle;
    }
    return std::nullopt;
}

const Catalogue& catalogue_of(Language language) {
    static const auto k_catalogues = [] {
        std::vector<Catalogue> all(languages().size());
        for (const EmbeddedCatalogue& one : embedded_catalogues())
            if (const auto of = language_of_code(one.code)) all[static_cast<std::size_t>(*of)] = Catalogue(one.bytes);
        return all;
    }();
    return k_catalogues.at(static_cast<std::size_t>(language));
}

namespace {

bool is_digit(std::string_view text, std::size_t at) {
    return at < text.size() && std::isdigit(static_cast<unsigned char>(text[at])) != 0;
}

/// Whether a space is between groups of a number: one to three digits before it, exactly three after it.
bool is_between_groups(std::string_view text, std::size_t at) {
    const bool three = is_digit(text, at + 1) && is_digit(text, at + 2) && is_digit(text, at + 3);
    if (at == 0 || !is_digit(text, at - 1) || !three || is_digit(text, at + 4)) return false;
    std::size_t before = at;
    while (before > 0 && is_digit(text, before - 1)) --before;
    return at - before <= 3;
}

}  // namespace

Words Words::with(const OwnTexts& texts) const {
    Words more = *this;
    if (const auto own = texts.find(language_code(language_)); own != texts.end())
        more.own_.insert(own->second.begin(), own->second.end());
    return more;
}

std::string Words::operator()(std::string_view english, const std::vector<std::string>& values) const {
    const auto own = own_.find(english);
    const std::string_view pattern =
        own != own_.end() ? own->second : catalogue_of(language_).find(english).value_or(english);
    std::string text;
    for (std::size_t i = 0; i < pattern.size(); ++i) {
        const bool is_place = pattern[i] == '{' && is_digit(pattern, i + 1) && i + 2 < pattern.size() &&
                              pattern[i + 2] == '}' && pattern[i + 1] > '0' &&
                              static_cast<std::size_t>(pattern[i + 1] - '1') < values.size();
        if (!is_place) {
            text += pattern[i];
            continue;
        }
        text += values[static_cast<std::size_t>(pattern[i + 1] - '1')];
        i += 2;
    }
    return text;
}

std::string Words::number(std::string_view english) const {
    const LanguageRow& signs = row_of(language_);
    std::string text;
    for (std::size_t i = 0; i < english.size(); ++i) {
        if (english[i] == '.' && is_digit(english, i + 1) && i > 0 && is_digit(english, i - 1))
            text += signs.decimal;
        else if (english[i] == ' ' && is_between_groups(english, i))
            text += signs.thousands;
        else
            text += english[i];
    }
    return text;
}

std::string Words::labelled(std::string_view label, std::string_view text) const {
    return std::string(label) + row_of(language_).colon + std::string(text);
}

namespace {

/// Digits in a word belong to it: Float32, m2.
bool continues_word(std::string_view text, std::size_t at) {
    if (at == 0) return false;
    const auto before = static_cast<unsigned char>(text[at - 1]);
    return std::isalnum(before) != 0 || before == '_' || before == '.' || before == '/' || before >= 0x80;
}

}  // namespace

NumberPattern::NumberPattern(std::string_view english) {
    static const std::regex k_number(R"(\d{1,3}( \d{3})+(?!\d)(\.\d+)?|\d+(\.\d+)?)");
    constexpr std::size_t k_places = 9;
    const std::string whole(english);
    std::size_t end = 0;
    for (std::sregex_iterator one(whole.begin(), whole.end(), k_number), none; one != none; ++one) {
        const auto begin = static_cast<std::size_t>(one->position());
        if (numbers.size() == k_places || continues_word(english, begin)) continue;
        numbers.push_back(one->str());
        text += whole.substr(end, begin - end) + "{" + std::to_string(numbers.size()) + "}";
        end = begin + numbers.back().size();
    }
    text += whole.substr(end);
}

std::string NumberPattern::in(const Words& words) const {
    std::vector<std::string> shown(numbers.size());
    std::transform(numbers.begin(), numbers.end(), shown.begin(),
                   [&](const std::string& number) { return words.number(number); });
    return words(text, shown);
}

}  // namespace frana
