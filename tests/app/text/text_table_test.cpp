// SPDX-License-Identifier: Apache-2.0
#include "app/text/text_table.h"

#include <gtest/gtest.h>

#include <sstream>

namespace frana::app {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

TEST(DisplayWidth, CountsLettersAsTheyAreShown) {
    EXPECT_EQ(display_width("Rutschung"), 9U);
    EXPECT_EQ(display_width("Müren"), 5U);
    EXPECT_EQ(display_width("Mu\xcc\x88ren"), 5U);  // a combining diaeresis
    EXPECT_EQ(display_width("滑坡"), 4U);           // two wide letters
    EXPECT_EQ(display_width("a\xff"), 2U);          // not UTF-8
    EXPECT_EQ(padded("滑坡", 6), "滑坡  ");
    EXPECT_EQ(padded("é", 3, true), "  é");
}

TEST(DisplayWidth, WrapsAtSpacesAndBreaksLongWords) {
    EXPECT_EQ(wrapped("große Mure am Hang", 8), (std::vector<std::string>{"große", "Mure am", "Hang"}));
    EXPECT_EQ(wrapped("müßiggang", 5), (std::vector<std::string>{"müßig", "gang"}));
    EXPECT_EQ(wrapped("滑坡灾害", 5), (std::vector<std::string>{"滑坡", "灾害"}));
    EXPECT_EQ(wrapped("", 5), std::vector<std::string>{});
}

TEST(Table, IsAsNarrowAsAsked) {
    Table table({"Bezeichnung", "Wert"});
    const std::vector<Table::Layout> columns{{30}, {20, true}};
    table.row({"Mächtigkeit der Rutschmasse am Hang", "12.5 m"});
    table.row({"滑坡体的最大厚度", "1"});
    for (const std::size_t width : {100U, 40U, 24U, 18U, 10U}) {
        const std::string text = table.text(width, columns, true);
        for (const std::string& line : lines_of(text)) EXPECT_LE(display_width(line), width) << text;
    }
    // The columns of numbers end in the same place, also beside wide letters.
    const auto lines = lines_of(table.text(100, columns, true));
    for (const std::string& line : lines) {
        const bool ends_with_number = line.ends_with("12.5 m") || line.ends_with(" 1");
        EXPECT_TRUE(!ends_with_number || display_width(line) == display_width(lines[1]))
            << table.text(100, columns, true);
    }
}

// Words of 9, 10 and 10 letters and two gaps need 33 columns.
TEST(Table, TearsNoShortWord) {
    Table table({"Input", "CRS", "Extent"});
    const std::vector<Table::Layout> columns{{20}, {20}, {20}};
    table.row({"perimeter of the release", "EPSG:32632", "361015.60\n5094023.40"});
    for (const std::size_t width : {80U, 40U, 34U, 33U, 20U}) {
        const std::string text = table.text(width, columns, true);
        for (const char* word : {"perimeter", "EPSG:32632", "361015.60", "5094023.40"})
            EXPECT_NE(text.find(word), std::string::npos) << width << "\n" << text;
        for (const std::string& line : lines_of(text)) EXPECT_LE(display_width(line), width) << text;
        EXPECT_EQ(text.find("CRS: EPSG:32632") != std::string::npos, width < 33) << width << "\n" << text;
    }
}

TEST(Table, FactsAreWrappedBesideTheirName) {
    EXPECT_EQ(fact_line("terms", "friction and turbulence of the bed, everywhere", 45),
              "  terms            friction and turbulence of\n                   the bed, everywhere\n");
}

TEST(Table, FoldedLinesKeepTheirIndentation) {
    EXPECT_EQ(folded("short\n    a long line of some words here\n", 22),
              "short\n    a long line of\n      some words here\n");
}

}  // namespace
}  // namespace frana::app
