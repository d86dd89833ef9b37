// Files that a file names, from outside: none is read or written that lies out of its folder, by
// name or by a symbolic link, unless --allow-outside is given.
#include <string>

#include "app/image/image_io.h"
#include "atlas/base/json.h"
#include "atlas/base/named_files.h"
#include "tests/app/programs/run_program.h"

namespace burl::test {
namespace {

using Json = nlohmann::json;

/// A folder "in" of files that name others beside it, in the folder "out".
class Confined : public testing::Test {
  protected:
    Confined() {
        fs::create_directories(scratch_.path() / "in");
        fs::create_directories(scratch_.path() / "out");
        write_png(scratch_ / "out/red.png", Image<Rgb8>(8, 8, {200, 10, 10}));
        fs::create_symlink("../out/red.png", scratch_ / "in/link.png");
    }
    /// Runs burl in the folder "in".
    Outcome run(const std::string& arguments) const {
        return run_program(scratch_, "burl", arguments, fmt::format("cd '{}';", scratch_ / "in"));
    }
    /// Expects the sentence and code 3 without --allow-outside, and success with it.
    void expect_confined(const std::string& arguments) const {
        SCOPED_TRACE(arguments);
        const Outcome refused = run(arguments);
        EXPECT_EQ(refused.exit_code, 3) << refused.err;
        EXPECT_NE(refused.err.find(outside_rule), std::string::npos) << refused.err;
        const Outcome allowed = run(arguments + " --allow-outside");
        EXPECT_EQ(allowed.exit_code, 0) << allowed.err;
    }

    Scratch scratch_;
};

TEST_F(Confined, ImagesOfRecipes) {
    for (const std::string file :
         {"../out/red.png", "link.png", "../in/../out/red.png", "/red.png"}) {
        const std::string whole = file == "/red.png" ? scratch_ / "out/red.png" : file;
        const Json recipe{{"burl", 1}, {"texture", {{"node", "image"}, {"file", whole}}}};
        scratch_.write("in/r.json", recipe.dump());
        expect_confined("bake sample:cube -r r.json -s 16 -o a.png --force");
        expect_confined("render --direct sample:cube -r r.json --size 16x16 -o b.png");
        expect_confined("metrics sample:cube -r r.json -a quad -s 16");
        expect_confined("show r.json");
        expect_confined("bench synthesis -r r.json --size 8 --repeats 1");
    }
    write_png(scratch_ / "in/own.png", Image<Rgb8>(8, 8, {10, 200, 10}));
    fs::create_symlink("own.png", scratch_ / "in/inner.png");
    scratch_.write("in/r.json",
                   R"({"burl": 1, "texture": {"node": "image", "file": "inner.png"}})");
    EXPECT_EQ(run("bake sample:cube -r r.json -s 16 -o a.png").exit_code, 0);
    EXPECT_EQ(run("bake sample:cube -r ../in/r.json -s 16 -o a.png --force").exit_code, 0);
}

TEST_F(Confined, BuffersOfAGltf) {
    ASSERT_EQ(run("bake sample:cube -s 16 -o ../out/c.gltf").exit_code, 0);
    Json gltf = Json::parse(slurp(scratch_ / "out/c.gltf"));
    for (const std::string uri : {"../out/c.bin", "c.bin"}) {
        gltf["buffers"][0]["uri"] = uri;
        scratch_.write("in/c.gltf", gltf.dump());
        fs::remove(scratch_ / "in/c.bin");
        fs::create_symlink("../out/c.bin", scratch_ / "in/c.bin");
        for (const char* out : {"d.glb", "d.png"}) {
            const std::string command = fmt::format("bake c.gltf -s 16 --force -o {}", out);
            EXPECT_EQ(run(command).exit_code, 3);
            const Outcome allowed = run(command + " --allow-outside");
            EXPECT_EQ(allowed.exit_code, 0) << allowed.err;
        }
        EXPECT_EQ(run("render c.gltf --size 16x16 -o e.png").exit_code, 3);
        EXPECT_EQ(run("metrics c.gltf").exit_code, 3);
        EXPECT_EQ(run("metrics c.gltf --allow-outside").exit_code, 0);
    }
}

TEST_F(Confined, PicturesAndMaterialsOfScenes) {
    ASSERT_EQ(run("bake sample:cube -s 16 -o a.obj").exit_code, 0);
    const std::string library = slurp(scratch_ / "in/a.mtl");
    for (const std::string map : {"../out/red.png", "link.png"}) {
        std::string changed = library;
        changed.replace(changed.find("map_Kd ") + 7, 5, map);
        scratch_.write("in/a.mtl", changed);
        expect_confined("render a.obj --size 16x16 -o b.png");
    }
    // Without its materials an OBJ is still drawn.
    scratch_.write("out/a.mtl", library);
    fs::remove(scratch_ / "in/a.mtl");
    fs::create_symlink("../out/a.mtl", scratch_ / "in/a.mtl");
    const Outcome drawn = run("render a.obj --size 16x16 -o b.png");
    EXPECT_EQ(drawn.exit_code, 0);
    EXPECT_NE(drawn.err.find(outside_rule), std::string::npos) << drawn.err;
}

TEST_F(Confined, TexturesOfAGltf) {
    ASSERT_EQ(run("bake sample:cube -s 16 -o c.gltf").exit_code, 0);
    Json gltf = Json::parse(slurp(scratch_ / "in/c.gltf"));
    for (const auto& [uri, code] : {std::pair{"../out/red.png", 3},
                                    {"%2e%2e/out/red.png", 3},
                                    {"link.png", 3},
                                    {"none.png", 2}}) {
        gltf["images"][0]["uri"] = uri;
        scratch_.write("in/c.gltf", gltf.dump());
        const Outcome drawn = run("render c.gltf --size 16x16 -o b.png");
        EXPECT_EQ(drawn.exit_code, code) << uri << drawn.err;
        EXPECT_NE(drawn.err.find("the texture"), std::string::npos) << drawn.err;
    }
}

TEST_F(Confined, PathsOfManifests) {
    ASSERT_EQ(run("bake sample:cube -s 16 -o ../out/cube.obj").exit_code, 0);
    scratch_.write("out/r.json", R"({"burl": 1})");
    const Json whole{{"mesh", "sample:cube"}, {"size", 16}, {"output", "a.glb"}};
    for (const auto& [key, value] : {std::pair{"mesh", "../out/cube.obj"},
                                     {"mesh", "../out/*.obj"},
                                     {"recipe", "../out/r.json"},
                                     {"output", "../out/new.png"},
                                     {"solid-map", "../out/s.exr"}}) {
        Json bake = whole;
        bake[key] = value;
        scratch_.write("in/m.json", Json{{"bakes", Json::array({bake})}}.dump());
        expect_confined("batch m.json --force");
    }
    // What a command line says is the caller's own.
    EXPECT_EQ(run("batch ../out/cube.obj -s 16 -o ../out/again.png").exit_code, 0);
}

TEST_F(Confined, FilesNamedAfterOutputsOfManifests) {
    scratch_.write("out/old", "precious");
    for (const auto& [link, output, more] :
         {std::tuple{"x.mtl", "x.obj", Json::object()},
          {"x.png", "x.obj", Json::object()},
          {"x.png", "x.png", Json::object()},
          {"x.png.burl.json", "x.png", Json::object()},
          {"x.1.png", "x.png", Json{{"levels", "all"}}},
          {"x.0002.png", "x.png", Json{{"animate", "solid.scale=1:2"}, {"frames", 2}}}})
        for (const char* end : {"../out/old", "../out/new"}) {
            const std::string in = scratch_ / fmt::format("in/{}", link);
            fs::create_symlink(end, in);
            Json bake{{"mesh", "sample:cube"}, {"size", 16}, {"output", output}};
            bake.update(more);
            scratch_.write("in/m.json", Json{{"bakes", Json::array({bake})}}.dump());
            const Outcome outcome = run("batch m.json");
            EXPECT_EQ(outcome.exit_code, 3) << link << outcome.err;
            EXPECT_NE(outcome.err.find(outside_rule), std::string::npos) << outcome.err;
            EXPECT_EQ(slurp(scratch_ / "out/old"), "precious");
            EXPECT_FALSE(fs::exists(scratch_ / "out/new"));
            fs::remove(in);
        }
}

TEST(LiesBelow, FollowsLinksAndDots) {
    const Scratch scratch;
    fs::create_directories(scratch.path() / "a/b");
    fs::create_directories(scratch.path() / "ab");
    fs::create_symlink(scratch.path() / "ab", scratch.path() / "a/out");
    fs::create_symlink("b", scratch.path() / "a/in");
    fs::create_symlink("../new", scratch.path() / "a/new_out");
    fs::create_symlink("b/new", scratch.path() / "a/new_in");
    fs::create_symlink("loop", scratch.path() / "a/loop");
    const std::string file = scratch / "a/file";
    for (const char* name :
         {"x", "b/x", "in/x", "missing/x", "new_in", "b/../x", "./x", "b/../../a/x"})
        EXPECT_TRUE(lies_below(file, name)) << name;
    for (const char* name : {"../x", "out/x", "out", "new_out", "loop", "loop/../../x", "..", ".",
                             "../ab/x", "/etc/passwd", "in/../../x", "missing/../../x"})
        EXPECT_FALSE(lies_below(file, name)) << name;
    EXPECT_TRUE(lies_below(file, scratch / "a/b/x"));
    EXPECT_TRUE(lies_below("file", "x"));
    EXPECT_FALSE(lies_below("file", "../x"));
}

}  // namespace
}  // namespace burl::test
