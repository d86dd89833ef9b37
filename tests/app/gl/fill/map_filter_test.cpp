// Filters of the colour map through OpenGL against the host's, byte by byte.
#include <algorithm>
#include <cstdlib>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/gl/fill/synthesize.h"
#include "app/pipeline/pipeline.h"
#include "app/surface/sample_meshes.h"
#include "procedural/fill/synthesize.h"
#include "tests/app/gl/device/fixture.h"

namespace burl {
namespace {

class GlMapFilterTest : public GlTest {
  protected:
    const SolidAtlas& solid(const char* mesh = "sample:teapot") {
        pipeline.emplace(sample_mesh(mesh));
        Recipe recipe;
        recipe.atlas.kind = AtlasKind::patch;
        recipe.atlas.size = 64;
        pipeline->set_recipe(recipe);
        return pipeline->solid();
    }

    /// Kinks, jumps and a constant part; footprints from a small part of the map to several periods
    /// of it.
    static Texture texture(NoiseKind kind, Wrap wrap) {
        Texture texture;
        texture.quadric.a = 2.0, texture.quadric.f = 0.5, texture.quadric.i = 1.5;
        NoiseTerm term;
        term.kind = kind;
        term.octaves = 3;
        term.seed = 9;
        term.frequency = Vec3d(1.5, 2.0, 2.5);
        texture.noise.push_back(term);
        texture.colors.wrap = wrap;
        texture.colors.stops = {{0.1, {0, 0, 120}},   {0.4, {60, 120, 255}},
                                {0.5, {20, 120, 20}}, {0.5, {200, 90, 10}},
                                {0.6, {200, 90, 10}}, {0.9, {255, 255, 255}}};
        return texture;
    }

    static Filter filter(FilterKind kind) {
        Filter result;
        result.kind = kind;
        return result;
    }

    std::optional<Pipeline> pipeline;
};

template <class Pixel>
Image<Pixel> map_filter_on_host(const SolidAtlas& solid, const Texture& texture,
                                const Filter& filter) {
    if constexpr (std::is_same_v<Pixel, Rgb8>)
        return synthesize_model<Rgb8>(solid, texture, {}, 0, filter, Kernel::direct);
    else if constexpr (std::is_same_v<Pixel, Rgb16>)
        return synthesize_model<Rgb16>(solid, texture, {}, 0, filter, Kernel::direct);
    else
        return synthesize_model<RgbF>(solid, texture, {}, 0, filter, Kernel::direct);
}

template <class Pixel>
void map_filter_expect_equal(GlSynthesis& gl, const SolidAtlas& solid, const Texture& texture,
                             const Filter& filter) {
    Image<Pixel> drawn;
    gl.synthesize(solid, texture, {}, 0, drawn, filter);
    const Image<Pixel> expected = map_filter_on_host<Pixel>(solid, texture, filter);
    EXPECT_EQ(differing(drawn, expected), 0u);
    EXPECT_GT(differing(map_filter_on_host<Pixel>(solid, texture, {}), expected), 100u)
        << "nothing to filter";
}

TEST_F(GlMapFilterTest, EveryNoiseHasTheHostsBytes) {
    GlSynthesis gl(*context);
    const SolidAtlas& atlas = solid();
    const Filter trapezoid = filter(FilterKind::trapezoid);
    for (const NoiseKind kind : {NoiseKind::value, NoiseKind::perlin, NoiseKind::simplex})
        map_filter_expect_equal<Rgb8>(gl, atlas, texture(kind, Wrap::repeat), trapezoid);
}

TEST_F(GlMapFilterTest, EveryFadeHasTheHostsBits) {
    GlSynthesis gl(*context);
    const SolidAtlas& atlas = solid("sample:king");
    for (const Fade fade : {Fade::linear, Fade::quintic}) {
        Texture subject = texture(NoiseKind::value, Wrap::repeat);
        subject.noise[0].fade = fade;
        map_filter_expect_equal<RgbF>(gl, atlas, subject, filter(FilterKind::trapezoid));
    }
}

TEST_F(GlMapFilterTest, ClampedMapsAndBoxesHaveTheHostsBytes) {
    GlSynthesis gl(*context);
    const SolidAtlas& atlas = solid();
    map_filter_expect_equal<Rgb16>(gl, atlas, texture(NoiseKind::perlin, Wrap::clamp),
                                   filter(FilterKind::trapezoid));
    map_filter_expect_equal<Rgb8>(gl, atlas, texture(NoiseKind::value, Wrap::repeat),
                                  filter(FilterKind::exact));
}

TEST_F(GlMapFilterTest, TablesHaveTheHostsBytes) {
    GlSynthesis gl(*context);
    const SolidAtlas& atlas = solid();
    for (const FilterKind kind :
         {FilterKind::table_mip, FilterKind::table_sat, FilterKind::table_sat3}) {
        map_filter_expect_equal<Rgb8>(gl, atlas, texture(NoiseKind::value, Wrap::repeat),
                                      filter(kind));
        EXPECT_EQ(gl.work().passes, 1);
        map_filter_expect_equal<RgbF>(gl, atlas, texture(NoiseKind::simplex, Wrap::clamp),
                                      filter(kind));
    }
    Filter fading = filter(FilterKind::table_sat);
    fading.band_limit = true;
    map_filter_expect_equal<Rgb16>(gl, atlas, texture(NoiseKind::perlin, Wrap::repeat), fading);
}

/// Octaves without a stream kernel.
TEST_F(GlMapFilterTest, OtherNoisesHaveTheHostsBytes) {
    GlSynthesis gl(*context);
    const SolidAtlas& atlas = solid();
    Texture subject = texture(NoiseKind::value, Wrap::repeat);
    subject.noise[0].octaves = 1;
    NoiseTerm worley = subject.noise[0], ridged = worley;
    worley.kind = NoiseKind::worley, worley.amplitude = 0.6, worley.frequency = Vec3d(9.0);
    ridged.kind = NoiseKind::perlin, ridged.shape = OctaveShape::ridged;
    ridged.period = {3, 0, 4}, ridged.time = 0.7, ridged.range = NoiseRange::unit;
    subject.noise.push_back(worley);
    subject.noise.push_back(ridged);
    map_filter_expect_equal<RgbF>(gl, atlas, subject, filter(FilterKind::trapezoid));
    map_filter_expect_equal<Rgb8>(gl, atlas, subject, filter(FilterKind::table_sat));
    Filter fading = filter(FilterKind::none);
    fading.band_limit = true;
    map_filter_expect_equal<RgbF>(gl, atlas, subject, fading);
}

TEST_F(GlMapFilterTest, FadingOctavesHaveTheHostsBytes) {
    GlSynthesis gl(*context);
    const SolidAtlas& atlas = solid();
    Texture subject = texture(NoiseKind::value, Wrap::repeat);
    subject.noise[0].frequency = Vec3d(4.0);
    Filter fading = filter(FilterKind::none);
    fading.band_limit = true;
    map_filter_expect_equal<Rgb8>(gl, atlas, subject, fading);
    EXPECT_EQ(gl.work().passes, 1);
    fading.kind = FilterKind::trapezoid;
    map_filter_expect_equal<Rgb8>(gl, atlas, subject, fading);
}

/// One program for both textures and both tiles; the second finds the maps of the first.
TEST_F(GlMapFilterTest, SlidersAndTilesNeedNoNewMaps) {
    GlSynthesisLimits limits;
    limits.tile = 40;
    GlSynthesis gl(*context, limits);
    const SolidAtlas& atlas = solid();
    Texture subject = texture(NoiseKind::value, Wrap::clamp);
    map_filter_expect_equal<Rgb8>(gl, atlas, subject, filter(FilterKind::exact));
    EXPECT_EQ(gl.work().passes, 8);
    subject.noise[0].amplitude = 1.7;
    subject.colors.stops[1].color = {255, 0, 0};
    map_filter_expect_equal<Rgb8>(gl, atlas, subject, filter(FilterKind::exact));
    EXPECT_EQ(gl.work().maps, 0);
    EXPECT_EQ(gl.work().compile, 0.0);
}

/// Float32 coordinates move what lies near a break; everything else stays within two codes.
TEST_F(GlMapFilterTest, Float32StaysNearTheHost) {
    GlSynthesisLimits limits;
    limits.float64 = false;
    GlSynthesis gl(*context, limits);
    const SolidAtlas& atlas = solid();
    const Texture subject = texture(NoiseKind::value, Wrap::repeat);
    const Filter trapezoid = filter(FilterKind::trapezoid);
    Image<Rgb8> drawn;
    gl.synthesize(atlas, subject, {}, 0, drawn, trapezoid);
    const Image<Rgb8> expected = map_filter_on_host<Rgb8>(atlas, subject, trapezoid);
    ASSERT_EQ(drawn.pixels().size(), expected.pixels().size());
    std::size_t far = 0;
    for (std::size_t i = 0; i < drawn.pixels().size(); ++i) {
        const Rgb8 a = drawn.pixels()[i], b = expected.pixels()[i];
        const int most = std::max({std::abs(int(a.r) - int(b.r)), std::abs(int(a.g) - int(b.g)),
                                   std::abs(int(a.b) - int(b.b))});
        far += most > 2 ? 1 : 0;
    }
    EXPECT_EQ(far, 0u);
}

TEST_F(GlMapFilterTest, MoreBreaksAreRefused) {
    GlSynthesis gl(*context);
    const Texture subject = texture(NoiseKind::value, Wrap::repeat);
    Texture striped = subject;
    for (int i = 0; i < 40; ++i)
        striped.colors.stops.push_back({0.9 + 0.001 * i, {std::uint8_t(i * 37), 0, 0}});
    EXPECT_EQ(gl.problem(striped), "");
    EXPECT_THAT(gl.problem(striped, filter(FilterKind::exact)), testing::HasSubstr("at most 32"));
}

}  // namespace
}  // namespace burl
