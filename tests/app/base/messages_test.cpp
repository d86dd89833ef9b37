// What reaches a terminal: nothing that it would obey, whoever wrote the file it comes from.
#include "app/base/messages.h"

#include "tests/app/programs/run_program.h"

namespace burl::test {
namespace {

TEST(PrintableText, ShowsWhatTerminalsObey) {
    EXPECT_EQ(printable("\x1b[31mred\x1b[0m"), "\\x1b[31mred\\x1b[0m");
    EXPECT_EQ(printable("a\tb\nc\rd"), "a\\x09b\\x0ac\\x0dd");
    EXPECT_EQ(printable(std::string_view("\0\x07\x7f", 3)), "\\x00\\x07\\x7f");
    EXPECT_EQ(printable("\u0080\u009b31m\u009f"), "\\x80\\x9b31m\\x9f");
}

TEST(PrintableText, LeavesOtherTextAlone) {
    for (const char* text : {"", "plain ~ text \\x1b", "\u00a0\u00e4\u00df", "\u2013 \u65e5\u672c",
                             "\U0001f600", "\uffff", "\U0010ffff", "\ud7ff\ue000"})
        EXPECT_EQ(printable(text), text);
}

TEST(PrintableText, ShowsBytesThatAreNoUtf8) {
    EXPECT_EQ(printable("caf\xe9"), "caf\\xe9");
    EXPECT_EQ(printable("\x9b\x31m"), "\\x9b1m");
    EXPECT_EQ(printable("\xc1\x9b"), "\\xc1\\x9b");                    // longer than needed
    EXPECT_EQ(printable("\xe0\x82\x9b"), "\\xe0\\x82\\x9b");           // the same
    EXPECT_EQ(printable("\xf0\x80\x82\x9b"), "\\xf0\\x80\\x82\\x9b");  // the same
    EXPECT_EQ(printable("\xed\xa0\x80"), "\\xed\\xa0\\x80");           // half a pair
    EXPECT_EQ(printable("\xf4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80");  // beyond the last
    EXPECT_EQ(printable("\xe2\x80"), "\\xe2\\x80");                    // cut off
}

TEST(TerminalEscapes, OfFilesAreShownAndNotObeyed) {
    const Scratch scratch;
    const std::string points = scratch.write("p.csv", "0,0,0\n");
    const auto copy = [&](const char* name) {
        fs::copy_file(case_file(name), scratch / name);
        return fmt::format("'{}'", scratch / name);
    };
    const struct {
        std::string arguments;
        const char* shown;
        int exit_code;
    } cases[] = {
        {fmt::format("eval {} --points '{}'", copy("e1.json"), points), "\\x1b[31mRED.png", 2},
        {fmt::format("batch {}", copy("e4.json")), "\\x1b]0;title\\x07x.png", 2},
        {fmt::format("metrics {}", copy("e9.gltf")), "\\x1b[31mX", 2},
        {fmt::format("bake {} -s 64 --pose no-such -o '{}'", copy("e11.glb"), scratch / "o.glb"),
         "\\x1b[31mwalk@0.5", 1},
    };
    for (const auto& one : cases) {
        const Outcome outcome = run_burl(scratch, one.arguments);
        EXPECT_EQ(outcome.exit_code, one.exit_code) << one.arguments;
        EXPECT_NE(outcome.err.find(one.shown), std::string::npos) << outcome.err;
        for (const char obeyed : {'\x1b', '\x07'})
            EXPECT_EQ((outcome.out + outcome.err).find(obeyed), std::string::npos) << one.arguments;
    }
    // The line of a bake on stdout, too.
    scratch.write("\x1b[31mx.obj", "v 0 0 0\n");
    const Outcome batch = run_burl(scratch, fmt::format("batch '{}'", scratch / "e4.json"));
    EXPECT_NE(batch.out.find("\\x1b]0;title\\x07x.png: failed"), std::string::npos) << batch.out;
}

TEST(QuotedWords, OfMeshesAndTablesKeepTheirLetters) {
    const Scratch scratch;
    const std::string mesh =
        scratch.write("k.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl K\u00e4\x1bse\xe9\nf 1 2 3\n");
    const std::string points = scratch.write("p.csv", "0,0,0\nK\u00e4\x1bse\xe9,0,0\n");
    for (const std::string& arguments :
         {fmt::format("bake '{}' --material Brot -o '{}'", mesh, scratch / "a.png"),
          fmt::format("eval marble --points '{}'", points)}) {
        const Outcome outcome = run_burl(scratch, arguments);
        EXPECT_NE(outcome.err.find("K\u00e4?se?"), std::string::npos) << outcome.err;
    }
}

TEST(Messages, ManyNamesAreCountedAfterTheFirst) {
    const auto joined = [](const std::vector<std::string>& names) { return names_together(names); };
    EXPECT_EQ(joined({}), "");
    EXPECT_EQ(joined({"a"}), "a");
    EXPECT_EQ(joined({"a", "b"}), "a and b");
    EXPECT_EQ(joined({"a", "b", "c", "d"}), "a, b, c and d");
    EXPECT_EQ(joined({"a", "b", "c", "d", "e", "f"}), "a, b, c, d and 2 more");
}

}  // namespace
}  // namespace burl::test
