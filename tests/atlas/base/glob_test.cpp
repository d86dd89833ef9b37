// Patterns of names, against their definition by recursion.
#include "atlas/base/glob.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace burl {
namespace {

/// The definition, for names of ASCII.
bool fits(std::string_view name, std::string_view pattern) {
    if (pattern.empty()) return name.empty();
    if (pattern[0] == '*')
        return fits(name, pattern.substr(1)) || (!name.empty() && fits(name.substr(1), pattern));
    return !name.empty() && (pattern[0] == '?' || pattern[0] == name[0]) &&
           fits(name.substr(1), pattern.substr(1));
}

/// All texts of up to `longest` of the letters.
std::vector<std::string> texts(std::string_view letters, std::size_t longest) {
    std::vector<std::string> all{""};
    for (std::size_t first = 0, size = 0; size < longest; ++size) {
        const std::size_t end = all.size();
        for (; first < end; ++first)
            for (const char letter : letters) all.push_back(all[first] + letter);
    }
    return all;
}

TEST(Glob, AgreesWithItsDefinition) {
    std::size_t fitting = 0;
    for (const std::string& name : texts("ab", 5))
        for (const std::string& pattern : texts("ab*?", 5)) {
            ASSERT_EQ(matches_glob(name, pattern), fits(name, pattern)) << name << ' ' << pattern;
            fitting += fits(name, pattern);
        }
    EXPECT_GT(fitting, 1000u);
}

TEST(Glob, TakesACharacterOfUtf8AsOne) {
    EXPECT_TRUE(
        matches_glob("Kl\xc3\xb6\xc3\x9f"
                     "e",
                     "Kl??e"));
    EXPECT_FALSE(
        matches_glob("Kl\xc3\xb6\xc3\x9f"
                     "e",
                     "Kl????e"));
    EXPECT_TRUE(matches_glob("\xe6\x9c\xa8.001", "?.*"));
}

TEST(Glob, TakesBracketsCaseAndSlashesAsThemselves) {
    EXPECT_TRUE(matches_glob("[a]", "[a]"));
    EXPECT_FALSE(matches_glob("a", "[a]"));
    EXPECT_FALSE(matches_glob("Wood", "wood"));
    EXPECT_TRUE(matches_glob("a/b/.c", "a*c"));
}

TEST(Glob, EndsOnHostileNames) {
    const std::string name(4000, 'a');
    std::string pattern;
    for (int i = 0; i < 500; ++i) pattern += "*a";
    EXPECT_FALSE(matches_glob(name, pattern + "b"));
    EXPECT_TRUE(matches_glob(name, pattern));
}

}  // namespace
}  // namespace burl
