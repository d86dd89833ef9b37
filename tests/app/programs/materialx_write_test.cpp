// MaterialX documents from outside: which files a bake writes, what it says, and what is refused.
#include <set>

#include "tests/app/programs/run_program.h"
#include "tests/app/support/xml_elements.h"

namespace burl::test {
namespace {

std::set<std::string> files_of(const Scratch& scratch) {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(scratch.path()))
        names.insert(entry.path().filename().string());
    return names;
}

TEST(MaterialXBake, WritesTheDocumentBesideTheObjAndItsPictures) {
    const Scratch scratch;
    const Outcome outcome =
        run_burl(scratch, fmt::format("bake sample:cube -o '{}' --recipe rust --size 64 --quiet",
                                      scratch / "a.mtlx"));
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_NE(outcome.err.find("occlusion"), std::string::npos) << outcome.err;
    EXPECT_EQ(files_of(scratch),
              (std::set<std::string>{"a.mtl", "a.mtlx", "a.mtlx.burl.json", "a.obj", "a.png",
                                     "a_metallic.png", "a_normal.png", "a_occlusion.png",
                                     "a_roughness.png"}));
    const std::string text = slurp(scratch / "a.mtlx");
    expect_whole_document(text);
    std::set<std::string> named;
    for (const FoundElement& one : xml_elements(text))
        if (one["type"] == "filename") named.insert(one["value"]);
    EXPECT_EQ(named, (std::set<std::string>{"a.png", "a_metallic.png", "a_normal.png",
                                            "a_occlusion.png", "a_roughness.png"}));
    // The scene is that of an .obj, byte for byte but for its names.
    run_burl(scratch, fmt::format("bake sample:cube -o '{}' --recipe rust --size 64 --quiet",
                                  scratch / "b.obj"));
    EXPECT_EQ(slurp(scratch / "a.png"), slurp(scratch / "b.png"));
}

TEST(MaterialXBake, RefusesInOneSentence) {
    const Scratch scratch;
    struct Bad {
        const char *options, *says;
    };
    for (const Bad& bad :
         {Bad{"--picture-format webp", "png and jpeg"},
          Bad{"--picture-format ktx2", "png and jpeg"},
          Bad{"--recipe rust --pack unreal", "leave --pack out"},
          Bad{"--recipe hammered --normal-y -", "points up"},
          Bad{"--vertex-colors", "--vertex-colors"}, Bad{"--atlas uv --udim", "--udim"}}) {
        const Outcome outcome = run_burl(
            scratch, fmt::format("bake sample:cube -o '{}' {}", scratch / "a.mtlx", bad.options));
        EXPECT_EQ(outcome.exit_code, 1) << bad.options;
        expect_one_sentence(outcome.err);
        EXPECT_NE(outcome.err.find(bad.says), std::string::npos) << outcome.err;
    }
    EXPECT_EQ(scratch.files(), 0u);
}

TEST(MaterialXShow, PrintsADocumentOrNamesWhatHasNoEquivalent) {
    const Scratch scratch;
    const Outcome checks = run_burl(scratch, "show checks --materialx");
    EXPECT_EQ(checks.exit_code, 0) << checks.err;
    expect_whole_document(checks.out);
    EXPECT_EQ(run_burl(scratch, "show checks --materialx").out, checks.out);
    const Outcome oak = run_burl(scratch, "show oak --materialx");
    EXPECT_EQ(oak.exit_code, 5);
    EXPECT_EQ(oak.out, "");
    expect_one_sentence(oak.err);
    EXPECT_NE(oak.err.find("define.pores.input.a.a (fibre)"), std::string::npos) << oak.err;
}

}  // namespace
}  // namespace burl::test
