// SPDX-License-Identifier: Apache-2.0
#include "core/words/words.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace frana {
namespace {

TEST(Words, TextsOfARowAreInTheLanguageWithTheirValues) {
    EXPECT_EQ(Words()("Area deeper than {1} m", {"12"}), "Area deeper than 12 m");
    EXPECT_EQ(Words(Language::german)("Area deeper than {1} m", {"12"}), "Fläche tiefer als 12 m");
    EXPECT_EQ(Words(Language::french)("{1} % of the area", {"3"}), "3\u202F% de la surface");
    EXPECT_EQ(Words(Language::italian)("a user's own {9}", {"12"}), "a user's own {9}") << "no row: unchanged";
    EXPECT_EQ(Words(Language::italian)("a user's own {1}", {"{2}"}), "a user's own {2}") << "values are not patterns";
}

TEST(Words, NumbersHaveTheSignsOfTheLanguage) {
    const std::string english = "1 234 567.5 and 0.25, 12 3";
    EXPECT_EQ(Words().number(english), english);
    EXPECT_EQ(Words(Language::german).number(english), "1.234.567,5 and 0,25, 12 3");
    EXPECT_EQ(Words(Language::italian).number("-1 200"), "-1.200");
    EXPECT_EQ(Words(Language::french).number(english), "1\u202F234\u202F567,5 and 0,25, 12 3");
    EXPECT_EQ(Words(Language::spanish).number("12 300 m²"), "12\u202F300 m²");
    EXPECT_EQ(Words(Language::spanish).number("v. 2, end."), "v. 2, end.");
    EXPECT_EQ(Words(Language::spanish).number("2020 123"), "2020 123") << "not groups of one number";
}

TEST(Words, LabelsFollowTheLanguage) {
    EXPECT_EQ(Words(Language::german).labelled("Bindo", "Fließtiefe"), "Bindo: Fließtiefe");
    EXPECT_EQ(Words(Language::french).labelled("Bindo", "Intensité"), "Bindo\u202F: Intensité");
}

TEST(Words, ALocaleNamesItsLanguage) {
    EXPECT_EQ(language_of_locale("de_AT.UTF-8"), Language::german);
    EXPECT_EQ(language_of_locale("it"), Language::italian);
    EXPECT_EQ(language_of_locale("es_ES@euro"), Language::spanish);
    EXPECT_EQ(language_of_locale("fr.UTF-8"), Language::french);
    for (const char* other : {"C", "C.UTF-8", "POSIX", "xx_XX.UTF-8", "", "deu"})
        EXPECT_EQ(language_of_locale(other), Language::english) << other;
}

TEST(Words, TheFirstLocaleVariableThatIsSetDecides) {
    struct Restored {
        std::string all = std::getenv("LC_ALL") != nullptr ? std::getenv("LC_ALL") : "";
        ~Restored() { ::setenv("LC_ALL", all.c_str(), 1); }
    } restored;
    ::setenv("LANG", "it_IT.UTF-8", 1);
    ::setenv("LC_MESSAGES", "fr_FR.UTF-8", 1);
    ::setenv("LC_ALL", "de_DE.UTF-8", 1);
    EXPECT_EQ(process_language(), Language::german);
    ::setenv("LC_ALL", "", 1);
    EXPECT_EQ(process_language(), Language::french);
    ::unsetenv("LC_MESSAGES");
    EXPECT_EQ(process_language(), Language::italian);
    ::unsetenv("LANG");
    EXPECT_EQ(process_language(), Language::english);
}

}  // namespace
}  // namespace frana
