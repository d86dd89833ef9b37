// A batch makes the files that single bakes make, shares what they have in common, and lets one bad
// bake fail alone.
#include "app/bake/batch_manifest.h"
#include "atlas/base/json.h"

#include "atlas/base/error.h"
#include "tests/app/programs/run_program.h"

namespace burl::test {
namespace {

const char* const batch_square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
const char* const roof = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv .5 .5 1\nf 1 2 5\nf 2 3 5\n";

class Batch : public testing::Test {
  protected:
    const Scratch scratch;

    Batch() {
        scratch.write("square.obj", batch_square);
        scratch.write("roof.obj", roof);
    }
    Outcome run(const std::string& manifest, const std::string& options = "") const {
        const std::string path = scratch.write("batch.json", manifest);
        return run_burl(scratch, fmt::format("batch '{}' {}", path, options));
    }
    std::vector<BatchEntry> entries(const std::string& manifest) const {
        return read_manifest(scratch.write("batch.json", manifest));
    }
};

constexpr const char* four = R"({
  "defaults": {"size": 64, "set": ["solid.scale=2"]},
  "bakes": [
    {"mesh": "square.obj", "recipe": "marble", "output": "a.png"},
    {"mesh": "roof.obj", "recipe": "wood", "output": "b.glb", "atlas": "quad"},
    {"mesh": "square.obj", "recipe": "wood", "output": "c.png", "size": 32},
    {"mesh": "square.obj", "recipe": "clouds", "output": "d.png", "depth": 16,
     "set": "texture.input.noise.0.amplitude=0.2"}
  ]
})";

TEST_F(Batch, WritesWhatSingleBakesWrite) {
    const Outcome outcome = run(four);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const std::string scale = "--set solid.scale=2";
    const struct {
        const char *made, *options;
    } single[] = {{"a.png", "square.obj -r marble --size 64"},
                  {"b.glb", "roof.obj -r wood --size 64 --atlas quad"},
                  {"c.png", "square.obj -r wood --size 32"},
                  {"d.png",
                   "square.obj -r clouds --size 64 --depth 16 "
                   "--set texture.input.noise.0.amplitude=0.2"}};
    for (const auto& [made, options] : single) {
        const std::string expected = scratch / fmt::format("single-{}", made);
        // Set after the defaults' edit, as in the manifest.
        const std::string command = fmt::format("bake '{}'/{} {} -o '{}'", scratch.path().string(),
                                                options, scale, expected);
        ASSERT_EQ(run_burl(scratch, command).exit_code, 0) << command;
        EXPECT_EQ(slurp(scratch / made), slurp(expected)) << made;
    }
}

TEST_F(Batch, WritesMasksBesideItsOutputs) {
    const Outcome outcome = run(R"({"defaults": {"size": 64}, "bakes": [
        {"mesh": "roof.obj", "output": "e.png", "channels": ["occlusion", "lighting"]},
        {"mesh": "roof.obj", "output": "f.png", "recipe": "wood", "channels": "occlusion"}]})");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const std::string single = scratch / "single.png";
    ASSERT_EQ(run_burl(scratch, fmt::format("bake '{}' --size 64 --channels occlusion,lighting "
                                            "-o '{}'",
                                            scratch / "roof.obj", single))
                  .exit_code,
              0);
    for (const char* made : {"e_occlusion.png", "f_occlusion.png"})
        EXPECT_EQ(slurp(scratch / made), slurp(scratch / "single_occlusion.png")) << made;
    EXPECT_EQ(slurp(scratch / "e_lighting.png"), slurp(scratch / "single_lighting.png"));
    EXPECT_FALSE(fs::exists(scratch / "f_lighting.png"));
}

TEST_F(Batch, SharesMeshAtlasAndPoints) {
    const Outcome outcome = run(four, "--json");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const auto report = nlohmann::json::parse(outcome.out);
    using Names = std::vector<std::string>;
    const auto shared = [&](std::size_t i) { return report["bakes"][i]["shared"].get<Names>(); };
    EXPECT_EQ(shared(0), Names());
    EXPECT_EQ(shared(1), Names());
    EXPECT_EQ(shared(2), (Names{"mesh", "connectivity"}));  // another size
    EXPECT_EQ(shared(3), (Names{"mesh", "connectivity", "layout", "spans"}));
    EXPECT_EQ(report["shared"]["mesh"], 2);
    EXPECT_EQ(report["shared"]["layout"], 1);
    EXPECT_EQ(report["counts"]["written"], 4);
}

TEST_F(Batch, LeavesAloneWhatIsUpToDate) {
    ASSERT_EQ(run(four).exit_code, 0);
    auto report = nlohmann::json::parse(run(four, "--json").out);
    EXPECT_EQ(report["counts"]["up to date"], 4);
    fs::remove(scratch / "c.png");
    report = nlohmann::json::parse(run(four, "--json").out);
    EXPECT_EQ(report["counts"]["up to date"], 3);
    EXPECT_EQ(report["bakes"][2]["status"], "written");
    report = nlohmann::json::parse(run(four, "--json --force").out);
    EXPECT_EQ(report["counts"]["written"], 4);
    // A single bake of the same is up to date, too.
    const Outcome single =
        run_burl(scratch, fmt::format("bake '{}' -r marble --size 64 --set solid.scale=2 -o '{}'",
                                      scratch / "square.obj", scratch / "a.png"));
    EXPECT_NE(single.out.find("up to date"), std::string::npos) << single.out << single.err;
}

TEST_F(Batch, OneBadBakeFailsAlone) {
    scratch.write("bad.obj", "v 0 0 0\nf 1 2 3\n");
    const Outcome outcome = run(R"({"defaults": {"size": 64}, "bakes": [
        {"mesh": "square.obj", "output": "a.png"},
        {"mesh": "bad.obj", "output": "b.png"},
        {"mesh": "roof.obj", "output": "c.png", "material": "none"},
        {"mesh": "square.obj", "output": "d.png", "recipe": "wood"}]})");
    EXPECT_EQ(outcome.exit_code, int(ExitCode::invalid_file));
    EXPECT_TRUE(fs::exists(scratch / "a.png"));
    EXPECT_TRUE(fs::exists(scratch / "d.png"));
    EXPECT_FALSE(fs::exists(scratch / "b.png"));
    EXPECT_FALSE(fs::exists(scratch / "c.png"));
    EXPECT_NE(outcome.err.find("batch.json:3: bake 2 (b.png): "), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("bad.obj:2: "), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("batch.json:4: bake 3 (c.png): "), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("2 of 4 bakes failed"), std::string::npos) << outcome.err;
}

TEST_F(Batch, NothingIsBakedWhereAMeshOrAPoseIsMissingOrOfNoFormat) {
    scratch.write("m.txt", batch_square);
    for (const char* options : {"", "--dry-run"}) {
        const Outcome outcome = run(R"({"defaults": {"size": 64}, "bakes": [
            {"mesh": "square.obj", "output": "a.png"},
            {"mesh": "none.obj", "output": "b.png"},
            {"mesh": "m.txt", "output": "c.png"},
            {"mesh": "sample:nope", "output": "d.png"},
            {"mesh": "square.obj", "output": "e.glb", "pose": "bent.obj"},
            {"mesh": "square.obj", "output": "f.glb", "unshare-instances": true},
            {"mesh": "square.obj", "output": "g.png", "only-mesh": "x"},
            {"mesh": "square.obj", "output": "h.png", "material": "no material"}]})",
                                    options);
        EXPECT_EQ(outcome.exit_code, int(ExitCode::io));
        EXPECT_EQ(scratch.files(), 4u);  // the meshes and the manifest
        for (const char* part : {"bake 2 (b.png): cannot read ", "bake 3 (c.png): ",
                                 "bake 4 (d.png): there is no mesh \"sample:nope\"",
                                 "bake 5 (e.glb): cannot read ", "bake 6 (f.glb): --unshare",
                                 "bake 7 (g.png): --mesh", "6 of 8 bakes are wrong; nothing was"})
            EXPECT_NE(outcome.err.find(part), std::string::npos) << part << "\n" << outcome.err;
    }
}

TEST_F(Batch, APartWithoutABakeIsTold) {
    const std::string one = R"({"bakes": [{"mesh": "square.obj", "size": 16, "output": "a.png"}]})";
    const Outcome outcome = run(one, "--shard 1/4");
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_NE(outcome.err.find("part 1/4 has no bake"), std::string::npos) << outcome.err;
    EXPECT_FALSE(fs::exists(scratch / "a.png"));
    EXPECT_EQ(run(one, "--shard 4/4").err, "");
    EXPECT_TRUE(fs::exists(scratch / "a.png"));
}

TEST_F(Batch, NothingIsBakedWhereAnEntryIsWrong) {
    const Outcome outcome = run(R"({"bakes": [
        {"mesh": "square.obj", "output": "a.png"},
        {"mesh": "square.obj", "output": "b.png", "sise": 64},
        {"mesh": "square.obj", "output": "c.png", "recipe": "marbel"},
        {"mesh": "square.obj", "output": "square.obj/d.png"},
        {"mesh": "square.obj", "output": "e.png", "depth": 9},
        {"mesh": "square.obj", "output": "./a.png", "size": 64},
        {"output": "f.png"},
        {"mesh": "square.obj", "output": "g.png", "set": [["x"]]},
        7]})");
    EXPECT_NE(outcome.exit_code, 0);
    EXPECT_EQ(scratch.files(), 3u);  // the meshes and the manifest
    for (const char* part :
         {"batch.json:3: bake 2 (b.png): there is no option 'sise'; did you mean 'size'?",
          "batch.json:4: bake 3 (c.png): ", "batch.json:5: bake 4 (square.obj/d.png): ",
          "batch.json:6: bake 5 (e.png): ", "batch.json:7: bake 6 (./a.png): ",
          "written by another bake, too: ", "batch.json:8: bake 7 (f.png): ",
          "batch.json:9: bake 8 (g.png): 'set' must be", "bake 9: an entry must be an object",
          "8 of 9 bakes are wrong; nothing was baked"})
        EXPECT_NE(outcome.err.find(part), std::string::npos) << part << "\n" << outcome.err;
}

TEST_F(Batch, OneMistakeInThousandsOfBakesIsToldAHundredTimes) {
    for (const char* mistake : {R"("sise": 64)", R"("recipe": "marbel")"}) {
        const Outcome outcome = run(fmt::format(
            R"({{"bakes": [{{"mesh": "square.obj", "output": "a.png", {},
                "threads": 1, "size": [1, 2, 3, 4, 5, 6, 7, 8, 9, 10],
                "rotate": [1, 2, 3, 4, 5, 6, 7, 8, 9, 10],
                "depth": [8, 16, 8, 16, 8, 16, 8, 16, 8, 16],
                "seconds": [1, 2, 3, 4, 5, 6, 7, 8, 9, 10]}}]}})",
            mistake));
        EXPECT_EQ(outcome.exit_code, int(ExitCode::invalid_file));
        EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 101) << outcome.err;
        EXPECT_NE(outcome.err.find("100 bakes are wrong, the most that are told"),
                  std::string::npos)
            << outcome.err;
        EXPECT_EQ(scratch.files(), 3u);  // the meshes and the manifest
    }
}

TEST_F(Batch, WhatIsNoManifestIsRefused) {
    for (const char* manifest :
         {"", "[", "[]", "{}", R"({"bakes": {}})", R"({"bakes": []})",
          R"({"bakes": [{}], "default": {}})", R"({"bakes": [{}], "defaults": 1})"}) {
        const Outcome outcome = run(manifest);
        EXPECT_EQ(outcome.exit_code, int(ExitCode::invalid_file)) << manifest;
        expect_one_sentence(outcome.err);
    }
    EXPECT_EQ(run_burl(scratch, fmt::format("batch '{}'", scratch / "none.json")).exit_code,
              int(ExitCode::io));
}

TEST_F(Batch, AKeyMayBeWrittenWithEscapes) {
    const Outcome outcome =
        run_burl(scratch, fmt::format("batch '{}'", case_file("escaped-key-manifest.json")));
    EXPECT_EQ(outcome.exit_code, int(ExitCode::io)) << outcome.err;  // there is no such mesh
    EXPECT_NE(outcome.err.find("escaped-key-manifest.json:1: bake 1 (z.png): "), std::string::npos)
        << outcome.err;
    const auto list =
        entries("{\"b\\u0061kes\": [\n{\"mesh\": \"a.obj\", \"output\": \"b.png\"}]}");
    ASSERT_EQ(list.size(), 1u);
    EXPECT_TRUE(list[0].where.ends_with("batch.json:2: bake 1 (b.png)")) << list[0].where;
}

/// Which tiles there are is known when the mesh has been read.
TEST_F(Batch, ATileThatAnotherBakeWritesOrReadsFailsItsBakeAlone) {
    scratch.write("tiles.obj",
                  "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0.1 0.1\nvt 0.9 0.1\nvt 0.1 0.9\n"
                  "v 2 0 0\nv 3 0 0\nv 2 1 0\nvt 1.1 0.1\nvt 1.9 0.1\nvt 1.1 0.9\n"
                  "f 1/1 2/2 3/3\nf 4/4 5/5 6/6\n");
    const std::string manifest = R"({{"defaults": {{"size": 32}}, "bakes": [
        {{"mesh": "tiles.obj", "output": "u.png", "atlas": "uv", "udim": true}},
        {{"mesh": "square.obj", "output": "u.{}.png"}}]}})";
    EXPECT_EQ(run(fmt::format(fmt::runtime(manifest), 1003)).exit_code, 0);
    fs::remove(scratch / "u.1001.png");
    const Outcome outcome = run(fmt::format(fmt::runtime(manifest), 1001));
    EXPECT_EQ(outcome.exit_code, int(ExitCode::io)) << outcome.err;
    EXPECT_NE(outcome.err.find("batch.json:2: bake 1 (u.png): "), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("u.1001.png: this command also writes that file"), std::string::npos)
        << outcome.err;
    ASSERT_EQ(run_burl(scratch, fmt::format("bake '{}' --size 32 -o '{}'", scratch / "square.obj",
                                            scratch / "single.png"))
                  .exit_code,
              0);
    EXPECT_EQ(slurp(scratch / "u.1001.png"), slurp(scratch / "single.png"));
}

TEST_F(Batch, TheManifestAndWhatItsBakesReadStayAsTheyAre) {
    const auto refused = [&](const std::string& keys, const std::string& options) {
        const std::string manifest = fmt::format(
            R"({{"bakes": [{{"mesh": "square.obj", "output": "a.png", "size": 64{}}}]}})", keys);
        const Outcome outcome = run(manifest, options);
        EXPECT_TRUE(outcome.exit_code == 1 || outcome.exit_code == 2) << outcome.exit_code;
        EXPECT_NE(outcome.err, "");
        EXPECT_EQ(slurp(scratch / "batch.json"), manifest) << keys << options;
        EXPECT_EQ(slurp(scratch / "square.obj"), batch_square) << keys << options;
        EXPECT_EQ(scratch.files(), 3u) << keys << options;
    };
    refused(R"(, "emit-glsl": "batch.json")", "");
    refused(R"(, "emit-glsl": "square.obj")", "");
    for (const char* taken :
         {"batch.json", "square.obj", "./square.obj", "a.png", "a.png.burl.json"})
        refused("", fmt::format("--report '{}'", scratch / taken));
    refused("", fmt::format("--report '{}'", scratch / "none/report.json"));
}

TEST_F(Batch, AnEntryKnowsItsLineWhateverStandsBeforeIt) {
    const auto list = entries(R"({"defaults": {"set": ["a=[{", "b=\"{"],
        "depth": 8},

  "bakes": [{"mesh": "sample:teapot",
             "output": "a.png"}, {
    "mesh": "m.obj", "output": "b.png", "threads": 1}
  ]})");
    ASSERT_EQ(list.size(), 2u);
    EXPECT_TRUE(list[0].where.ends_with("batch.json:4: bake 1 (a.png)")) << list[0].where;
    EXPECT_TRUE(list[1].where.ends_with("batch.json:5: bake 2 (b.png)")) << list[1].where;
    EXPECT_EQ(list[0].wrong, "");
    EXPECT_EQ(list[0].command.mesh, "sample:teapot");
    EXPECT_EQ(list[0].command.out, scratch / "a.png");
    EXPECT_EQ(list[0].command.recipe.settings, (std::vector<std::string>{"a=[{", "b=\"{"}));
    EXPECT_EQ(list[1].wrong, "'threads' is asked of the whole batch: burl batch --threads");
}

TEST_F(Batch, LooksForRecipesFromTheManifestsFolderOnUnlessTheyArePresets) {
    const auto list = entries(R"({"bakes": [
      {"mesh": "square.obj", "output": "a.png", "recipe": "sub/mine"},
      {"mesh": "square.obj", "output": "b.png", "recipe": "mine.json"},
      {"mesh": "square.obj", "output": "c.png", "recipe": "wood"},
      {"mesh": "square.obj", "output": "d.png", "recipe": "wod"}]})");
    ASSERT_EQ(list.size(), 4u);
    const std::string expected[] = {scratch / "sub/mine", scratch / "mine.json", "wood", "wod"};
    for (std::size_t i = 0; i < list.size(); ++i)
        EXPECT_EQ(list[i].command.recipe.recipe, expected[i]);
}

TEST_F(Batch, TakesACacheOnlyWhereATextureLeavesSomethingToTheNext) {
    const auto with_cache = [&](const std::string& second) {
        return run(R"({"defaults": {"size": 64},
          "bakes": [{"mesh": "square.obj", "output": "a.png"}, )" +
                       second + "]}",
                   "--cache 5");
    };
    for (const char* idle : {R"({"mesh": "roof.obj", "output": "b.png"})",
                             R"({"mesh": "square.obj", "output": "b.png", "size": 32})"}) {
        const Outcome outcome = with_cache(idle);
        EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
        expect_one_sentence(outcome.err);
        EXPECT_NE(outcome.err.find("--cache does nothing"), std::string::npos) << outcome.err;
        EXPECT_FALSE(fs::exists(scratch / "a.png"));
    }
    for (const char* used : {R"({"mesh": "square.obj", "output": "b.png", "recipe": "wood"})",
                             R"({"mesh": "roof.obj", "output": "b.png", "frames": 2,
                                 "animate": "solid.scale=1:2"})"})
        EXPECT_EQ(with_cache(used).exit_code, 0) << used;
}

TEST_F(Batch, NullTakesAwayTheEditsOfTheDefaults) {
    const auto list = entries(R"({"defaults": {"set": ["solid.scale=2", "atlas.size=64"]},
      "bakes": [{"mesh": "square.obj", "output": "a.png", "set": null},
                {"mesh": "square.obj", "output": "b.png", "set": "solid.scale=3"}]})");
    ASSERT_EQ(list.size(), 2u);
    EXPECT_EQ(list[0].wrong, "");
    EXPECT_EQ(list[0].command.recipe.settings, std::vector<std::string>());
    EXPECT_EQ(list[1].command.recipe.settings,
              (std::vector<std::string>{"atlas.size=64", "solid.scale=3"}));
}

TEST_F(Batch, AnEditTakesTheDefaultsPlaceInEitherSpelling) {
    const auto list = entries(R"({"defaults": {"set": ["material.base_color=red", "bump.height=2"]},
      "bakes": [{"mesh": "square.obj", "output": "a.png", "set": "texture=clouds"}]})");
    ASSERT_EQ(list.size(), 1u);
    EXPECT_EQ(list[0].command.recipe.settings,
              (std::vector<std::string>{"bump.height=2", "texture=clouds"}));
}

}  // namespace
}  // namespace burl::test
