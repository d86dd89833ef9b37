// Names of files that cannot be, or that others would not find: refused in a sentence that can be
// read, before anything is written.
#include "tests/app/programs/run_program.h"
#include "tests/paths.h"

namespace burl::test {
namespace {

struct NameCase {
    std::string arguments;
    int exit_code;
    const char* says;
};

void expect_refused(const Scratch& scratch, const NameCase& one) {
    SCOPED_TRACE(one.arguments.substr(0, 100));
    const Outcome outcome = run_burl(scratch, one.arguments);
    EXPECT_EQ(outcome.exit_code, one.exit_code) << outcome.err;
    EXPECT_NE(outcome.err.find(one.says), std::string::npos) << outcome.err;
    EXPECT_LT(outcome.err.size(), 1500u);
    EXPECT_EQ(scratch.files(), 0u);
}

std::string bake_to(const Scratch& scratch, const std::string& name) {
    return fmt::format("bake sample:cube --size 16 -o '{}'", scratch / name);
}

TEST(NamesOfOutputs, HaveRoomForTheirRecords) {
    const Scratch scratch;
    // The record has ten letters more: NAME.burl.json.
    for (const std::size_t letters : {242u, 251u, 300u})
        expect_refused(scratch, {bake_to(scratch, std::string(letters, 'a') + ".png"), 2,
                                 "give the output a shorter name"});
    const Outcome longest = run_burl(scratch, bake_to(scratch, std::string(241, 'a') + ".png"));
    EXPECT_EQ(longest.exit_code, 0) << longest.err;
    EXPECT_EQ(scratch.files(), 2u);
}

TEST(NamesOfOutputs, AreNamesThatOtherFilesCanHold) {
    const Scratch scratch;
    for (const char* name : {"a\\b.gltf", "a\nb.gltf", "a\\b.obj", "a\nb.obj", "a\rb.OBJ"})
        expect_refused(scratch, {bake_to(scratch, name), 1, "other programs do not find"});
    // One file alone may have such a name.
    for (const char* name : {"a\\b.glb", "a\nb.png"})
        EXPECT_EQ(run_burl(scratch, bake_to(scratch, name)).exit_code, 0) << name;
}

TEST(NamesInFiles, WithNullBytesAreRefused) {
    const Scratch scratch;
    expect_refused(scratch, {fmt::format("batch '{}'", case_file("nul-manifest.json")), 3,
                             "a text holds U+0000"});
}

TEST(NamesInFiles, OutsideOfTheFolderAreSaidToBeThere) {
    const Scratch scratch;
    expect_refused(scratch, {fmt::format("render '{}' -o '{}' --size 16x16",
                                         case_file("texture-outside.gltf"), scratch / "a.png"),
                             3, "may lead out of the file's folder"});
}

TEST(SentencesAboutNames, AreShortHoweverLongTheNameIs) {
    const Scratch scratch;
    const std::string name(20000, 'q');
    expect_refused(scratch, {fmt::format("{} --set {}=1", bake_to(scratch, "a.png"), name), 1,
                             "bytes left out"});
}

}  // namespace
}  // namespace burl::test
