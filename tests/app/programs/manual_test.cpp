// Manual pages and completions, against the programs' help and the shells themselves.
#include <cstdlib>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/recipe/parameters.h"
#include "procedural/graph/table.h"
#include "tests/app/programs/run_program.h"

namespace burl {
namespace {

using test::run_burl;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::IsSupersetOf;
using testing::Not;

std::vector<std::string> words_of(const std::string& text) {
    std::vector<std::string> words;
    std::size_t begin = 0;
    for (std::size_t at = 0; at <= text.size(); ++at) {
        if (at < text.size() && text[at] != ' ' && text[at] != '\n' && text[at] != ',') continue;
        if (at > begin) words.push_back(text.substr(begin, at - begin));
        begin = at + 1;
    }
    return words;
}

/// The text without roff's escapes of hyphens.
std::string unescaped(std::string text) {
    for (std::size_t at = 0; (at = text.find("\\-", at)) != std::string::npos;) text.erase(at, 1);
    return text;
}

class Manual : public testing::Test {
  protected:
    std::string made(const std::string& what) const {
        const auto ran = run_burl(scratch, "manual " + what);
        EXPECT_EQ(ran.exit_code, 0) << ran.err;
        return ran.out;
    }
    /// The words that bash offers after these.
    std::vector<std::string> offered(const std::string& words) const {
        std::ofstream(scratch / "burl.bash") << made("bash");
        std::ofstream(scratch / "ask.bash")
            << "source burl.bash\nCOMP_WORDS=(" << words
            << ")\nCOMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n_burl\necho \"${COMPREPLY[*]}\" >out\n";
        const std::string command = "cd '" + scratch.path().string() + "' && bash --norc ask.bash";
        EXPECT_EQ(std::system(command.c_str()), 0);
        return words_of(test::slurp(scratch / "out"));
    }

    test::Scratch scratch;
};

TEST_F(Manual, EveryVerbHasAPageWithAllItsOptions) {
    const std::vector<std::string> verbs = words_of(made("verbs"));
    EXPECT_THAT(verbs, IsSupersetOf({"bake", "render", "batch", "show", "list"}));
    EXPECT_THAT(verbs, Not(Contains("manual")));
    const std::string program = unescaped(made("man"));
    for (const std::string& verb : verbs) {
        EXPECT_THAT(program, HasSubstr("\\fB" + verb + "\\fR")) << verb;
        const std::string page = unescaped(made("man " + verb));
        const std::string help = run_burl(scratch, verb + " --help").out;
        std::size_t options = 0;
        for (const std::string& word : words_of(help.substr(help.find("Options:")))) {
            if (!word.starts_with("--") || word.size() < 4 || word.find('=') != std::string::npos)
                continue;
            EXPECT_THAT(page, HasSubstr(word.substr(0, word.find_first_of(":;)'"))))
                << verb << ' ' << word;
            ++options;
        }
        EXPECT_GT(options, 1u) << verb;
    }
}

TEST_F(Manual, TheRecipesPageHasAllParametersAndNodes) {
    const std::string page = unescaped(made("recipe"));
    for (const RecipeParameter& parameter : parameters())
        EXPECT_THAT(page, HasSubstr("\\fB" + std::string(parameter.path) + "\\fR"));
    for (const NodeType& type : graph_table())
        EXPECT_THAT(page, HasSubstr("\\fB" + std::string(type.name) + "\\fR"));
}

/// No line of text is taken for a request of roff's.
TEST_F(Manual, RequestsAreThoseOfManualPages) {
    for (const char* what : {"man", "man bake", "recipe"}) {
        const std::string page = made(what);
        for (std::size_t at = 0; at < page.size(); at = page.find('\n', at) + 1) {
            EXPECT_NE(page[at], '\'') << what;
            if (page[at] != '.') continue;
            const std::string request = page.substr(at, page.find_first_of(" \n", at) - at);
            EXPECT_THAT((std::vector<std::string>{".TH", ".SH", ".TP", ".BR", ".IR", ".B"}),
                        Contains(request))
                << what;
        }
    }
}

TEST_F(Manual, BashOffersVerbsOptionsChoicesAndRecipes) {
    EXPECT_THAT(offered("burl ba"), ElementsAre("bake", "batch"));
    EXPECT_THAT(offered("burl bake --atl"), IsSupersetOf({"--atlas", "--atlas-per"}));
    EXPECT_THAT(offered("burl bake -a ''"),
                ElementsAre("uniform", "area", "length", "quad", "patch", "chart", "uv"));
    EXPECT_THAT(offered("burl render --light st"), IsEmpty());  // a name or a file
    EXPECT_THAT(offered("burl bake --recipe oa"), ElementsAre("oak"));
    EXPECT_THAT(offered("burl list re"), IsEmpty());  // a positional is left to files
    EXPECT_THAT(offered("burl show --atlas"), IsEmpty());
}

TEST_F(Manual, OtherShellsGetTheSameOptions) {
    const std::string zsh = made("zsh"), fish = made("fish");
    EXPECT_TRUE(zsh.starts_with("#compdef burl\n"));
    for (const char* line : {"'--atlas-per[", "(uniform area length quad patch chart uv)"})
        EXPECT_THAT(zsh, HasSubstr(line));
    EXPECT_THAT(fish, HasSubstr("-n '__fish_seen_subcommand_from bake' -s o -l output -r -d"));
}

TEST_F(Manual, AVerbThatIsNoneIsToldSo) {
    const auto ran = run_burl(scratch, "manual man bakery");
    EXPECT_EQ(ran.exit_code, 1);
    EXPECT_THAT(ran.err, HasSubstr("there is no verb 'bakery'"));
}

TEST_F(Manual, PagesOfTheWholeProgramTakeNoVerb) {
    for (const char* what : {"bash bake", "recipe bake", "verbs bake"}) {
        const auto ran = run_burl(scratch, std::string("manual ") + what);
        EXPECT_EQ(ran.exit_code, 1) << what;
        EXPECT_THAT(ran.err, HasSubstr("is of the whole program; leave \"bake\" out"));
        EXPECT_EQ(ran.out, "");
    }
}

}  // namespace
}  // namespace burl
