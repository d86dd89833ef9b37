// The images of a kept document that do not go with it: each is told, whatever the reason.
#include "app/image/image_io.h"
#include "tests/app/programs/run_program.h"
#include "tests/app/support/kept_samples.h"

namespace burl::test {
namespace {

using Json = nlohmann::ordered_json;

/// A glTF "in/a.gltf" of two meshes, of which the second has an image of a file.
class KeptImages : public testing::Test {
  protected:
    KeptImages() {
        fs::create_directories(scratch_.path() / "in/sub");
        fs::create_directories(scratch_.path() / "out");
        for (const char* path : {"red.png", "in/own.png"})
            write_png(scratch_ / path, Image<Rgb8>(8, 8, {200, 10, 10}));
        fs::create_symlink("../red.png", scratch_ / "in/link.png");
        scratch_.write("in/sub/t.dds", "DDS |");
    }
    /// Bakes the first mesh into `out`, where the image of the second is `uri`.
    Outcome bake(const std::string& uri, const std::string& more,
                 const char* out = "out/x.gltf") const {
        Json document = Json::parse(kept_samples().at("neighbour"));
        document["images"][1]["uri"] = uri;
        scratch_.write("in/a.gltf", document.dump());
        return run_burl(scratch_, fmt::format("bake '{}' -o '{}' --mesh bar -s 32 --force {}",
                                              scratch_ / "in/a.gltf", scratch_ / out, more));
    }
    void expect_told(const std::string& uri, const std::string& reason) const {
        SCOPED_TRACE(uri);
        const std::string sentence =
            fmt::format("not kept: image {}: the file {}; its name is kept", uri, reason);
        const Outcome lenient = bake(uri, "");
        EXPECT_EQ(lenient.exit_code, 0) << lenient.err;
        EXPECT_NE(lenient.err.find(sentence), std::string::npos) << lenient.err;
        const Json made = Json::parse(slurp(scratch_ / "out/x.gltf"));
        EXPECT_EQ(made["images"][0]["uri"], uri);
        EXPECT_EQ(bake(uri, "--strict").exit_code, 5);
    }

    Scratch scratch_;
};

TEST_F(KeptImages, OfFilesOutsideAreTold) {
    const std::string why = "lies outside the folder of the file that names it";
    for (const std::string& uri : {std::string("../red.png"), scratch_ / "red.png",
                                   std::string("%2e%2e%2fred.png"), std::string("link.png")})
        expect_told(uri, why);
}

TEST_F(KeptImages, OfOtherFormatsAreTold) {
    expect_told("sub/t.dds", "is no PNG, JPEG, WebP or KTX2");
    expect_told("none.png", "is not there");
}

/// In the source's own folder every name leads where it led.
TEST_F(KeptImages, BesideTheSourceKeepTheirNames) {
    for (const char* uri : {"../red.png", "own.png", "sub/t.dds", "none.png"}) {
        const Outcome baked = bake(uri, "--strict", "in/x.gltf");
        EXPECT_EQ(baked.exit_code, 0) << uri << baked.err;
        const Json made = Json::parse(slurp(scratch_ / "in/x.gltf"));
        EXPECT_EQ(made["images"][0]["uri"], uri);
    }
}

TEST_F(KeptImages, WithinGoWithTheDocument) {
    for (const std::string& uri :
         {std::string("own.png"), std::string("data:image/png;base64,") + red_png}) {
        const Outcome baked = bake(uri, "--strict");
        EXPECT_EQ(baked.exit_code, 0) << uri << baked.err;
        EXPECT_EQ(baked.err.find("not kept"), std::string::npos) << baked.err;
    }
}

}  // namespace
}  // namespace burl::test
