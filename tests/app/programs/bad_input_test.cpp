// Every kind of bad input: one sentence on stderr, the documented exit code, and no file left
// behind.
#include <unistd.h>

#include "tests/app/programs/run_program.h"
#include "tests/paths.h"

namespace burl::test {
namespace {

const char* const bad_input_square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
const char* const ply_head =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
    "z\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n";
const char* const absurd_ply =
    "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\nproperty float x\nproperty "
    "float y\n"
    "property float z\nend_header\n";

struct BadCase {
    const char* name;
    const char* file;
    const char* content;
    const char* options;
    int exit_code;
    const char* says;  ///< a part of the sentence
};

void PrintTo(const BadCase& bad, std::ostream* out) {
    *out << bad.name;
}

class BadInput : public testing::TestWithParam<BadCase> {};

TEST_P(BadInput, OneSentenceAndNoOutput) {
    const BadCase& bad = GetParam();
    const Scratch scratch;
    const std::string mesh = scratch.write(bad.file, bad.content);
    const Outcome outcome = run_burl(
        scratch, fmt::format("bake '{}' -o '{}' {}", mesh, scratch / "out.glb", bad.options));
    EXPECT_EQ(outcome.exit_code, bad.exit_code) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    expect_one_sentence(outcome.err);
    EXPECT_NE(outcome.err.find(bad.says), std::string::npos) << outcome.err;
    EXPECT_EQ(scratch.files(), 1u);
}

INSTANTIATE_TEST_SUITE_P(
    Program, BadInput,
    testing::Values(
        BadCase{"Empty", "m.obj", "", "", 3, "m.obj"},
        BadCase{"EmptyGlb", "m.glb", "", "", 3, "m.glb"},
        BadCase{"NoFaces", "m.obj", "v 0 0 0\n", "", 3, "face"},
        BadCase{"Nan", "m.obj", "v 0 0 0\nv nan 0 0\nv 1 1 0\nf 1 2 3\n", "", 3, "m.obj:2:"},
        BadCase{"Infinite", "m.obj", "v 0 0 0\nv 1 inf 0\nv 1 1 0\nf 1 2 3\n", "", 3, "m.obj:2:"},
        BadCase{"Overflow", "m.obj", "v 0 0 0\nv 1 1e999 0\nv 1 1 0\nf 1 2 3\n", "", 3, "m.obj:2:"},
        BadCase{"IndexTooHigh", "m.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 4\n", "", 3, "m.obj:4:"},
        BadCase{"IndexZero", "m.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 0 1 2\n", "", 3, "m.obj:4:"},
        BadCase{"TruncatedPly", "m.ply", ply_head, "", 3, "m.ply"},
        BadCase{"AbsurdPly", "m.ply", absurd_ply, "", 3, "m.ply"},
        BadCase{"UnknownMeshExtension", "m.xyz", "0 0 0\n", "", 5, "xyz"},
        BadCase{"SizeZero", "m.obj", bad_input_square, "--size 0", 1, "size"},
        BadCase{"SizeHuge", "m.obj", bad_input_square, "--size 100000", 1, "size"},
        BadCase{"SizeNoNumber", "m.obj", bad_input_square, "--size 0x0", 1, "size"},
        BadCase{"SizeTooSmall", "m.obj", bad_input_square, "--size 1 --atlas area", 4, "--size"},
        BadCase{"UnknownAtlas", "m.obj", bad_input_square, "--atlas aria", 1, "area"},
        BadCase{"UnknownPreset", "m.obj", bad_input_square, "--recipe marbel", 1, "marble"},
        BadCase{"UnknownKey", "m.obj", bad_input_square, "--set texture.input.nose.0.gain=1", 1,
                "noise"},
        BadCase{"UnknownOption", "m.obj", bad_input_square, "--sise 64", 1, "--sise"},
        BadCase{"NanCrease", "m.obj", bad_input_square, "--crease nan", 1, "--crease"},
        BadCase{"NanWeld", "m.obj", bad_input_square, "--weld nan", 1, "--weld"},
        BadCase{"EmptySize", "m.obj", bad_input_square, "--size ''", 1, "size"},
        BadCase{"EmptyAtlas", "m.obj", bad_input_square, "--atlas ''", 1, "atlas"},
        BadCase{"ReportInNoFolder", "m.obj", bad_input_square, "--report /no/where.json", 2, "/no"},
        BadCase{"NanParameter", "m.obj", bad_input_square, "--set solid.scale=nan", 1, "scale"}),
    [](const auto& bad) { return bad.param.name; });

struct RefusedCase {
    const char* name;
    const char* arguments;  ///< FOLDER/ stands for that of the cases, OUT/ for the test's own
    int exit_code;
    const char* says;
};

void PrintTo(const RefusedCase& refused, std::ostream* out) {
    *out << refused.name;
}

class RefusedInput : public testing::TestWithParam<RefusedCase> {};

TEST_P(RefusedInput, OneSentenceAndNoOutput) {
    const RefusedCase& refused = GetParam();
    const Scratch scratch;
    std::string arguments = refused.arguments;
    const auto replace = [&](const std::string& word, const std::string& path) {
        for (std::size_t at = 0; (at = arguments.find(word, at)) != std::string::npos;)
            arguments.replace(at, word.size(), path);
    };
    replace("FOLDER/", case_file(""));
    replace("OUT/", scratch / "");
    const Outcome outcome = run_burl(scratch, arguments);
    EXPECT_EQ(outcome.exit_code, refused.exit_code) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    expect_one_sentence(outcome.err);
    EXPECT_NE(outcome.err.find(refused.says), std::string::npos) << outcome.err;
    EXPECT_EQ(scratch.files(), 0u);
}

INSTANTIATE_TEST_SUITE_P(
    CommandLine, RefusedInput,
    testing::Values(
        RefusedCase{"ListOfNothing", "list", 1, "list what? recipes, materials,"},
        RefusedCase{"ListOfWhatThereIsNot", "list foo", 1, "foo is none of recipes, materials,"},
        RefusedCase{"NoValue", "bake sample:cube -o OUT/a.glb --size", 1, "--size needs a value"},
        RefusedCase{"OneDash", "bake sample:cube -o OUT/a.glb -size 64", 1,
                    "-size has two dashes: --size"},
        RefusedCase{"TwoValues", "bake sample:cube -o OUT/a.glb --size 8 --size 9", 1,
                    "--size is given more than once"},
        RefusedCase{"TwoMeshes", "bake sample:cube a.obj -o OUT/a.glb", 1,
                    "nothing takes \"a.obj\"; lists have commas without spaces, and burl batch"},
        RefusedCase{"OptionOfAnotherVerb", "bake sample:cube -o OUT/a.glb --light sun", 1,
                    "--light is no option of burl bake, but of burl render"},
        RefusedCase{"NoOutputs", "batch sample:cube -r oak", 1, "batch: --output is required"},
        RefusedCase{"TwoManifests", "batch a.json b.json -o OUT/a.glb", 1,
                    "a.json is a manifest, which stands alone"},
        RefusedCase{"NoName", "bake sample:cube -o ''", 1, "the output's name is empty"},
        RefusedCase{"AFolderAsMesh", "bake FOLDER/ -o OUT/a.glb", 2, "is a folder, not a file"},
        RefusedCase{"AFolderAsOutput", "bake sample:cube -o OUT/", 2, "is a folder, not a file"},
        RefusedCase{"AFolderAsRecipe", "bake sample:cube -o OUT/a.glb -r FOLDER/", 2,
                    "is a folder"}),
    [](const auto& test) { return std::string(test.param.name); });

INSTANTIATE_TEST_SUITE_P(
    Program, RefusedInput,
    testing::Values(
        RefusedCase{"MetricsOfNoScene", "metrics FOLDER/scene-out-of-range.gltf", 3, "glTF.scene"},
        RefusedCase{"BakeOfNoScene", "bake FOLDER/scene-out-of-range.gltf -o OUT/a.glb", 3,
                    "glTF.scene"},
        RefusedCase{"RenderOfNoScene", "render FOLDER/scene-out-of-range.gltf -o OUT/a.png", 3,
                    "glTF.scene"},
        RefusedCase{"RenderOfASample", "render sample:teapot -o OUT/a.png", 1,
                    "sample:teapot is a mesh, not a baked scene; add --lazy or --direct"},
        RefusedCase{"PointsWithoutData", "metrics FOLDER/mb1.gltf", 3, "16777216 elements"},
        RefusedCase{"ManyUsesOfOneAccessor", "metrics FOLDER/mb2.gltf", 3, "elements"},
        RefusedCase{"UnknownPoseOfKeysWithoutData",
                    "bake FOLDER/samplers.gltf --pose no -o OUT/a.glb", 3, "elements"},
        RefusedCase{"InstanceTooFarOut", "bake FOLDER/i2.gltf -o OUT/a.glb", 3, "nodes[1]"},
        RefusedCase{"BumpThatIsNoObject",
                    "bake sample:cube --recipe FOLDER/bump-no-object.json --size 16 -o OUT/a.png",
                    3, "bump must be an object"},
        RefusedCase{"PoseTooFarForFloats",
                    "bake FOLDER/tri.obj --pose FOLDER/huge.obj --size 64 -o OUT/a.glb", 5,
                    "the pose \"huge\" moves points"},
        RefusedCase{"PoseTooFarForFloatsInText",
                    "bake FOLDER/tri.obj --pose FOLDER/huge.obj --size 64 -o OUT/a.gltf", 5,
                    "write an .obj"}),
    [](const auto& refused) { return refused.param.name; });

TEST(Program, DirectoriesMissingFilesAndUnknownExtensions) {
    const Scratch scratch;
    const std::string mesh = scratch.write("m.obj", bad_input_square), out = scratch / "o.glb";
    fs::create_directory(scratch / "folder.obj");
    const struct {
        std::string mesh, out;
        int exit_code;
    } cases[] = {{scratch / "folder.obj", out, 2},
                 {scratch / "absent.obj", out, 2},
                 {mesh, scratch / "o.tiff", 1},
                 {mesh, scratch / "no/such/o.glb", 2}};
    for (const auto& bad : cases) {
        const Outcome outcome =
            run_burl(scratch, fmt::format("bake '{}' -o '{}' --size 64", bad.mesh, bad.out));
        EXPECT_EQ(outcome.exit_code, bad.exit_code) << bad.mesh << "\n" << outcome.err;
        expect_one_sentence(outcome.err);
        EXPECT_EQ(scratch.files(), 2u) << bad.mesh;
    }
}

TEST(Program, WrongVerbsAreNamedAndTheRightHelpIsOffered) {
    const Scratch scratch;
    const Outcome verb = run_burl(scratch, "bak");
    EXPECT_EQ(verb.exit_code, 1);
    expect_one_sentence(verb.err);
    EXPECT_NE(verb.err.find("'bak'"), std::string::npos) << verb.err;
    EXPECT_NE(verb.err.find("bake, render"), std::string::npos) << verb.err;
    EXPECT_NE(run_burl(scratch, "bake").err.find("`burl bake --help`"), std::string::npos);
    EXPECT_NE(run_burl(scratch, "").err.find("verb"), std::string::npos);
}

TEST(Program, PicturesAndReportsNeverReplaceWhatTheCommandNeeds) {
    const Scratch scratch;
    const std::string mesh = scratch.write("m.obj", bad_input_square);
    const auto refused = [&](const std::string& arguments, int code) {
        const Outcome outcome = run_burl(scratch, arguments);
        EXPECT_EQ(outcome.exit_code, code) << arguments;
        expect_one_sentence(outcome.err);
    };
    refused(fmt::format("bake '{0}' -o '{1}.glb' --size 64 --report '{0}'", mesh, scratch / "a"),
            2);
    refused(
        fmt::format("bake '{0}' -o '{1}.glb' --size 64 --report '{1}.glb'", mesh, scratch / "a"),
        2);
    EXPECT_EQ(slurp(mesh), bad_input_square);
    EXPECT_FALSE(fs::exists(scratch / "a.glb"));
    for (const char* name : {"b.gltf", "c.obj"}) {
        const std::string scene = scratch / name;
        ASSERT_EQ(
            run_burl(scratch, fmt::format("bake '{}' -o '{}' --size 64", mesh, scene)).exit_code,
            0);
        const std::string texture = fs::path(scene).replace_extension(".png").string();
        const std::string before = slurp(texture);
        refused(fmt::format("render '{}' -o '{}' --size 8x8", scene, texture), 2);
        refused(fmt::format("diff '{0}' '{0}' -o '{0}'", texture), 2);
        EXPECT_EQ(slurp(texture), before);
        refused(fmt::format("render '{}' -o '{}.jpg' --size 8x8", scene, scene), 1);
    }
}

TEST(Program, ClosedAndFullStandardStreams) {
    const Scratch scratch;
    const std::string mesh = scratch.write("m.obj", bad_input_square + std::string("v 9 9 9\n"));
    const std::string burl = fmt::format("'{}/bin/burl'", test::binary_folder());
    const auto status = [&](const std::string& arguments) {
        return WEXITSTATUS(std::system((burl + " " + arguments).c_str()));
    };
    const std::string bake = fmt::format("bake '{}' --size 64 -o '{}", mesh, scratch / "");
    EXPECT_EQ(status(bake + "open.glb' >/dev/null 2>&1"), 0);
    EXPECT_EQ(status(bake + "shut.glb' <&- >&- 2>&-"), 0);
    EXPECT_EQ(slurp(scratch / "shut.glb"), slurp(scratch / "open.glb"));
    EXPECT_EQ(status("bake /no/mesh.obj -o x.glb 2>&-"), 2);
    EXPECT_EQ(status("bake /no/mesh.obj -o x.glb 2>/dev/full"), 2);
    EXPECT_EQ(status("list recipes >/dev/full 2>/dev/null"), 2);
}

TEST(Program, UnknownRecipeKeyNamesTheNearest) {
    const Scratch scratch;
    const std::string mesh = scratch.write("m.obj", bad_input_square), out = scratch / "o.glb";
    const std::string recipe = scratch.write("r.json", R"({"burl": 1, "solids": {"scale": 2}})");
    const Outcome outcome =
        run_burl(scratch, fmt::format("bake '{}' -o '{}' --recipe '{}'", mesh, out, recipe));
    EXPECT_EQ(outcome.exit_code, 3);
    expect_one_sentence(outcome.err);
    EXPECT_NE(outcome.err.find("solids"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("\"solid\""), std::string::npos) << outcome.err;
}

/// Shell text that gives up root's right to read and write everything; empty when there is nothing
/// to give up.
std::string as_nobody() {
    return geteuid() == 0 ? "setpriv --reuid=65534 --regid=65534 --clear-groups" : "";
}

TEST(Program, NoPermission) {
    const Scratch scratch;
    const std::string mesh = scratch.write("m.obj", bad_input_square), locked = scratch / "locked";
    if (run_burl(scratch, "--version", as_nobody()).exit_code != 0) {
        GTEST_SKIP() << "cannot run the program as an ordinary user here";
    }
    fs::create_directory(locked);
    fs::permissions(locked, fs::perms::owner_read | fs::perms::owner_exec);
    fs::permissions(scratch.path(), fs::perms::all);
    const Outcome unwritable =
        run_burl(scratch, fmt::format("bake '{}' -o '{}/o.glb'", mesh, locked), as_nobody());
    EXPECT_EQ(unwritable.exit_code, 2);
    expect_one_sentence(unwritable.err);
    fs::permissions(mesh, fs::perms::none);
    const Outcome unreadable =
        run_burl(scratch, fmt::format("bake '{}' -o '{}'", mesh, scratch / "o.glb"), as_nobody());
    EXPECT_EQ(unreadable.exit_code, 2);
    expect_one_sentence(unreadable.err);
    EXPECT_NE(unreadable.err.find("ermission"), std::string::npos) << unreadable.err;
    EXPECT_EQ(scratch.files(), 2u);
}

TEST(Program, FileSizeLimitLeavesNothingBehind) {
    const Scratch scratch;
    const std::string mesh = scratch.write("m.obj", bad_input_square), out = scratch / "o.glb";
    const Outcome outcome =
        run_burl(scratch, fmt::format("bake '{}' -o '{}' --size 512", mesh, out), "ulimit -f 16;");
    EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
    expect_one_sentence(outcome.err);
    EXPECT_EQ(scratch.files(), 1u);
}

// What fits would be left alone without what does not: the texture without its normal map or its
// solid map.
TEST(Program, FileSizeLimitLeavesNothingOfAGroupBehind) {
    const Scratch scratch;
    const std::string recipe = scratch.write("flat.json", R"({
        "texture": {"node": "constant", "value": "#804020"},
        "bump": {"height": 0.05, "input": {"node": "wrinkled", "octaves": 6}}})");
    for (const char* const options : {"-o b.exr", "-o b.png --normals none --solid-map m.exr"}) {
        const std::string in_folder = fmt::format("cd '{}'; ulimit -f 8;", scratch.path().string());
        const Outcome outcome = run_burl(
            scratch, fmt::format("bake sample:cube -r '{}' -s 128 {}", recipe, options), in_folder);
        EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
        expect_one_sentence(outcome.err);
        EXPECT_EQ(scratch.files(), 1u) << options;
    }
}

TEST(Program, FullDiskLeavesNothingBehind) {
    const Scratch scratch;
    const std::string mesh = scratch.write("m.obj", bad_input_square), disk = scratch / "disk";
    fs::create_directory(disk);
    if (std::system(
            fmt::format("mount -t tmpfs -o size=64k none '{}' 2>/dev/null", disk).c_str()) != 0) {
        GTEST_SKIP() << "cannot mount a small tmpfs here (needs root)";
    }
    const Outcome outcome =
        run_burl(scratch, fmt::format("bake '{}' -o '{}/o.glb' --size 512", mesh, disk));
    const bool empty = fs::is_empty(disk);
    EXPECT_EQ(std::system(fmt::format("umount '{}'", disk).c_str()), 0);
    EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
    expect_one_sentence(outcome.err);
    EXPECT_TRUE(empty);
}

}  // namespace
}  // namespace burl::test
