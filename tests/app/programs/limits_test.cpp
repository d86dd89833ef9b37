// --max-triangles, --max-image, --max-noises and --max-memory, from outside.

#include "app/image/image_io.h"
#include "atlas/base/json.h"
#include "tests/app/programs/run_program.h"

namespace burl::test {
namespace {

using Json = nlohmann::json;

void expect_refused(const Scratch& scratch, const std::string& arguments, int code,
                    const std::string& says) {
    SCOPED_TRACE(arguments);
    const Outcome outcome =
        run_burl(scratch, fmt::format("{} -o '{}'", arguments, scratch / "a.glb"));
    EXPECT_EQ(outcome.exit_code, code) << outcome.err;
    EXPECT_NE(outcome.err.find(says), std::string::npos) << outcome.err;
    EXPECT_FALSE(fs::exists(scratch / "a.glb"));
}

TEST(Limits, TrianglesAreCounted) {
    const Scratch scratch;
    const std::string bake = "bake sample:cube --size 16 --max-triangles ";
    expect_refused(scratch, bake + "11", 5, "12 triangles are more than 11 (--max-triangles)");
    expect_refused(scratch, bake + "47 --displace 1 --recipe oak", 5, "are more than 47");
    const Outcome baked = run_burl(scratch, fmt::format("{}12 -o '{}'", bake, scratch / "a.glb"));
    EXPECT_EQ(baked.exit_code, 0) << baked.err;
}

/// A scene that is drawn counts, too, with every node that places a mesh.
TEST(Limits, TrianglesOfScenesAreCounted) {
    const Scratch scratch;
    for (const char* name : {"c.obj", "c.glb", "c.gltf"})
        ASSERT_EQ(
            run_burl(scratch, fmt::format("bake sample:cube --size 16 -o '{}'", scratch / name))
                .exit_code,
            0);
    Json gltf = Json::parse(slurp(scratch / "c.gltf"));
    const std::size_t nodes = gltf["nodes"].size();
    ASSERT_EQ(gltf["scenes"][0]["nodes"].size(), nodes);
    gltf["nodes"].push_back(gltf["nodes"][0]);
    gltf["scenes"][0]["nodes"].push_back(nodes);
    scratch.write("twice.gltf", gltf.dump());
    for (const auto& [name, count] :
         {std::pair{"c.obj", 12}, {"c.glb", 12}, {"c.gltf", 12}, {"twice.gltf", 24}}) {
        const auto render = [&](int most) {
            return run_burl(scratch, fmt::format("render '{}' --size 8x8 --max-triangles {} "
                                                 "-o '{}'",
                                                 scratch / name, most, scratch / "p.png"));
        };
        const Outcome refused = render(count - 1);
        EXPECT_EQ(refused.exit_code, 5) << name << refused.err;
        EXPECT_NE(refused.err.find("(--max-triangles)"), std::string::npos) << refused.err;
        EXPECT_FALSE(fs::exists(scratch / "p.png"));
        EXPECT_EQ(render(count).exit_code, 0) << name;
        fs::remove(scratch / "p.png");
    }
}

TEST(Limits, SidesOfImagesAreBounded) {
    const Scratch scratch;
    write_png(scratch / "i.png", Image<Rgb8>(32, 8, {10, 200, 10}));
    const std::string recipe =
        scratch.write("r.json", R"({"burl": 1, "texture": {"node": "image", "file": "i.png"}})");
    const std::string bake = fmt::format("bake sample:cube --size 16 -r '{}' --max-image ", recipe);
    expect_refused(scratch, bake + "31", 3, "32 x 8 pixels");
    const Outcome baked = run_burl(scratch, fmt::format("{}32 -o '{}'", bake, scratch / "a.glb"));
    EXPECT_EQ(baked.exit_code, 0) << baked.err;
}

TEST(Limits, ImagesAreBoundedTogether) {
    const Scratch scratch;
    for (const char* name : {"i.png", "j.png", "k.png"})
        write_png(scratch / name, Image<Rgb8>(5, 5, {10, 200, 10}));
    const std::string image = R"({"node": "image", "file": "i.png"})",
                      other = R"({"node": "image", "file": "j.png"})",
                      third = R"({"node": "image", "file": "k.png"})";
    const auto mix = [](const std::string& a, const std::string& b) {
        return fmt::format(R"({{"node": "mix", "a": {}, "b": {}}})", a, b);
    };
    const auto bake = [&](const std::string& texture, const char* most) {
        const std::string recipe =
            scratch.write("r.json", R"({"burl": 1, "texture": )" + texture + "}");
        return run_burl(scratch, fmt::format("bake sample:cube -s 16 -r '{}' --max-image {} -o "
                                             "'{}' --force",
                                             recipe, most, scratch / "a.png"));
    };
    EXPECT_EQ(bake(image, "5").exit_code, 0) << bake(image, "5").err;
    EXPECT_EQ(bake(mix(image, other), "5").exit_code, 0) << bake(mix(image, other), "5").err;
    const Outcome three = bake(mix(mix(image, other), third), "5");
    EXPECT_EQ(three.exit_code, 3);
    EXPECT_NE(three.err.find("192 pixels together"), std::string::npos) << three.err;
}

TEST(Limits, MemoryIsBounded) {
#ifdef __SANITIZE_ADDRESS__
    GTEST_SKIP() << "the sanitizer's own memory counts";
#endif
    const Scratch scratch;
    const std::string bake = "bake sample:cube --max-memory ";
    expect_refused(scratch, bake + "256M --size 16384", 4, "memory");
    expect_refused(scratch, bake + "1M --size 16", 1, "256M is the least");
    expect_refused(scratch, bake + "much --size 16", 1, "must be a size such as 512M or 4G");
    const Outcome baked =
        run_burl(scratch, fmt::format("{}256M --size 16 -o '{}'", bake, scratch / "a.glb"));
    EXPECT_EQ(baked.exit_code, 0) << baked.err;
}

TEST(Limits, NoisesAreCountedBeforeAnyWork) {
    const Scratch scratch;
    // 2.7e8 texels of 1024 samples of 16 octaves: days, which the test would not live to see
    const std::string recipe = scratch.write(
        "r.json",
        R"({"burl": 1, "texture": {"node": "fbm", "octaves": 16}, "atlas": {"size": 16384},
                      "filter": {"kind": "supersample", "samples": 1024}})");
    const std::string bake = fmt::format("bake sample:torus -r '{}' --max-noises ", recipe);
    expect_refused(scratch, bake + "1e12", 5, "hours of one core, are more than 1e+12");
    expect_refused(scratch,
                   fmt::format("bake sample:torus -r '{}' --set filter.samples=1024 "
                               "--levels direct:64",
                               recipe),
                   5, "(--max-noises)");
    expect_refused(scratch, "bake sample:torus -r moss -s 16 --max-noises 1000", 5, "noises");
    expect_refused(scratch, "bake sample:torus -r marble -s 16 --max-noises 0", 1, "--max-noises");
    const Outcome frames = run_burl(
        scratch, fmt::format("bake sample:torus -r marble -s 16 --max-noises 10000 --force "
                             "--animate solid.scale=1:2 --frames 9 -o '{}'",
                             scratch / "f.png"));
    EXPECT_EQ(frames.exit_code, 5) << frames.err;
    const Outcome one = run_burl(
        scratch, fmt::format("bake sample:torus -r marble -s 16 --max-noises 10000 -o '{}'",
                             scratch / "f.png"));
    EXPECT_EQ(one.exit_code, 0) << one.err;
}

TEST(Limits, NoisesOfOtherVerbsAreCounted) {
    const Scratch scratch;
    const std::string points = scratch.write("p.csv", "0,0,0\n1,0,0\n");
    const std::string manifest = scratch.write(
        "m.json", R"({"bakes": [{"mesh": "sample:cube", "recipe": "marble", "size": 16,
                                 "output": "kept.png"}]})");
    scratch.write("kept.png", "kept");
    for (const std::string& verb :
         {fmt::format("render sample:cube --direct -r marble --size 16x16 -o '{}'",
                      scratch / "r.png"),
          fmt::format("render sample:cube --lazy -r marble --size 16x16 -o '{}'",
                      scratch / "r.png"),
          std::string("metrics sample:cube -r marble --levels -s 16"),
          fmt::format("eval marble --points '{}'", points), fmt::format("batch '{}'", manifest)}) {
        const Outcome outcome = run_burl(scratch, verb + " --max-noises 9");
        EXPECT_EQ(outcome.exit_code, 5) << verb << outcome.err;
        EXPECT_NE(outcome.err.find("(--max-noises)"), std::string::npos) << outcome.err;
    }
    EXPECT_FALSE(fs::exists(scratch / "r.png"));
    EXPECT_EQ(fs::file_size(scratch / "kept.png"), 4u);
    EXPECT_EQ(run_burl(scratch, fmt::format("eval marble --points '{}' --max-noises 100", points))
                  .exit_code,
              0);
}

TEST(Limits, AManifestGivesItselfNone) {
    const Scratch scratch;
    for (const char* key :
         {"allow-outside", "max-triangles", "max-image", "max-noises", "max-memory"}) {
        const Json bake{{"mesh", "sample:cube"}, {"output", "a.png"}, {key, true}};
        const std::string path =
            scratch.write("m.json", Json{{"bakes", Json::array({bake})}}.dump());
        const Outcome outcome = run_burl(scratch, fmt::format("batch '{}'", path));
        EXPECT_EQ(outcome.exit_code, 3) << outcome.err;
        EXPECT_NE(outcome.err.find("is asked of the whole batch"), std::string::npos)
            << outcome.err;
    }
}

TEST(Limits, PointsOfLevelsAreCounted) {
    const Scratch scratch;
    // 256 texels, and some million points of the surface that tell whether their lookups are right
    const std::string metrics = "metrics sample:cube -a quad -s 16 ";
    const Outcome refused = run_burl(scratch, metrics + "-r marble --levels --max-noises 2e6");
    EXPECT_EQ(refused.exit_code, 5) << refused.err;
    EXPECT_NE(refused.err.find("(--max-noises)"), std::string::npos) << refused.err;
    const Outcome no_lookups = run_burl(scratch, metrics + "--max-noises 9");
    EXPECT_EQ(no_lookups.exit_code, 0) << no_lookups.err;
}

}  // namespace
}  // namespace burl::test
