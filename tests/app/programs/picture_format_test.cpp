// Pictures of other formats than PNG by the program: what is written, what is refused, and what a
// glTF says of them.

#include "app/image/image_io.h"
#include "app/scene/scene.h"
#include "atlas/base/json.h"
#include "tests/app/programs/run_program.h"

namespace burl::test {
namespace {

class PictureFormat : public testing::Test {
  protected:
    Outcome bake(const std::string& out, const std::string& options) {
        const char* size = options.find("--size") == std::string::npos ? "--size 64" : "";
        return run_burl(
            scratch_, fmt::format("bake sample:cube -o '{}' {} {}", scratch_ / out, size, options));
    }
    nlohmann::json gltf(const std::string& name) {
        return nlohmann::json::parse(slurp(scratch_ / name));
    }
    /// Expects a refusal (exit code 1) that holds the words, and nothing left.
    void expect_refused(const std::string& out, const std::string& options,
                        const std::string& words) {
        const Outcome outcome = bake(out, options);
        EXPECT_EQ(outcome.exit_code, 1) << out << " " << options;
        EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
        EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
        EXPECT_EQ(scratch_.files(), 0u) << out << " " << options;
    }

    Scratch scratch_;
};

TEST_F(PictureFormat, WebpInGltfIsARequiredExtension) {
    ASSERT_EQ(bake("a.gltf", "--recipe hammered --picture-format webp").exit_code, 0);
    const nlohmann::json json = gltf("a.gltf");
    EXPECT_EQ(json["extensionsUsed"], nlohmann::json::array({"EXT_texture_webp"}));
    EXPECT_EQ(json["extensionsRequired"], nlohmann::json::array({"EXT_texture_webp"}));
    ASSERT_GE(json["textures"].size(), 2u);
    for (const nlohmann::json& texture : json["textures"]) {
        EXPECT_FALSE(texture.contains("source"));
        const std::size_t image = texture["extensions"]["EXT_texture_webp"]["source"];
        EXPECT_EQ(json["images"].at(image)["mimeType"], "image/webp");
        const std::string file = slurp(scratch_ / json["images"][image]["uri"].get<std::string>());
        EXPECT_EQ(file.substr(8, 4), "WEBP");
    }
}

/// The textures of EXT_texture_webp are what the PNGs of the same bake are.
TEST_F(PictureFormat, WebpIsDrawnAsPngIs) {
    ASSERT_EQ(bake("w.glb", "--recipe hammered --picture-format webp").exit_code, 0);
    ASSERT_EQ(bake("p.glb", "--recipe hammered").exit_code, 0);
    const Scene webp = load_scene(scratch_ / "w.glb"), png = load_scene(scratch_ / "p.glb");
    EXPECT_TRUE(webp.notes.empty());
    ASSERT_EQ(webp.textures.size(), png.textures.size());
    ASSERT_GT(png.textures.size(), 1u);
    for (std::size_t i = 0; i < png.textures.size(); ++i)
        EXPECT_TRUE(webp.textures[i].image == png.textures[i].image) << i;
}

TEST_F(PictureFormat, WebpGoesIntoADocumentThatIsKept) {
    ASSERT_EQ(bake("source.gltf", "--recipe marble").exit_code, 0);
    const Outcome outcome = run_burl(
        scratch_, fmt::format("bake '{}' -o '{}' --size 64 --recipe hammered --picture-format webp",
                              scratch_ / "source.gltf", scratch_ / "kept.gltf"));
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const nlohmann::json json = gltf("kept.gltf");
    EXPECT_EQ(json["extensionsUsed"], nlohmann::json::array({"EXT_texture_webp"}));
    EXPECT_EQ(json["extensionsRequired"], nlohmann::json::array({"EXT_texture_webp"}));
    ASSERT_EQ(json["images"].size(), 2u);
    for (const nlohmann::json& image : json["images"]) {
        EXPECT_EQ(image["mimeType"], "image/webp");
        EXPECT_EQ(slurp(scratch_ / image["uri"].get<std::string>()).substr(8, 4), "WEBP");
    }
}

TEST_F(PictureFormat, JpegInGltfNeedsNoExtension) {
    ASSERT_EQ(bake("a.gltf", "--recipe marble --picture-format jpeg:70 --levels 1").exit_code, 0);
    const nlohmann::json json = gltf("a.gltf");
    EXPECT_FALSE(json.contains("extensionsRequired"));
    EXPECT_EQ(json["textures"][0]["source"], 0);
    EXPECT_EQ(json["images"][1]["mimeType"], "image/jpeg");
    EXPECT_EQ(json["images"][1]["uri"], "a.1.jpg");
    EXPECT_EQ(slurp(scratch_ / "a.1.jpg").substr(0, 3), "\xff\xd8\xff");
}

TEST_F(PictureFormat, EveryPictureBesideHasIt) {
    ASSERT_EQ(bake("a.obj",
                   "--recipe brushed-steel --picture-format webp --channels occlusion "
                   "--levels 1")
                  .exit_code,
              0);
    for (const char* name : {"a.webp", "a.1.webp", "a_normal.webp", "a_roughness.webp",
                             "a_roughness.1.webp", "a_occlusion.webp"})
        EXPECT_EQ(slurp(scratch_ / name).substr(8, 4), "WEBP") << name;
    const std::string mtl = slurp(scratch_ / "a.mtl");
    for (const char* line : {"\nmap_Kd a.webp\n", "\nnorm a_normal.webp\n",
                             "\nmap_Bump -bm 1 a_normal.webp\n", "\nmap_Pr a_roughness.webp\n"})
        EXPECT_NE(mtl.find(line), std::string::npos) << mtl;
}

TEST_F(PictureFormat, WhatTheFormatHasNotIsRefusedBeforeTheWork) {
    expect_refused("a.glb", "--picture-format ktx2", "Basis Universal");
    expect_refused("a.gltf", "--picture-format ktx2:5", "Basis Universal");
    expect_refused("a.jpg", "--picture-format webp", "extension");
    expect_refused("a.glb", "--picture-format bmp", "png, jpeg, webp or ktx2");
    for (const char* format : {"jpeg", "webp"})
        expect_refused("a.glb", fmt::format("--depth 16 --picture-format {}", format), "8 bits");
    expect_refused("a.ktx2", "--depth 16", "8 bits");
    expect_refused("a.png", "--depth 32", "only an .exr");
    expect_refused("a.webp", "--size 16384", "16383");
    expect_refused("a.exr", "--picture-format webp", "has no pictures");
    expect_refused("a.stl", "--picture-format jpeg", "has no pictures");
    const std::string clear = R"(--set 'material.opacity={"node": "fbm"}')";
    expect_refused("a.jpg", clear, "alpha");
    expect_refused("a.obj", "--recipe oak --pack unity --picture-format jpeg", "mask");
}

TEST_F(PictureFormat, SixteenBitsInGltfAreWarnedOf) {
    const Outcome outcome = bake("a.glb", "--depth 16");
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_NE(outcome.err.find("too light"), std::string::npos) << outcome.err;
    EXPECT_EQ(bake("b.png", "--depth 16").err.find("too light"), std::string::npos);
}

TEST_F(PictureFormat, FullFloatsAreTwiceAsLarge) {
    ASSERT_EQ(bake("half.exr", "").exit_code, 0);
    ASSERT_EQ(bake("full.exr", "--depth 32").exit_code, 0);
    EXPECT_GT(slurp(scratch_ / "full.exr").size(), slurp(scratch_ / "half.exr").size() * 3 / 2);
    const Outcome idle = bake("idle.exr", "--depth 16");
    EXPECT_EQ(idle.exit_code, 1);
}

TEST_F(PictureFormat, ObjGivesTheHighlightOfBlendersMeasures) {
    ASSERT_EQ(bake("a.obj", "").exit_code, 0);
    EXPECT_NE(slurp(scratch_ / "a.mtl").find("\nKs 0.5 0.5 0.5\nNs 160\nillum 2\n"),
              std::string::npos)
        << slurp(scratch_ / "a.mtl");
}

}  // namespace
}  // namespace burl::test
