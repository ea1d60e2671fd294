// SPDX-License-Identifier: Apache-2.0
// The texts that the sources show through words("...") or mark with worded("...") are those of the tables, no more and
// no less.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "core/words/word_row.h"
#include "params/keys/key_words.h"
#include "params/keys/materials.h"
#include "params/keys/result_rasters.h"
#include "params/keys/scene_parameters.h"
#include "simulation/run_statistics.h"

namespace frana {
namespace {

namespace fs = std::filesystem;

/// Reads a literal at text[at] == '"' and those that continue it; moves `at` behind them. Only the escapes in use.
std::string literal_at(const std::string& text, std::size_t& at) {
    std::string literal;
    while (at < text.size() && text[at] == '"') {
        for (++at; text[at] != '"'; ++at) {
            if (text[at] != '\\') {
                literal += text[at];
            } else if (text[++at] == 'u') {
                const auto code = static_cast<unsigned>(std::stoul(text.substr(at + 1, 4), nullptr, 16));
                at += 4;
                if (code >= 0x800) literal += static_cast<char>(0xE0 | code >> 12);
                if (code >= 0x800) literal += static_cast<char>(0x80 | (code >> 6 & 0x3F));
                if (code < 0x800) literal += static_cast<char>(0xC0 | code >> 6);
                literal += static_cast<char>(0x80 | (code & 0x3F));
            } else {
                literal += text[at];
            }
        }
        ++at;
        const std::size_t next = text.find_first_not_of(" \n", at);
        if (next != std::string::npos && text[next] == '"') at = next;
    }
    return literal;
}

/// Returns the literals of the first argument of a call whose opening bracket is at `open`.
std::vector<std::string> first_argument(const std::string& text, std::size_t open) {
    std::vector<std::string> literals;
    int depth = 0;
    for (std::size_t at = open; at < text.size(); ++at) {
        if (text[at] == '"') {
            literals.push_back(literal_at(text, at));
            --at;
            continue;
        }
        if (text[at] == '(' || text[at] == '{' || text[at] == '[') ++depth;
        if (text[at] == ')' || text[at] == '}' || text[at] == ']') --depth;
        if (depth == 0 || (depth == 1 && text[at] == ',')) break;
    }
    return literals;
}

/// Returns every text that the sources show, each with the file that does.
std::map<std::string, std::string> shown_texts() {
    std::map<std::string, std::string> texts;
    const std::regex call(R"(\b(words_?|worded)(\(\))?\()");
    for (const char* folder : {"src", "gis", "render"}) {
        for (const auto& entry : fs::recursive_directory_iterator(fs::path(FRANA_SOURCE_DIR) / folder)) {
            const fs::path& path = entry.path();
            if (path.extension() != ".cpp" && path.extension() != ".h") continue;
            const std::string name = path.string();  // these have examples in their comments
            if (name.ends_with("core/words/words.h") || name.ends_with("core/words/sentence.h")) continue;
            std::stringstream content;
            content << std::ifstream(path).rdbuf();
            const std::string text = content.str();
            for (std::sregex_iterator one(text.begin(), text.end(), call), end; one != end; ++one) {
                const auto open = static_cast<std::size_t>(one->position() + one->length() - 1);
                for (const std::string& literal : first_argument(text, open))
                    texts.emplace(literal, fs::relative(path, FRANA_SOURCE_DIR).string());
            }
        }
    }
    for (const ResultRaster& row : result_rasters())
        texts.emplace(text_for(row, row.title, row.name + "_{1}"), "src/params/keys/result_rasters.cpp");
    for (const Parameter& key : scene_parameters())
        for (const std::string& row : rows_of(key)) texts.emplace(row, "the declaration of " + key.name());
    for (const MaterialPreset& preset : material_presets(std::string(FRANA_SOURCE_DIR) + "/share/materials"))
        for (const std::string& text : paragraphs_of(preset.comments)) texts.emplace(text, preset.file);
    for (const RunStatistic& row : k_run_statistics)
        if (is_reported(row)) texts.emplace(row.title, "src/simulation/run_statistics.h");
    return texts;
}

/// Returns the arguments of the calls of RunLog::warn that are not sentences of the tables: text put together.
std::vector<std::string> other_warnings() {
    std::vector<std::string> found;
    const std::regex call(R"(\blog_?\.warn\(\s*([^;]*);)"),
        sentence(R"(worded\([^]*|\*?\w+\)|std::string\(error\.what\(\)\)\)|accuracy_verdict\([^]*)");
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(FRANA_SOURCE_DIR) / "src/app")) {
        if (entry.path().extension() != ".cpp") continue;
        std::stringstream content;
        content << std::ifstream(entry.path()).rdbuf();
        const std::string text = content.str();
        for (std::sregex_iterator one(text.begin(), text.end(), call), end; one != end; ++one)
            if (!std::regex_match((*one)[1].str(), sentence))
                found.push_back(entry.path().filename().string() + ": " + (*one)[1].str());
    }
    return found;
}

std::multiset<std::string> places(const std::string& text) {
    const std::regex place(R"(\{[^}]*\})");
    std::multiset<std::string> found;
    for (std::sregex_iterator one(text.begin(), text.end(), place), end; one != end; ++one) found.insert(one->str());
    return found;
}

TEST(WordTables, EveryTextOfTheSourcesHasARowAndEveryRowIsUsed) {
    const auto shown = shown_texts();
    EXPECT_GT(shown.size(), 100U) << "the search has found the calls";
    std::set<std::string> rows;
    for (const std::span<const WordRow> table : word_tables()) {
        for (const WordRow& row : table) {
            EXPECT_TRUE(rows.insert(row.english).second) << "twice: " << row.english;
            EXPECT_EQ(shown.count(row.english), 1U) << "no source uses the row \"" << row.english << '"';
        }
    }
    for (const auto& [text, file] : shown)
        EXPECT_EQ(rows.count(text), 1U) << file << ": no table has the text \"" << text << '"';
}

TEST(WordTables, WarningsAreSentencesOfTheTables) {
    EXPECT_EQ(other_warnings(), std::vector<std::string>());
}

TEST(WordTables, EveryRowIsCompleteInEveryLanguage) {
    for (const std::span<const WordRow> table : word_tables()) {
        for (const WordRow& row : table) {
            for (const char* text : {row.italian, row.german, row.french, row.spanish}) {
                ASSERT_NE(text, nullptr) << row.english;
                EXPECT_NE(std::string(text), "") << row.english;
                EXPECT_EQ(places(text), places(row.english)) << text;
            }
            // No-break and narrow where French has a space that must not end a line.
            EXPECT_FALSE(std::regex_search(row.french, std::regex(" [:;?!%]"))) << row.french;
            EXPECT_FALSE(std::regex_search(row.french, std::regex("[a-zé0-9}](: |%)"))) << row.french;
            // SQL has typewriter's apostrophes, which no letter follows and precedes.
            for (const char* text : {row.italian, row.french})
                EXPECT_FALSE(std::regex_search(text, std::regex("[a-zA-Z]'[^ ,;]")))
                    << "typewriter's apostrophe: " << text;
        }
    }
}

TEST(WordTables, NoLongTextIsTheCopyOfAnotherLanguages) {
    constexpr std::size_t k_long = 30;  // shorter ones can be the same by right: "Manning, n = {1}"
    for (const std::span<const WordRow> table : word_tables()) {
        for (const WordRow& row : table) {
            std::set<std::string> texts;
            for (const char* text : {row.english, row.italian, row.german, row.french, row.spanish})
                if (std::string(text).size() > k_long) {
                    EXPECT_TRUE(texts.insert(text).second) << "in two languages: " << text;
                }
        }
    }
}

}  // namespace
}  // namespace frana
