// Filters that look beside the texels' centres, supersampling and trapezoid2, through OpenGL
// against the host's, byte by byte.
#include <gtest/gtest.h>

#include "app/gl/fill/synthesize.h"
#include "app/gl/fill/synthesizer.h"
#include "procedural/fill/graph.h"
#include "procedural/fill/synthesize.h"
#include "tests/app/gl/device/fixture.h"
#include "tests/procedural/graph/cases.h"
#include "tests/procedural/support/synthetic_atlas.h"

namespace burl {
namespace {

using GlLineFieldTest = GlTest;

const Affine3 line_field_somewhere{Mat3d(1.7), Vec3d(0.3, -0.2, 0.1)};

Filter samples(int count) {
    Filter filter;
    filter.kind = FilterKind::supersample;
    filter.samples = count;
    return filter;
}

Filter corners(bool band_limit = false) {
    Filter filter;
    filter.kind = FilterKind::trapezoid2;
    filter.band_limit = band_limit;
    return filter;
}

template <class Pixel>
Image<Pixel> line_field_on_host(const SolidAtlas& solid, const Texture& texture,
                                const Filter& filter) {
    if constexpr (std::is_same_v<Pixel, Rgb8>)
        return synthesize_model<Rgb8>(solid, texture, line_field_somewhere, 1, filter,
                                      Kernel::direct);
    else if constexpr (std::is_same_v<Pixel, Rgb16>)
        return synthesize_model<Rgb16>(solid, texture, line_field_somewhere, 1, filter,
                                       Kernel::direct);
    else
        return synthesize_model<RgbF>(solid, texture, line_field_somewhere, 1, filter,
                                      Kernel::direct);
}

template <class Pixel>
void line_field_expect_equal(GlSynthesis& gl, const SolidAtlas& solid, const Texture& texture,
                             const Filter& filter) {
    Image<Pixel> drawn;
    gl.synthesize(solid, texture, line_field_somewhere, 1, drawn, filter);
    const Image<Pixel> expected = line_field_on_host<Pixel>(solid, texture, filter);
    EXPECT_EQ(differing(drawn, expected), 0u);
    EXPECT_GT(differing(line_field_on_host<Pixel>(solid, texture, {}), expected), 100u)
        << "nothing to filter";
}

NoiseTerm term_of(NoiseKind kind, std::uint32_t octaves) {
    NoiseTerm term;
    term.kind = kind;
    term.octaves = octaves;
    term.seed = 4;
    term.frequency = Vec3d(6.0, 7.0, 5.0);
    return term;
}

/// Jumps and kinks over a quadric and noise of several lattices.
Texture texture_of(std::vector<NoiseTerm> terms) {
    Texture texture;
    texture.quadric = {2.0, 0.1, -0.3, 0.2, 1.0, 0.5, -0.7, 0.4, 1.5, 0.1};
    texture.noise = std::move(terms);
    texture.colors.stops = {{0.1, {0, 0, 120}},   {0.4, {60, 120, 255}}, {0.5, {20, 120, 20}},
                            {0.5, {200, 90, 10}}, {0.6, {200, 90, 10}},  {0.9, {255, 255, 255}}};
    return texture;
}

const SyntheticAtlas coarse{64, 16, 0.4, 0.03};

/// A texture of all kinds of noise that have a stream kernel.
Texture streamed_texture() {
    return texture_of({term_of(NoiseKind::value, 2), term_of(NoiseKind::perlin, 1),
                       term_of(NoiseKind::simplex, 1)});
}

TEST_F(GlLineFieldTest, SupersampledTexturesHaveTheHostsBytes) {
    GlSynthesis gl(*context);
    const SolidAtlas solid = coarse.make(3);
    line_field_expect_equal<Rgb8>(gl, solid, streamed_texture(), samples(4));
    line_field_expect_equal<Rgb16>(gl, solid, streamed_texture(), samples(6));
    line_field_expect_equal<RgbF>(gl, solid, streamed_texture(), samples(5));
    EXPECT_EQ(gl.work().passes, 1);
}

TEST_F(GlLineFieldTest, TexturesByCornersHaveTheHostsBytes) {
    GlSynthesis gl(*context);
    line_field_expect_equal<RgbF>(gl, coarse.make(3), streamed_texture(), corners());
    EXPECT_EQ(gl.work().passes, 2);
}

TEST_F(GlLineFieldTest, OctavesWithoutAStreamHaveTheHostsBytes) {
    NoiseTerm ridged = term_of(NoiseKind::perlin, 1), worley = term_of(NoiseKind::worley, 1);
    ridged.shape = OctaveShape::ridged;
    worley.range = NoiseRange::unit;
    GlSynthesis gl(*context);
    const SolidAtlas solid = coarse.make(5);
    line_field_expect_equal<RgbF>(gl, solid, texture_of({ridged, worley}), samples(4));
    line_field_expect_equal<RgbF>(gl, solid, texture_of({worley, term_of(NoiseKind::value, 1)}),
                                  samples(3));
    line_field_expect_equal<RgbF>(gl, solid, texture_of({}), samples(3));
    line_field_expect_equal<RgbF>(gl, solid, texture_of({}), corners());
}

TEST_F(GlLineFieldTest, CornersOfOctavesWithoutAStreamHaveTheHostsBytes) {
    NoiseTerm ridged = term_of(NoiseKind::perlin, 1), worley = term_of(NoiseKind::worley, 1);
    ridged.shape = OctaveShape::ridged;
    GlSynthesis gl(*context);
    line_field_expect_equal<RgbF>(gl, coarse.make(5), texture_of({ridged, worley}), corners());
}

TEST_F(GlLineFieldTest, FadingOctavesHaveTheHostsBytes) {
    NoiseTerm ridged = term_of(NoiseKind::perlin, 2);
    ridged.shape = OctaveShape::ridged;
    Filter fading = samples(4);
    fading.band_limit = true;
    const Texture texture = texture_of({term_of(NoiseKind::value, 2), ridged});
    GlSynthesis gl(*context);
    const SolidAtlas solid = coarse.make(6);
    line_field_expect_equal<RgbF>(gl, solid, texture, fading);
    line_field_expect_equal<RgbF>(gl, solid, texture, corners(true));
    EXPECT_GT(differing(line_field_on_host<RgbF>(solid, texture, samples(4)),
                        line_field_on_host<RgbF>(solid, texture, fading)),
              1000u)
        << "nothing fades";
}

/// Far lines, and such as cross more cells than fixed point has.
TEST_F(GlLineFieldTest, FarAndFastLinesHaveTheHostsBytes) {
    GlSynthesis gl(*context);
    Texture texture = texture_of({term_of(NoiseKind::value, 2)});
    const SolidAtlas fast = SyntheticAtlas{64, 16, 1e5, 3e4}.make(9),
                     far = SyntheticAtlas{64, 16, 1e9, 0.03}.make(8);
    line_field_expect_equal<RgbF>(gl, fast, texture, samples(4));
    line_field_expect_equal<RgbF>(gl, fast, texture, corners());
    texture.quadric = {};
    line_field_expect_equal<RgbF>(gl, far, texture, samples(4));
    line_field_expect_equal<RgbF>(gl, far, texture, corners());
}

TEST_F(GlLineFieldTest, TilesAndEditsLeaveNoTrace) {
    GlSynthesisLimits limits;
    limits.tile = 24;
    limits.map_budget = 0;
    GlSynthesis gl(*context, limits);
    const SolidAtlas solid = coarse.make(3);
    Texture texture = texture_of({term_of(NoiseKind::value, 3)});
    line_field_expect_equal<Rgb8>(gl, solid, texture, samples(4));
    texture.noise[0].amplitude = 0.4;
    texture.quadric.a = -1.0;
    line_field_expect_equal<Rgb8>(gl, solid, texture, samples(9));
    EXPECT_EQ(gl.work().compile, 0.0);
}

TEST_F(GlLineFieldTest, Float32StaysNearTheHost) {
    GlSynthesisLimits limits;
    limits.float64 = false;
    GlSynthesis gl(*context, limits);
    const SolidAtlas solid = coarse.make(3);
    Texture texture = texture_of({term_of(NoiseKind::value, 3)});
    texture.colors.stops = {{0.0, {0, 0, 120}}, {0.5, {200, 90, 10}}};
    Image<RgbF> drawn;
    gl.synthesize(solid, texture, line_field_somewhere, 1, drawn, samples(4));
    const Image<RgbF> expected = line_field_on_host<RgbF>(solid, texture, samples(4));
    float largest = 0.0f;
    for (std::size_t i = 0; i < drawn.pixels().size(); ++i)
        largest = std::max(largest, std::abs(drawn.pixels()[i].r - expected.pixels()[i].r));
    EXPECT_LT(largest, 3e-5f);
    EXPECT_GT(differing(drawn, Image<RgbF>(64, 64)), 3000u);
}

template <class Pixel>
Image<Pixel> graph_on_host(const SolidAtlas& solid, const TextureGraph& graph,
                           const Filter& filter) {
    if constexpr (std::is_same_v<Pixel, Rgb8>)
        return synthesize_graph<Rgb8>(solid, graph, line_field_somewhere, filter, 1);
    else
        return synthesize_graph<RgbF>(solid, graph, line_field_somewhere, filter, 1);
}

template <class Pixel>
void line_field_expect_equal(GlSynthesis& gl, const SolidAtlas& solid, std::string_view json,
                             const Filter& filter) {
    const TextureGraph graph = graph_of(json);
    Image<Pixel> drawn;
    gl.synthesize(solid, graph, line_field_somewhere, 1, drawn, filter);
    const Image<Pixel> expected = graph_on_host<Pixel>(solid, graph, filter);
    EXPECT_EQ(differing(drawn, expected), 0u) << json;
    EXPECT_GT(differing(graph_on_host<Pixel>(solid, graph, {}), expected), 100u)
        << json << ": nothing to filter";
}

TEST_F(GlLineFieldTest, GraphsHaveTheHostsBytes) {
    GlSynthesisLimits limits;
    limits.tile = 40;
    GlSynthesis gl(*context, limits);
    const SolidAtlas solid = coarse.make(7);
    line_field_expect_equal<RgbF>(gl, solid, R"({"node": "checkerboard_3d"})", samples(5));
    EXPECT_EQ(gl.work().passes, 4);
    line_field_expect_equal<Rgb8>(gl, solid,
                                  R"({"node": "mix", "a": "#20ff40", "b": {"node": "marble"},
        "amount": {"node": "image", "file": "image.png"}})",
                                  samples(4));
    line_field_expect_equal<Rgb8>(
        gl, solid, R"({"node": "wrinkled", "kind": "simplex", "octaves": 2})", samples(4));
}

}  // namespace
}  // namespace burl
