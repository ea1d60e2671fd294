// SPDX-License-Identifier: Apache-2.0
// User's names in the files that frana writes: spreadsheets' formulas, bytes that are not UTF-8, names of files.
#include <gtest/gtest.h>

#include <set>

#include "app/text/text_file.h"
#include "app/text/text_table.h"
#include "core/text.h"

namespace frana::app {
namespace {

TEST(Names, BytesThatAreNotUtf8AreEscaped) {
    const std::string good = "Val Ferret, 2 µm, 日本, 🏔";
    EXPECT_EQ(valid_utf8(good), good);
    EXPECT_EQ(valid_utf8("caf\xE9"), "caf\\xe9");
    EXPECT_EQ(valid_utf8("\xC3"), "\\xc3");                             // truncated
    EXPECT_EQ(valid_utf8("\xC0\xAF"), "\\xc0\\xaf");                    // overlong
    EXPECT_EQ(valid_utf8("\xED\xA0\x80"), "\\xed\\xa0\\x80");           // surrogate
    EXPECT_EQ(valid_utf8("\xF4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80");  // beyond Unicode
    EXPECT_EQ(valid_utf8("\xE9t\xC3\xA9"), "\\xe9t\xC3\xA9");
    EXPECT_EQ(valid_utf8(""), "");
    EXPECT_EQ(escaped_markup("<i>\xFF & 'x'\"</i>"), "&lt;i&gt;\\xff &amp; &#39;x&#39;&quot;&lt;/i&gt;");
}

TEST(Names, WhatNoPageCanShowIsASpace) {
    EXPECT_EQ(shown_text("a\x01"
                         "b\x1b[2J\x7f\xC2\x85\n\t"),
              "a b [2J  \n\t");
    EXPECT_EQ(shown_text("a\u202Eb\u2066c\u200Fd\uFEFFe\uFFFFf\u061C"), "a b c d e f ");
    EXPECT_EQ(shown_text("Val Ferret, 2 \u00b5m, \u200Cneighbours\u2060: \xFF"),
              "Val Ferret, 2 \u00b5m, \u200Cneighbours\u2060: \\xff");
    EXPECT_EQ(escaped_markup("<a\x01\u202Eb>"), "&lt;a  b&gt;");
}

TEST(Names, LongTextsEndInAnEllipsis) {
    EXPECT_EQ(elided("abc", 3), "abc");
    EXPECT_EQ(elided("abcd", 3), "ab…");
    EXPECT_EQ(elided("äöüß", 3), "äö…");
    EXPECT_EQ(elided("", 3), "");
    EXPECT_EQ(elided("\xFF\xFF\xFF\xFF", 2), "\xFF…");
}

TEST(Names, NoCellOfATableIsAFormula) {
    for (const std::string name : {"=1+1", "+1", "-1", "@SUM(A1)", "\t=1", "\r=1", "\n=1", "'=1", "'", "=a,\"b\""}) {
        const std::string cell = csv_cell(name);
        const bool quoted = cell.front() == '"';
        EXPECT_EQ(cell[quoted ? 1 : 0], '\'') << name;
        // As read by a CSV reader.
        std::string bare = quoted ? cell.substr(1, cell.size() - 2) : cell;
        for (std::size_t at = bare.find("\"\""); at != std::string::npos; at = bare.find("\"\"", at + 1))
            bare.erase(at, 1);
        EXPECT_EQ(text_of_cell(bare), name);
    }
    for (const std::string name : {"flow path", "l'Aquila", "a=b", "", "1-2"}) EXPECT_EQ(csv_cell(name), name);
    EXPECT_EQ(csv_cell("a,b"), "\"a,b\"");
    EXPECT_EQ(csv_cell("caf\xE9"), "caf\\xe9");
    EXPECT_EQ(csv_line({"-0.5", "=1", "a,b", "", "1e-300"}), "-0.5,'=1,\"a,b\",,1e-300\n");
}

TEST(Names, FilesOfDifferentNamesDiffer) {
    EXPECT_EQ(file_stems({"flow path"}), std::vector<std::string>{"flow_path"});
    const std::vector<std::string> names{
        "a b", "a_b", "a/b", "A_b", "ä", "ö", "..", "", std::string(240, 'x'), std::string(240, 'x') + "y"};
    const std::vector<std::string> stems = file_stems(names);
    std::set<std::string> kept;
    for (std::string stem : stems) {
        EXPECT_LE(stem.size(), 120U);
        for (const char c : stem)
            EXPECT_TRUE(std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '_') << stem;
        for (char& c : stem) c = static_cast<char>(std::tolower(c));
        kept.insert(stem);
    }
    EXPECT_EQ(kept.size(), names.size());
    const std::vector<std::string> turned = file_stems({names.rbegin(), names.rend()});
    EXPECT_EQ(std::vector<std::string>(turned.rbegin(), turned.rend()), stems);
    EXPECT_EQ(file_stems({"a b", "a_b"})[1], "a_b");
    EXPECT_EQ(shortened_name("short"), "short");
}

}  // namespace
}  // namespace frana::app
