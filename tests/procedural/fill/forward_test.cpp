// Textures filled by forward differences against the scalar reference and the other paths.
#include "procedural/fill/forward.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "procedural/fill/texels.h"
#include "procedural/model/octaves.h"
#include "tests/procedural/support/synthetic_atlas.h"

namespace burl {
namespace {

using enum ForwardPrecision;
const Affine3 twice{2.0 * Mat3d(1.0), Vec3d(0.25, 0.0, -1.0)};

Texture marble(Fade fade) {
    Texture texture;
    texture.quadric.i = 0.5, texture.quadric.a = 0.3;
    NoiseTerm term;
    term.fade = fade, term.amplitude = 0.5, term.frequency = Vec3d(2.0), term.octaves = 4;
    texture.noise = {term};
    texture.colors.stops = {{0.0, {244, 239, 230}}, {0.7, {200, 10, 30}}, {1.0, {59, 58, 64}}};
    return texture;
}

TEST(SynthesizeForward, IsTheReferenceToTwelveDigits) {
    for (const Fade fade : {Fade::linear, Fade::smooth, Fade::quintic})
        for (const double step : {0.0002, 0.005, 0.1}) {
            const SolidAtlas solid = SyntheticAtlas{60, 25, 3.0, step, true}.make(1);
            const Texture texture = marble(fade);
            const Image<double> field = forward_field_of_atlas(solid, texture, twice, float64, 1);
            const Image<double> exact =
                field_of_texels(solid, texture, twice, {PrecisionKind::float64, {}}, 1);
            for (std::size_t i = 0; i < field.pixels().size(); ++i)
                ASSERT_NEAR(field.pixels()[i], exact.pixels()[i],
                            4e-12 * (1.0 + std::abs(exact.pixels()[i])));
            EXPECT_NE(forward_field_of_atlas(solid, texture, twice, float32, 1), field);
        }
}

template <class Pixel>
void expect_colors_of_the_reference() {
    const SolidAtlas solid = SyntheticAtlas{60, 25, 3.0, 0.01, true}.make(2);
    const Texture texture = marble(Fade::smooth);
    const Image<Pixel> colors = synthesize_forward<Pixel>(solid, texture, twice, float64, 1);
    const Image<Pixel> exact =
        synthesize_texels<Pixel>(solid, texture, twice, {PrecisionKind::float64, {}}, {}, 1);
    // An f next to a step between two codes may fall on its other side.
    int different = 0;
    for (std::size_t i = 0; i < colors.pixels().size(); ++i)
        different += colors.pixels()[i] != exact.pixels()[i];
    EXPECT_LE(different, sizeof(Pixel) == sizeof(RgbF) ? 40 : 1);
}

TEST(SynthesizeForward, HasTheReferencesColors) {
    expect_colors_of_the_reference<Rgb8>();
    expect_colors_of_the_reference<Rgb16>();
    expect_colors_of_the_reference<RgbF>();
}

TEST(SynthesizeForward, GivesTheSameBytesForEveryThreadCount) {
    const tbb::global_control more(tbb::global_control::max_allowed_parallelism, 8);
    const SolidAtlas solid = SyntheticAtlas{200, 33, 3.0, 0.003, true}.make(4);
    const Texture texture = marble(Fade::quintic);
    const Image<double> one = forward_field_of_atlas(solid, texture, twice, float64, 1);
    for (const int threads : {2, 7, 0})
        EXPECT_EQ(forward_field_of_atlas(solid, texture, twice, float64, threads), one);
}

TEST(SynthesizeForward, LeavesTexelsWithoutOwnerTheColourOfFieldZero) {
    SolidAtlas solid;
    solid.size = 4;
    solid.row_begin.assign(5, 0);
    const Image<Rgb8> image =
        synthesize_forward<Rgb8>(solid, marble(Fade::linear), twice, float64, 1);
    for (const Rgb8& c : image.pixels()) EXPECT_EQ(c, (Rgb8{244, 239, 230}));
}

}  // namespace
}  // namespace burl
