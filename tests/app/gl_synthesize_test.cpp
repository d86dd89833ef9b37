// Textures of the 1999 model through OpenGL against the host's, byte by byte.
#include "app/gl_synthesize.h"

#include <cmath>

#include <gtest/gtest.h>

#include "app/embedded.h"
#include "app/pipeline.h"
#include "app/sample_meshes.h"
#include "procedural/synthesize.h"
#include "tests/app/gl_fixture.h"

namespace burl {
namespace {

/// A mesh's atlas, and textures of it.
struct Subject {
    Pipeline pipeline;
    Subject(const std::string& mesh, std::uint32_t size) : pipeline(sample_mesh(mesh)) {
        Recipe recipe;
        recipe.atlas.size = size;
        pipeline.set_recipe(recipe);
    }
    const SolidAtlas& solid() { return pipeline.solid(); }
};

template <class Pixel>
Image<Pixel> on_host(const SolidAtlas& solid, const Texture& texture, const Affine3& map) {
    if constexpr (std::is_same_v<Pixel, Rgb8>)
        return synthesize_rgb8(solid, texture, map, 0, {}, Kernel::direct);
    else if constexpr (std::is_same_v<Pixel, Rgb16>)
        return synthesize_rgb16(solid, texture, map, 0, {}, Kernel::direct);
    else if constexpr (std::is_same_v<Pixel, RgbF>)
        return synthesize_rgbf(solid, texture, map, 0, {}, Kernel::direct);
    else
        return synthesize_field(solid, texture, map, 0, Kernel::direct);
}

template <class Pixel>
std::size_t differing(const Image<Pixel>& a, const Image<Pixel>& b) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.pixels().size(); ++i)
        count += a.pixels()[i] == b.pixels()[i] ? 0 : 1;
    return count;
}

using GlSynthesizeTest = GlTest;

template <class Pixel>
void expect_equal(GlSynthesis& gl, Subject& subject, const Recipe& recipe) {
    const Affine3 map = texture_from_solid(recipe);
    Image<Pixel> drawn;
    gl.synthesize(subject.solid(), recipe.texture, map, 0, drawn);
    const Image<Pixel> expected = on_host<Pixel>(subject.solid(), recipe.texture, map);
    EXPECT_EQ(differing(drawn, expected), 0u) << recipe.name << " " << sizeof(Pixel);
}

TEST_F(GlSynthesizeTest, EveryPresetHasTheHostsBytes) {
    GlSynthesis gl(*context);
    Subject subject("sample:teapot", 64);
    int presets = 0;
    for (const EmbeddedFile& preset : embedded_recipes()) {
        const Recipe recipe =
            load_recipe(std::string(preset.name.substr(0, preset.name.find('.'))));
        if (!recipe.graph.empty()) continue;
        ASSERT_EQ(gl.problem(recipe.texture), "") << recipe.name;
        expect_equal<Rgb8>(gl, subject, recipe);
        expect_equal<float>(gl, subject, recipe);
        ++presets;
    }
    EXPECT_GE(presets, 7);
}

TEST_F(GlSynthesizeTest, WiderPixelsHaveTheHostsBits) {
    GlSynthesis gl(*context);
    Subject subject("sample:king", 64);
    const Recipe recipe = load_recipe("marble");
    expect_equal<Rgb16>(gl, subject, recipe);
    expect_equal<RgbF>(gl, subject, recipe);
}

}  // namespace
}  // namespace burl
