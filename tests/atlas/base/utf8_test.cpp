// Texts of files as messages quote them.
#include "atlas/base/utf8.h"

#include <gtest/gtest.h>

namespace burl {
namespace {

TEST(LegibleText, KeepsLetters) {
    for (const char* text : {"", "plain ~ text?", "K\u00e4se", "\u65e5\u672c", "\U0001f600"})
        EXPECT_EQ(legible(text, 40), text);
}

TEST(LegibleText, ReplacesWhatIsNoCharacterOfALine) {
    EXPECT_EQ(legible("a\tb\nc\x1b[31m\x7f", 40), "a?b?c?[31m?");
    EXPECT_EQ(legible("\u009b31m", 40), "?31m");
    EXPECT_EQ(legible("caf\xe9", 40), "caf?");
    EXPECT_EQ(legible("\xe2\x80", 40), "??");
}

TEST(LegibleText, EndsBetweenCharacters) {
    EXPECT_EQ(legible("abc", 3), "abc");
    EXPECT_EQ(legible("abcd", 3), "abc...");
    EXPECT_EQ(legible("ab\u00e4", 4), "ab\u00e4");
    EXPECT_EQ(legible("ab\u00e4", 3), "ab...");
    EXPECT_EQ(legible("\u00e4\u00e4", 3), "\u00e4...");
}

}  // namespace
}  // namespace burl
