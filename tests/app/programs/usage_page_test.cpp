// docs/reference/usage.md tells every option that a verb's --help tells, and its tables tell no
// other.
#include <algorithm>
#include <set>
#include <sstream>

#include <gmock/gmock.h>

#include "app/bench/command.h"
#include "tests/app/programs/run_program.h"

namespace burl::test {
namespace {

using OptionNames = std::set<std::string>;

/// The names that begin with one or two dashes and a small letter, at the text's begin or after one
/// of "
/// `,;(".
OptionNames options_in(const std::string& text) {
    const std::string letters = "abcdefghijklmnopqrstuvwxyz", rest = letters + "0123456789-";
    OptionNames names;
    for (std::size_t at = text.find('-'); at < text.size(); at = text.find('-', at)) {
        const std::size_t name = text.find_first_not_of('-', at),
                          end = std::min(text.find_first_not_of(rest, at), text.size());
        const bool begins = at == 0 || std::string(" `,;(").find(text[at - 1]) < 5;
        if (begins && name <= at + 2 && name < end && letters.find(text[name]) < letters.size())
            names.insert(text.substr(at, end - at));
        at = end;
    }
    return names;
}

/// The page from the verb's heading to the next heading.
std::string section_of(const std::string& verb) {
    const std::string page = slurp(source_folder() + "/docs/reference/usage.md");
    const std::size_t begin = page.find("\n### `burl " + verb + " ");
    EXPECT_NE(begin, std::string::npos) << verb;
    const std::size_t end = std::min(page.find("\n### ", begin + 1), page.find("\n## ", begin + 1));
    return page.substr(begin, end - begin);
}

/// The options that the first cells of the section's tables name.
OptionNames options_of_tables(const std::string& section) {
    OptionNames names;
    std::istringstream lines(section);
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with("| `-")) names.merge(options_in(line.substr(0, line.find(" |", 1))));
    return names;
}

class UsagePage : public testing::TestWithParam<const char*> {};

TEST_P(UsagePage, TellsTheOptionsOfTheHelp) {
    const Scratch scratch;
    const std::string section = section_of(GetParam());
    const OptionNames told = options_in(section);
    std::istringstream help(run_burl(scratch, fmt::format("{} --help", GetParam())).out);
    OptionNames all;
    for (std::string line; std::getline(help, line);) {
        if (!line.starts_with("  -") || line.starts_with("  -h,")) continue;
        const OptionNames names = options_in(line.substr(0, line.find(' ', 2)));
        EXPECT_TRUE(std::ranges::any_of(names, [&](const auto& one) { return told.contains(one); }))
            << line;
        all.insert(names.begin(), names.end());
    }
    EXPECT_FALSE(all.empty());
    for (const std::string& name : options_of_tables(section))
        EXPECT_TRUE(all.contains(name)) << name;
}

INSTANTIATE_TEST_SUITE_P(Verbs, UsagePage,
                         testing::Values("bake", "batch", "render", "diff", "metrics", "bench",
                                         "eval", "figures", "list", "show"),
                         [](const auto& verb) { return std::string(verb.param); });

TEST(UsagePageOfBench, NamesEverySuite) {
    const std::string section = section_of("bench");
    for (const std::string& suite : bench_suite_names())
        EXPECT_THAT(section,
                    testing::ContainsRegex(fmt::format("`({}`|burl bench {} )", suite, suite)));
}

TEST(UsagePageOfMetrics, OffersSquareTexturesAlone) {
    const Scratch scratch;
    EXPECT_EQ(run_burl(scratch, "metrics --help").out.find("WxH"), std::string::npos);
    EXPECT_NE(run_burl(scratch, "bake --help").out.find("WxH"), std::string::npos);
}

}  // namespace
}  // namespace burl::test
