// --max-triangles, --max-image and --max-memory, from outside.

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

TEST(Limits, AManifestGivesItselfNone) {
    const Scratch scratch;
    for (const char* key : {"allow-outside", "max-triangles", "max-image", "max-memory"}) {
        const Json bake{{"mesh", "sample:cube"}, {"output", "a.png"}, {key, true}};
        const std::string path =
            scratch.write("m.json", Json{{"bakes", Json::array({bake})}}.dump());
        const Outcome outcome = run_burl(scratch, fmt::format("batch '{}'", path));
        EXPECT_EQ(outcome.exit_code, 3) << outcome.err;
        EXPECT_NE(outcome.err.find("there is no option"), std::string::npos) << outcome.err;
    }
}

}  // namespace
}  // namespace burl::test
