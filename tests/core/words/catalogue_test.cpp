// SPDX-License-Identifier: Apache-2.0
// The texts that the sources show through words("...") or mark with worded("...") are those of the catalogues share/po,
// no more and no less.
#include "core/words/words.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <regex>
#include <set>
#include <sstream>

#include "core/error.h"
#include "params/keys/materials.h"
#include "params/keys/result_rasters.h"
#include "params/keys/scene_parameters.h"
#include "params/keys/used_keys.h"
#include "simulation/run_summary.h"

namespace frana {
namespace {

namespace fs = std::filesystem;

std::string read_file(const fs::path& path) {
    std::stringstream content;
    content << std::ifstream(path).rdbuf();
    return content.str();
}

std::vector<fs::path> sources_in(const std::vector<std::string>& folders) {
    std::vector<fs::path> found;
    for (const std::string& folder : folders)
        for (const auto& entry : fs::recursive_directory_iterator(fs::path(FRANA_SOURCE_DIR) / folder))
            if (const fs::path end = entry.path().extension(); end == ".cpp" || end == ".h")
                found.push_back(entry.path());
    return found;
}

/// Returns a catalogue, made by gettext's tools, of the texts in calls of words(), words_() and worded().
std::string catalogue_of_sources() {
    const std::string command = "cd '" FRANA_SOURCE_DIR
                                "' && find src gis render -name '*.cpp' -o -name '*.h' | "
                                "xgettext --language=C++ --from-code=UTF-8 --keyword --keyword=words --keyword=words_ "
                                "--keyword=worded --files-from=- --output=- | msgen - | msgfmt --output-file=- -";
    const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
    std::string bytes;
    for (int one = 0; pipe && (one = std::fgetc(pipe.get())) != EOF;) bytes += static_cast<char>(one);
    return bytes;
}

std::set<std::string> english_texts(const Catalogue& catalogue) {
    std::set<std::string> texts;
    for (std::uint32_t i = 0; i < catalogue.size(); ++i) texts.emplace(catalogue.english(i));
    return texts;
}

/// Returns the parts of a raster's title, which are translated one by one: "Probability", "depth" of "Probability,
/// depth > {1} m".
std::vector<std::string> parts_of(const std::string& title) {
    std::vector<std::string> parts;
    std::stringstream text(title);
    for (std::string part; std::getline(text, part, ',');) {
        part.erase(0, part.find_first_not_of(' '));
        parts.push_back(part.substr(0, part.find(" > ")));
    }
    std::erase(parts, "{1}");
    return parts;
}

/// Returns every text that the program shows.
const std::set<std::string>& shown_texts() {
    static const auto k_texts = [] {
        const std::string bytes = catalogue_of_sources();
        std::set<std::string> texts = english_texts(Catalogue(bytes));
        for (const ResultRaster& row : result_rasters())
            for (const std::string& part : parts_of(text_for(row, row.title, row.of_value("{1}")))) texts.insert(part);
        for (const Parameter& key : scene_parameters())
            for (const std::string& text : rows_of(key)) texts.insert(text);
        for (const MaterialPreset& preset : material_presets(FRANA_SOURCE_DIR "/share/materials"))
            for (const std::string& text : paragraphs_of(preset.comments))
                if (text.starts_with("Source: ")) texts.insert(text);
        for (const RunStatistic& row : k_run_statistics)
            if (is_reported(row)) texts.insert(row.title);
        return texts;
    }();
    return k_texts;
}

/// Returns the arguments of the calls of Findings::warn, and what the engine adds to warnings, that are not sentences
/// of the tables: text put together.
std::vector<std::string> other_warnings() {
    std::vector<std::string> found;
    const std::regex call(R"(\b(?:found_?\.warn|warnings_?\.push_back)\(\s*([^;]*);)"),
        sentence(R"(\{?worded\([^]*|\{words, limits_use\}\)|\*?\w+\)|std::string\(error\.what\(\)\)\))");
    std::vector<fs::path> sources = sources_in({"src/app"});
    sources.push_back(fs::path(FRANA_SOURCE_DIR) / "src/simulation/run_warnings.cpp");
    for (const fs::path& path : sources) {
        const std::string text = read_file(path);
        for (std::sregex_iterator one(text.begin(), text.end(), call), end; one != end; ++one)
            if (!std::regex_match((*one)[1].str(), sentence))
                found.push_back(path.filename().string() + ": " + (*one)[1].str());
    }
    return found;
}

std::multiset<std::string> places(const std::string& text) {
    const std::regex place(R"(\{[^}]*\})");
    std::multiset<std::string> found;
    for (std::sregex_iterator one(text.begin(), text.end(), place), end; one != end; ++one) found.insert(one->str());
    return found;
}

TEST(Catalogues, HaveTheTextsOfTheProgramAndNoOthers) {
    const std::set<std::string>& shown = shown_texts();
    EXPECT_GT(shown.size(), 600U) << "the search has found the calls";
    for (const LanguageRow& language : languages().subspan(1)) {
        const auto texts = english_texts(catalogue_of(language_of_code(language.code).value()));
        for (const std::string& text : texts)
            EXPECT_EQ(shown.count(text), 1U) << language.code << ".po: nothing shows \"" << text << '"';
        for (const std::string& text : shown)
            EXPECT_EQ(texts.count(text), 1U) << language.code << ".po lacks, or has as fuzzy, \"" << text << '"';
    }
}

// Lower it when texts went. What code shows is short, a row of a table; meanings of keys and sources of materials are
// help, and errors are no texts of the catalogues: none of these is in code's calls.
TEST(Catalogues, TextsAreFewAndShort) {
    constexpr std::size_t k_texts = 799;
    constexpr std::ptrdiff_t k_words = 12;
    EXPECT_LE(shown_texts().size(), k_texts);
    const std::string bytes = catalogue_of_sources();
    for (const std::string& text : english_texts(Catalogue(bytes)))
        EXPECT_LT(std::count(text.begin(), text.end(), ' '), k_words) << text;
}

TEST(Catalogues, AreThoseOfTheLanguages) {
    EXPECT_EQ(embedded_catalogues().size(), languages().size() - 1) << "of all but English";
    for (const EmbeddedCatalogue& one : embedded_catalogues()) {
        ASSERT_TRUE(language_of_code(one.code)) << one.code << ".po has no row in words.cpp";
        EXPECT_NE(Catalogue(one.bytes).find("Flow depth"), "Flow depth");
    }
}

// xgettext sees one literal of an argument.
TEST(Catalogues, TextsAreMarkedOneByOne) {
    const std::regex two(R"(\b(words_?|worded)\([^"();]*(\([^"()]*\)[^"();]*|"\w+"[^"();]*){0,3}\?\s*")");
    EXPECT_TRUE(std::regex_search("found.warn(worded(n.size() == 1 ? \"{1} cell\" : \"{1} cells\"", two));
    EXPECT_TRUE(std::regex_search("words(what == \"depth\" ? \"Flow depth\" : \"Flow velocity\")", two));
    for (const fs::path& path : sources_in({"src", "gis", "render"})) {
        const std::string text = read_file(path);
        for (std::sregex_iterator one(text.begin(), text.end(), two), end; one != end; ++one)
            ADD_FAILURE() << path << ": " << one->str() << "...: write ? worded(\"...\") : worded(\"...\")";
    }
}

TEST(Catalogues, WarningsAreSentencesOfTheCatalogues) {
    EXPECT_EQ(other_warnings(), std::vector<std::string>());
}

TEST(Catalogues, TextsHaveTheirPlacesAndTheSignsOfTheLanguage) {
    for (const std::string& english : shown_texts()) {
        for (const LanguageRow& language : languages().subspan(1)) {
            const std::string text = Words(language_of_code(language.code).value())(english);
            EXPECT_NE(text, "") << english;
            EXPECT_EQ(places(text), places(english)) << text;
        }
        // No-break and narrow where French has a space that must not end a line.
        const std::string french = Words(Language::french)(english);
        EXPECT_FALSE(std::regex_search(french, std::regex(" [:;?!%]"))) << french;
        EXPECT_FALSE(std::regex_search(french, std::regex("[a-zé0-9}](: |%)"))) << french;
        // SQL has typewriter's apostrophes, which no letter follows and precedes.
        for (const std::string& text : {french, Words(Language::italian)(english)})
            EXPECT_FALSE(std::regex_search(text, std::regex("[a-zA-Z]'[^ ,;]"))) << "typewriter's apostrophe: " << text;
    }
}

TEST(Catalogues, NoLongTextIsTheCopyOfAnotherLanguages) {
    constexpr std::size_t k_long = 30;  // shorter ones can be the same by right: "Manning, n = {1}"
    for (const std::string& english : shown_texts()) {
        std::set<std::string> texts;
        for (const LanguageRow& language : languages()) {
            const std::string text = Words(language_of_code(language.code).value())(english);
            if (text.size() > k_long) {
                EXPECT_TRUE(texts.insert(text).second) << "in two languages: " << text;
            }
        }
    }
}

TEST(Catalogue, FindsTheFirstTheLastAndNoOthers) {
    const Catalogue& german = catalogue_of(Language::german);
    for (const std::uint32_t i : {0U, german.size() / 2, german.size() - 1}) {
        ASSERT_TRUE(german.find(german.english(i)));
        EXPECT_FALSE(german.find(std::string(german.english(i)) + "!"));
    }
    EXPECT_FALSE(german.find("")) << "the header is no text";
    EXPECT_FALSE(german.find("\xFF"));
    EXPECT_FALSE(Catalogue().find("Flow depth"));
    EXPECT_EQ(catalogue_of(Language::english).size(), 0U);
}

/// Little-endian numbers and what follows.
std::string bytes_of(const std::vector<std::uint32_t>& numbers, const std::string& rest) {
    std::string bytes;
    for (const std::uint32_t number : numbers)
        for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(number >> shift & 0xFF);
    return bytes + rest;
}

TEST(Catalogue, DamagedBytesAreRefused) {
    constexpr std::uint32_t k_magic = 0x950412DE, k_far = 0xFFFFFFFF;
    // Two texts, "a" and "b", shown as "c" and "d": the header of 20 bytes, two tables of 16.
    const std::vector<std::uint32_t> whole{k_magic, 0, 2, 20, 36, 1, 52, 1, 53, 1, 54, 1, 55};
    const std::string bytes = bytes_of(whole, "abcd");
    EXPECT_EQ(Catalogue(bytes).find("a"), "c");
    EXPECT_EQ(Catalogue(bytes).find("b"), "d");
    for (std::size_t size = 0; size < bytes.size(); ++size)
        EXPECT_THROW(Catalogue(std::string_view(bytes).substr(0, size)), Error) << size << " bytes";
    for (std::size_t i = 0; i < whole.size(); ++i) {
        std::vector<std::uint32_t> damaged = whole;
        damaged[i] = k_far;
        EXPECT_THROW(Catalogue(bytes_of(damaged, "abcd")), Error) << "number " << i;
    }
    EXPECT_THROW(Catalogue(bytes_of(whole, "bacd")), Error) << "not sorted";
    EXPECT_THROW(Catalogue(bytes_of(whole, "aacd")), Error) << "a text twice";
}

}  // namespace
}  // namespace frana
