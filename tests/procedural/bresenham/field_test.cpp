#include "procedural/bresenham/field.h"

#include <random>

#include <gtest/gtest.h>

namespace burl {
namespace {

using enum ForwardPrecision;

NoiseTerm value_term(Fade fade, std::uint32_t octaves = 1) {
    NoiseTerm term;
    term.fade = fade;
    term.octaves = octaves;
    return term;
}

/// Equations (23) and (24) of the paper, the latter with amplitudes 2^-i and frequencies 2^i.
Texture paper_wood() {
    Texture texture;
    texture.quadric.a = texture.quadric.h = 10.0;
    texture.noise = {value_term(Fade::linear)};
    texture.noise[0].frequency = {5.0, 5.0, 1.0};
    return texture;
}

Texture paper_marble() {
    Texture texture;
    texture.quadric.i = 0.5;
    texture.noise = {value_term(Fade::linear, 4)};
    return texture;
}

/// All three fades, oblique octaves and a full quadric.
Texture mixed() {
    Texture texture;
    texture.quadric = {0.3, -0.2, 0.1, 0.4, -0.5, 0.2, 0.6, 0.1, -0.3, 0.25};
    texture.noise = {value_term(Fade::linear, 2), value_term(Fade::smooth),
                     value_term(Fade::quintic)};
    texture.noise[0].frequency = {3, 2, 5};
    texture.noise[1].amplitude = -0.5;
    texture.noise[1].phase = {0.1, 0.2, 0.3};
    texture.noise[1].seed = 4;
    texture.noise[2].matrix = {{1, 2, 3, 0.5, -1, 1, 0, 0.25, 0, 2, 1, 0}};
    return texture;
}

double largest_error(const Texture& texture, const LatticeLine& solid,
                     const ForwardOptions& options) {
    const std::vector<Octave> octaves = expand_octaves(texture);
    std::vector<double> f(solid.count);
    forward_field(texture.quadric, octaves, solid, options, f.data());
    double worst = 0.0;
    for (std::size_t j = 0; j < solid.count; ++j) {
        const Vec3d s = solid.start + (solid.first + double(j)) * solid.step;
        const double exact = evaluate_field(texture.quadric, octaves, s);
        worst = std::max(worst, std::abs(f[j] - exact) / (1.0 + std::abs(exact)));
    }
    return worst;
}

TEST(ForwardField, IsTheWholeFunctionAlongALine) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    const auto vector = [&] { return Vec3d{unit(random), unit(random), unit(random)}; };
    for (const Texture& texture : {paper_wood(), paper_marble(), mixed()})
        for (int power = 13; power >= -1; --power)
            for (int i = 0; i < 3; ++i) {
                const LatticeLine line{3.0 * vector(), std::ldexp(1.0, -power) * vector(), 0.0,
                                       700};
                EXPECT_LE(largest_error(texture, line, {.precision = float32}), 4e-6) << power;
                EXPECT_LE(largest_error(texture, line, {.precision = float64}), 4e-12) << power;
                EXPECT_LE(largest_error(texture, line, {.precision = fixed64}), 4e-8) << power;
            }
}

TEST(ForwardField, KeepsItsBitsInFixedPointWhereTheQuinticBendsMost) {
    // A step in which coefficients are a hundred times what they add up to.
    Texture texture;
    texture.noise = {value_term(Fade::quintic)};
    texture.noise[0].seed = 2, texture.noise[0].frequency = Vec3d(32.0, -32.0, 0.9 * 32.0);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    const auto vector = [&] { return Vec3d{unit(random), unit(random), unit(random)}; };
    for (int i = 0; i < 40; ++i) {
        const LatticeLine line{vector(), vector() / 1024.0, 0.0, 200};
        EXPECT_LE(largest_error(texture, line, {.precision = fixed64}), 2e-9) << i;
    }
}

TEST(ForwardField, IsTheSumOfItsOctaves) {
    const Texture texture = mixed();
    const std::vector<Octave> octaves = expand_octaves(texture);
    for (const double pace : {0.5, 0.01, 0.0007}) {
        const LatticeLine line{{0.1, 0.2, 0.3}, {pace, -0.7 * pace, 0.4 * pace}, 0.0, 600};
        std::vector<double> whole(line.count), apart(line.count), either(line.count);
        forward_field(texture.quadric, octaves, line, {}, whole.data());
        forward_octaves(texture.quadric, octaves, line, {}, apart.data());
        forward_values(texture.quadric, octaves, line, {}, either.data());
        for (std::size_t j = 0; j < line.count; ++j)
            EXPECT_NEAR(apart[j], whole[j], 4e-12 * (1.0 + std::abs(whole[j])));
        EXPECT_EQ(either, pace < 0.001 ? whole : apart);
    }
}

TEST(ForwardField, OfAQuadricAloneIsExactForDyadicNumbers) {
    Texture texture;
    texture.quadric = {1, 0.5, 0, 0.25, -2, 0, 0, 4, 0, 1};
    const LatticeLine line{{0.5, -0.25, 1.0}, {0.125, 0.25, -0.5}, 0.0, 9000};
    EXPECT_EQ(largest_error(texture, line, {}), 0.0);
}

TEST(ForwardField, DoesNotDependOnWhereTheLineIsCut) {
    const Texture texture = mixed();
    const std::vector<Octave> octaves = expand_octaves(texture);
    for (const ForwardPrecision precision : {float32, float64, fixed64})
        for (const double pace : {0.3, 0.01, 0.0007}) {
            const LatticeLine line{{0.1, 0.2, 0.3}, {pace, -0.7 * pace, 0.4 * pace}, 0.0, 600};
            std::vector<double> whole(line.count), part(line.count);
            forward_field(texture.quadric, octaves, line, {precision, 0}, whole.data());
            for (std::size_t first = 0; first < line.count; first += 37) {
                const std::size_t count = std::min<std::size_t>(37, line.count - first);
                forward_field(texture.quadric, octaves,
                              {line.start, line.step, double(first), count}, {precision, 0},
                              part.data() + first);
            }
            EXPECT_EQ(whole, part);
        }
}

TEST(ForwardField, HoldsAnySizeOfValueInFixedPoint) {
    Texture texture = paper_marble();
    for (const double size : {1e-30, 1e-3, 1e12}) {
        texture.quadric = {};
        texture.quadric.a = size;
        texture.quadric.j = -size;
        texture.noise[0].amplitude = size;
        const std::vector<Octave> octaves = expand_octaves(texture);
        const LatticeLine line{{0.1, 0.2, 0.3}, {0.01, 0.007, 0.003}, 0.0, 200};
        std::vector<double> f(line.count);
        forward_field(texture.quadric, octaves, line, {fixed64, 0}, f.data());
        for (std::size_t j = 0; j < line.count; ++j) {
            const double exact =
                evaluate_field(texture.quadric, octaves, line.start + double(j) * line.step);
            EXPECT_NEAR(f[j], exact, 1e-12 * size);
        }
    }
}

TEST(ForwardField, CountsTheCellsOfThePapersMarbleCube) {
    // A face from (0, 0) to (2, 2) shows 2^2 + 4^2 + 8^2 + 16^2 cells of four octaves, of which the
    // paper counts the finest; a scan line along it sees 2 + 4 + 8 + 16 and starts anew at each of
    // the finest's 16 planes.
    const Texture texture = paper_marble();
    const std::vector<Octave> octaves = expand_octaves(texture);
    std::vector<double> f(256);
    const ForwardCounts counts = forward_field(
        texture.quadric, octaves, {{0.0, 0.7, 1.0}, {2.0 / 256, 0.0, 0.0}, 0.0, 256}, {}, f.data());
    EXPECT_EQ(counts, (ForwardCounts{30, 16, 0}));
}

TEST(ForwardField, SaysWhatHasNoPolynomial) {
    Texture texture = mixed();
    EXPECT_EQ(no_forward_form(expand_octaves(texture)), "");
    texture.noise[1].shape = OctaveShape::absolute;
    EXPECT_NE(no_forward_form(expand_octaves(texture)), "");
    texture.noise[1] = NoiseTerm();
    texture.noise[1].kind = NoiseKind::simplex;
    EXPECT_NE(no_forward_form(expand_octaves(texture)), "");
}

}  // namespace
}  // namespace burl
